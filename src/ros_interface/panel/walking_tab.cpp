#include "ros_interface/panel/walking_tab.h"

#include <QFormLayout>
#include <QVBoxLayout>
#include <cmath>

#include "geometry/pose2.h"
#include "ros_interface/common/conversions.h"
#include "ros_interface/common/names.h"

namespace hexapod {
namespace {

constexpr double kFarthest_m = 1000.0;
constexpr double kStep_m = 0.1;
constexpr double kStep_deg = 15.0;

QDoubleSpinBox* spinBox(const char* name, double most, double step, QWidget* parent) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(name);
  box->setRange(-most, most);
  box->setSingleStep(step);
  return box;
}

}  // namespace

WalkingTab::WalkingTab(const Orders& orders, QWidget* parent)
    : QWidget(parent),
      words_(new QLabel(this)),
      first_row_(new AskButtons({{Ask::kArm, "arm", "Arm", "Stand up, ready to walk"},
                                 {Ask::kStand, "stand", "Stand", "To the neutral pose"},
                                 {Ask::kSit, "sit", "Sit", "Sit down and disarm"}},
                                orders.ask, this)),
      second_row_(new AskButtons(
          {{Ask::kStop, "stop", "STOP", "Send no command any more; Arm is the way back"},
           {Ask::kCancel, "cancel", "Cancel", "Break the walk off and come to rest"}},
          orders.ask, this)),
      x_m_(spinBox("x_m", kFarthest_m, kStep_m, this)),
      y_m_(spinBox("y_m", kFarthest_m, kStep_m, this)),
      yaw_deg_(spinBox("yaw_deg", 180.0, kStep_deg, this)),
      frame_(new QLineEdit(names::kOdomFrame, this)),
      go_(new QPushButton("Go", this)) {
  x_m_->setValue(1.0);
  frame_->setObjectName("frame");
  frame_->setToolTip("Frame of the goal; base_footprint: from where the robot stands");
  go_->setObjectName("go");
  words_->setWordWrap(true);
  words_->setObjectName("walking_words");
  connect(go_, &QPushButton::clicked, [this, orders] { orders.go(goal()); });
  auto* form = new QFormLayout;
  form->addRow("x, forward [m]", x_m_);
  form->addRow("y, left [m]", y_m_);
  form->addRow("heading [deg]", yaw_deg_);
  form->addRow("in frame", frame_);
  auto* column = new QVBoxLayout(this);
  column->addWidget(first_row_);
  column->addWidget(second_row_);
  column->addLayout(form);
  column->addWidget(go_);
  column->addWidget(words_);
  column->addStretch(1);
}

geometry_msgs::PoseStamped WalkingTab::goal() const {
  geometry_msgs::PoseStamped goal;
  goal.header.frame_id = frame_->text().trimmed().toStdString();
  goal.pose = toPoseMsg(Pose2{x_m_->value(), y_m_->value(), yaw_deg_->value() * kDegree});
  return goal;
}

void WalkingTab::show(const PanelModel& model) {
  first_row_->show(model);
  second_row_->show(model);
  go_->setEnabled(model.offers(Ask::kGo));
  words_->setText(QString::fromStdString(model.walkingSentence()));
}

void WalkingTab::save(rviz::Config config) const {
  config.mapSetValue("Goal X", x_m_->value());
  config.mapSetValue("Goal Y", y_m_->value());
  config.mapSetValue("Goal Heading", yaw_deg_->value());
  config.mapSetValue("Goal Frame", frame_->text());
}

void WalkingTab::load(const rviz::Config& config) {
  const auto fill = [&config](const char* key, QDoubleSpinBox* box) {
    QVariant value;
    if (config.mapGetValue(key, &value)) box->setValue(value.toDouble());
  };
  fill("Goal X", x_m_);
  fill("Goal Y", y_m_);
  fill("Goal Heading", yaw_deg_);
  QString frame;
  if (config.mapGetString("Goal Frame", &frame)) frame_->setText(frame);
}

}  // namespace hexapod
