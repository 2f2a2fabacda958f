#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <rviz/config.h>

#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QWidget>
#include <functional>

#include "ros_interface/panel/ask_buttons.h"
#include "ros_interface/panel/panel_model.h"

namespace hexapod {

/// Arm, stop, stand, sit, cancel; a goal to go to.
class WalkingTab : public QWidget {
 public:
  struct Orders {
    std::function<void(Ask)> ask;
    std::function<void(const geometry_msgs::PoseStamped&)> go;
  };

  WalkingTab(const Orders& orders, QWidget* parent);

  void show(const PanelModel& model);
  void save(rviz::Config config) const;
  void load(const rviz::Config& config);

 private:
  geometry_msgs::PoseStamped goal() const;

  QLabel* words_;
  AskButtons* first_row_;
  AskButtons* second_row_;
  QDoubleSpinBox* x_m_;
  QDoubleSpinBox* y_m_;
  QDoubleSpinBox* yaw_deg_;
  QLineEdit* frame_;
  QPushButton* go_;
};

}  // namespace hexapod
