#include "ros_interface/panel/ask_buttons.h"

#include <QHBoxLayout>

namespace hexapod {

AskButtons::AskButtons(const std::vector<Button>& buttons, const std::function<void(Ask)>& ask,
                       QWidget* parent)
    : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  for (const Button& button : buttons) {
    auto* widget = new QPushButton(button.text, this);
    widget->setObjectName(button.name);
    widget->setToolTip(button.tip);
    widget->setMinimumWidth(40);
    const Ask wish = button.ask;
    connect(widget, &QPushButton::clicked, [ask, wish] { ask(wish); });
    row->addWidget(widget);
    buttons_.emplace_back(wish, widget);
  }
}

void AskButtons::show(const PanelModel& model) {
  for (const auto& [ask, button] : buttons_) button->setEnabled(model.offers(ask));
}

}  // namespace hexapod
