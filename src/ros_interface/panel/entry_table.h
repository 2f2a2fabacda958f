#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "ros_interface/panel/panel_model.h"

namespace hexapod {

/// Entries as the rows of a table: id, end pose, orientation error, spread. The number behind a
/// cell, to sort by, has the role Qt::UserRole.
class EntryTable : public QAbstractTableModel {
 public:
  using QAbstractTableModel::QAbstractTableModel;

  void show(std::vector<PanelModel::EntryLine> lines);
  std::int64_t idAt(int row) const { return lines_.at(static_cast<std::size_t>(row)).id; }

  int rowCount(const QModelIndex& parent) const override;
  int columnCount(const QModelIndex& parent) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<PanelModel::EntryLine> lines_;
};

}  // namespace hexapod
