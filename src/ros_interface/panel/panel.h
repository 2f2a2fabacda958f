#pragma once

#include <rviz/panel.h>

#include <QLabel>
#include <QTabWidget>
#include <QTableWidget>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ros_interface/panel/learning_tab.h"
#include "ros_interface/panel/panel_link.h"
#include "ros_interface/panel/panel_model.h"
#include "ros_interface/panel/pointer_watch.h"
#include "ros_interface/panel/repertoire_tab.h"
#include "ros_interface/panel/walking_tab.h"

namespace hexapod {

/// The panel for rviz: learning, walking, the repertoire, and how every node is. What is asked is
/// answered in the line at its foot. The entry below the mouse in rviz's view is told beside the
/// mouse. ROS must have been started.
class Panel : public rviz::Panel {
 public:
  explicit Panel(QWidget* parent = nullptr);
  ~Panel() override;

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 protected:
  bool event(QEvent* event) override;

 private:
  void point(const std::optional<PointerWatch::Place>& place);
  void makeNodeTable();
  void setFilter(const EntryFilter& filter);
  /// Shows what the model says, soon; many changes at once are shown once.
  void refreshSoon();
  void refresh();
  void refreshNodes();
  void tell(const std::string& sentence);

  PanelModel model_;
  QTabWidget* tabs_;
  LearningTab* learning_;
  WalkingTab* walking_;
  RepertoireTab* repertoire_;
  QTableWidget* nodes_;
  QLabel* answer_;
  QTimer refresh_timer_;
  QTimer look_timer_;
  std::unique_ptr<PanelLink> link_;
  std::unique_ptr<PointerWatch> pointer_;  // in rviz only
};

}  // namespace hexapod
