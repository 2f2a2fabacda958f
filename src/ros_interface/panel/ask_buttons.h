#pragma once

#include <QPushButton>
#include <QWidget>
#include <functional>
#include <utility>
#include <vector>

#include "ros_interface/panel/panel_model.h"

namespace hexapod {

/// A row of buttons that ask for something, each of use while the model offers it.
class AskButtons : public QWidget {
 public:
  struct Button {
    Ask ask;
    const char* name;  ///< of the object, for who looks for it
    const char* text;
    const char* tip;
  };

  AskButtons(const std::vector<Button>& buttons, const std::function<void(Ask)>& ask,
             QWidget* parent);

  void show(const PanelModel& model);

 private:
  std::vector<std::pair<Ask, QPushButton*>> buttons_;
};

}  // namespace hexapod
