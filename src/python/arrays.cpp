#include "python/arrays.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace py = pybind11;

namespace hexapod {
namespace {

/// A new one-dimensional array with row(value) of each value.
template <typename Row, typename Value, typename MakeRow>
py::array_t<Row> arrayOfRows(const std::vector<Value>& values, const MakeRow& row) {
  py::array_t<Row> array(static_cast<py::ssize_t>(values.size()));
  std::transform(values.begin(), values.end(), array.mutable_data(), row);
  return array;
}

EntryRow rowOf(const Entry& entry) {
  const Pose2& end = entry.end_pose;
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  EntryRow row{entry.id,
               end.x_m,
               end.y_m,
               end.yaw_rad,
               entry.orientationErrorRad(),
               entry.cost,
               entry.evaluation,
               kUnknown,
               kUnknown,
               kUnknown,
               kUnknown,
               kUnknown,
               0,
               0};
  if (!entry.execution) return row;
  const Execution& execution = *entry.execution;
  row.executed_x_m = execution.mean.x_m;
  row.executed_y_m = execution.mean.y_m;
  row.executed_yaw_rad = execution.mean.yaw_rad;
  row.spread_m = execution.spread_m;
  row.spread_rad = execution.spread_rad;
  row.trials = execution.trials;
  row.falls = execution.falls;
  return row;
}

}  // namespace

void registerArrays(py::module& module) {
  PYBIND11_NUMPY_DTYPE(OutcomeRow, verdict, x_m, y_m, yaw_rad, cost);
  PYBIND11_NUMPY_DTYPE(EntryRow, id, x_m, y_m, yaw_rad, orientation_error_rad, cost, evaluation,
                       executed_x_m, executed_y_m, executed_yaw_rad, spread_m, spread_rad, trials,
                       falls);
  PYBIND11_NUMPY_DTYPE(HistoryArrayRow, evaluations, archive_size, sparseness_m,
                       median_orientation_error_rad, max_reach_m, elapsed_s);
  module.attr("outcome_dtype") = py::dtype::of<OutcomeRow>();
  module.attr("WALKED") = static_cast<int>(Verdict::kWalked);
  module.attr("FELL") = static_cast<int>(Verdict::kFell);
  module.attr("SELF_COLLIDED") = static_cast<int>(Verdict::kSelfCollided);
  module.attr("DIVERGED") = static_cast<int>(Verdict::kDiverged);
}

std::vector<Genome> genomesFrom(const py::array& array) {
  const char kind = array.dtype().kind();
  if (array.ndim() != 2 || (kind != 'i' && kind != 'u')) {
    throw std::invalid_argument("Genomes are an array of shape (n, genes) of integers; found " +
                                std::to_string(array.ndim()) + " dimensions of kind '" +
                                std::string(1, kind) + "'.");
  }
  const auto levels = py::array_t<std::int64_t, py::array::forcecast>(array);
  const auto level = levels.unchecked<2>();
  std::vector<Genome> genomes(static_cast<std::size_t>(level.shape(0)));
  for (py::ssize_t i = 0; i < level.shape(0); ++i) {
    for (py::ssize_t gene = 0; gene < level.shape(1); ++gene) {
      const std::int64_t value = level(i, gene);
      if (value < 0 || value > std::numeric_limits<std::uint8_t>::max()) {
        throw std::invalid_argument("Gene " + std::to_string(gene) + " of genome " +
                                    std::to_string(i) + " is " + std::to_string(value) +
                                    ": expected a level of 0 or more, below the genotype's.");
      }
      genomes[static_cast<std::size_t>(i)].push_back(static_cast<std::uint8_t>(value));
    }
  }
  return genomes;
}

py::array_t<std::uint8_t> arrayOf(const std::vector<Genome>& genomes, std::size_t gene_count) {
  py::array_t<std::uint8_t> array(std::vector<py::ssize_t>{static_cast<py::ssize_t>(genomes.size()),
                                                           static_cast<py::ssize_t>(gene_count)});
  std::uint8_t* next = array.mutable_data();
  for (const Genome& genome : genomes) next = std::copy(genome.begin(), genome.end(), next);
  return array;
}

std::vector<Outcome> outcomesFrom(const py::array& array) {
  if (array.ndim() != 1 || !array.dtype().equal(py::dtype::of<OutcomeRow>())) {
    throw std::invalid_argument(
        "Outcomes are an array of shape (n,) of outcome_dtype, as outcomes() makes it; found " +
        std::to_string(array.ndim()) + " dimensions of " +
        py::str(array.dtype()).cast<std::string>() + ".");
  }
  const auto rows = array.unchecked<OutcomeRow, 1>();
  std::vector<Outcome> outcomes;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    const OutcomeRow& row = rows(i);
    if (row.verdict < static_cast<int>(Verdict::kWalked) ||
        row.verdict > static_cast<int>(Verdict::kDiverged)) {
      throw std::invalid_argument("The verdict of outcome " + std::to_string(i) + " is " +
                                  std::to_string(row.verdict) +
                                  ": expected WALKED, FELL, SELF_COLLIDED or DIVERGED.");
    }
    outcomes.push_back(
        {static_cast<Verdict>(row.verdict), {row.x_m, row.y_m, row.yaw_rad}, row.cost});
  }
  return outcomes;
}

py::array_t<OutcomeRow> arrayOf(const std::vector<Outcome>& outcomes) {
  return arrayOfRows<OutcomeRow>(outcomes, [](const Outcome& outcome) {
    const Pose2& end = outcome.end_pose;
    return OutcomeRow{static_cast<std::int32_t>(outcome.verdict), end.x_m, end.y_m, end.yaw_rad,
                      outcome.cost};
  });
}

py::array_t<EntryRow> arrayOf(const std::vector<Entry>& entries) {
  return arrayOfRows<EntryRow>(entries, rowOf);
}

std::vector<Genome> genomesOf(const std::vector<Entry>& entries) {
  std::vector<Genome> genomes;
  for (const Entry& entry : entries) genomes.push_back(entry.genome);
  return genomes;
}

py::array_t<HistoryArrayRow> arrayOf(const std::vector<HistoryRow>& history) {
  return arrayOfRows<HistoryArrayRow>(history, [](const HistoryRow& row) {
    return HistoryArrayRow{row.evaluations,  row.archive_size,
                           row.sparseness_m, row.median_orientation_error_rad,
                           row.max_reach_m,  row.elapsed_s};
  });
}

}  // namespace hexapod
