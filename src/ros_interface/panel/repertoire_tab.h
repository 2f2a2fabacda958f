#pragma once

#include <rviz/config.h>

#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QWidget>
#include <cstdint>
#include <functional>
#include <string>

#include "ros_interface/panel/entry_table.h"
#include "ros_interface/panel/panel_model.h"

namespace hexapod {

/// Load a file; filter by error and spread; the list of entries. A row that is selected is shown in
/// rviz, one that is clicked twice is played.
class RepertoireTab : public QWidget {
 public:
  struct Orders {
    std::function<void(const std::string& file)> load;
    std::function<void(const EntryFilter&)> filter;
    std::function<void(std::int64_t entry_id, bool play)> choose;
  };

  RepertoireTab(Orders orders, QWidget* parent);

  void show(const PanelModel& model);
  void save(rviz::Config config) const;
  /// Sets the filter, too.
  void load(const rviz::Config& config);

 private:
  QWidget* makeFileRow();
  QWidget* makeFilterRow();
  void makeTable();
  EntryFilter filter() const;
  void chooseAt(const QModelIndex& index, bool play);

  const Orders orders_;
  QLineEdit* file_;
  QPushButton* load_;
  QDoubleSpinBox* max_error_deg_;
  QDoubleSpinBox* max_spread_cm_;
  QLabel* words_;
  EntryTable* entries_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_;
  int shown_revision_ = -1;
};

}  // namespace hexapod
