#include "ros_interface/panel/entry_table.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/pose2.h"

namespace hexapod {
namespace {

struct Column {
  const char* title;
  int decimals;
  double (*value)(const PanelModel::EntryLine&);
};

using Line = PanelModel::EntryLine;

const std::array<Column, 6>& columns() {
  static const std::array<Column, 6> all = {{
      {"id", 0, [](const Line& line) { return static_cast<double>(line.id); }},
      {"x [m]", 2, [](const Line& line) { return line.end.x_m; }},
      {"y [m]", 2, [](const Line& line) { return line.end.y_m; }},
      {"yaw [deg]", 0, [](const Line& line) { return line.end.yaw_rad / kDegree; }},
      {"error [deg]", 2, [](const Line& line) { return line.error_deg; }},
      {"spread [cm]", 2,
       [](const Line& line) {
         return line.spread_cm.value_or(std::numeric_limits<double>::infinity());
       }},
  }};
  return all;
}

}  // namespace

void EntryTable::show(std::vector<Line> lines) {
  beginResetModel();
  lines_ = std::move(lines);
  endResetModel();
}

int EntryTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(lines_.size());
}

int EntryTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(columns().size());
}

QVariant EntryTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Column& column = columns().at(static_cast<std::size_t>(index.column()));
  const double value = column.value(lines_.at(static_cast<std::size_t>(index.row())));
  if (role == Qt::UserRole) return value;
  if (role == Qt::TextAlignmentRole) return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  return std::isfinite(value) ? QString::number(value, 'f', column.decimals) : QString("-");
}

QVariant EntryTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return columns().at(static_cast<std::size_t>(section)).title;
}

}  // namespace hexapod
