#pragma once

#include <map>
#include <string>
#include <vector>

#include "evolution/target.h"
#include "study/study_options.h"

namespace hexapod {

/// Facts of a run by name, and the options it was made with as "option.<name>".
using RunFacts = std::map<std::string, std::string>;

/// The options in the form of RunFacts.
RunFacts factsOf(StudyOptions options);

/// Writes facts as the CSV file run.csv. Throws std::runtime_error naming a file that cannot be
/// written.
void writeRunFacts(const std::string& file, const RunFacts& facts);

/// Reads what writeRunFacts() wrote. Throws std::runtime_error naming a file that cannot be read.
RunFacts readRunFacts(const std::string& file);

/// Writes targets as CSV, x_m,y_m. Throws as writeRunFacts().
void writeTargets(const std::string& file, const std::vector<Target>& targets);

/// Writes the theoretical sparseness of 50, 100, .. 400 targets (figure 5, left), spread as the
/// control experiments' are, as CSV: targets,sparseness_m. Throws as writeRunFacts().
void writeTheoreticalSparseness(const std::string& file, const StudyOptions& options);

}  // namespace hexapod
