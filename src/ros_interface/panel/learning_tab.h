#pragma once

#include <QLabel>
#include <QWidget>
#include <functional>

#include "ros_interface/panel/ask_buttons.h"
#include "ros_interface/panel/curve_view.h"
#include "ros_interface/panel/panel_model.h"

namespace hexapod {

/// Start, pause, save; both learning curves.
class LearningTab : public QWidget {
 public:
  LearningTab(const std::function<void(Ask)>& ask, QWidget* parent);

  void show(const PanelModel& model);

 private:
  QLabel* words_;
  AskButtons* buttons_;
  CurveView* sparseness_;
  CurveView* error_;
};

}  // namespace hexapod
