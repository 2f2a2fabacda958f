#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <vector>

#include "gait/genome.h"
#include "gait/outcome.h"
#include "repertoire/entry.h"
#include "repertoire/repertoire.h"

namespace hexapod {

/// Rows of the structured arrays that Python sees; the fields are its field names.
struct OutcomeRow {
  std::int32_t verdict;  // a Verdict
  double x_m, y_m, yaw_rad, cost;
};

struct EntryRow {
  std::int64_t id;
  double x_m, y_m, yaw_rad, orientation_error_rad, cost;
  std::int64_t evaluation;
  double executed_x_m, executed_y_m, executed_yaw_rad, spread_m, spread_rad;  // NaN until validated
  std::int32_t trials, falls;                                                 // 0 until validated
};

struct HistoryArrayRow {
  std::int64_t evaluations, archive_size;
  double sparseness_m, median_orientation_error_rad, max_reach_m, elapsed_s;
};

/// Makes the rows known to NumPy, and the verdicts and `outcome_dtype` to Python. Before any other.
void registerArrays(pybind11::module& module);

/// Genomes of shape (n, genes), of any integer type. Throws std::invalid_argument for another shape
/// or type, and naming the first level that is not 0 .. 255.
std::vector<Genome> genomesFrom(const pybind11::array& array);

/// Shape (n, genes), uint8; (0, gene_count) without any.
pybind11::array_t<std::uint8_t> arrayOf(const std::vector<Genome>& genomes, std::size_t gene_count);

/// Outcomes of shape (n,), of outcome_dtype. Throws std::invalid_argument for anything else.
std::vector<Outcome> outcomesFrom(const pybind11::array& array);
pybind11::array_t<OutcomeRow> arrayOf(const std::vector<Outcome>& outcomes);

pybind11::array_t<EntryRow> arrayOf(const std::vector<Entry>& entries);
std::vector<Genome> genomesOf(const std::vector<Entry>& entries);

pybind11::array_t<HistoryArrayRow> arrayOf(const std::vector<HistoryRow>& history);

}  // namespace hexapod
