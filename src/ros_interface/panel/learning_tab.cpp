#include "ros_interface/panel/learning_tab.h"

#include <QVBoxLayout>

namespace hexapod {

LearningTab::LearningTab(const std::function<void(Ask)>& ask, QWidget* parent)
    : QWidget(parent),
      words_(new QLabel(this)),
      buttons_(new AskButtons({{Ask::kStart, "start", "Start", "Begin to learn, or go on"},
                               {Ask::kPause, "pause", "Pause", "Pause after what is under way"},
                               {Ask::kSave, "save", "Save", "Write the file now"}},
                              ask, this)),
      sparseness_(new CurveView("sparseness", "cm", this)),
      error_(new CurveView("orientation error, median", "deg", this)) {
  words_->setWordWrap(true);
  words_->setObjectName("learning_words");
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* column = new QVBoxLayout(this);
  column->addWidget(buttons_);
  column->addWidget(words_);
  column->addWidget(sparseness_, 1);
  column->addWidget(error_, 1);
}

void LearningTab::show(const PanelModel& model) {
  buttons_->show(model);
  words_->setText(QString::fromStdString(model.learningSentence()));
  std::vector<QPointF> sparseness;
  std::vector<QPointF> error;
  for (const PanelModel::CurvePoint& point : model.curve()) {
    sparseness.emplace_back(point.evaluations, point.sparseness_cm);
    error.emplace_back(point.evaluations, point.error_deg);
  }
  sparseness_->show(std::move(sparseness));
  error_->show(std::move(error));
}

}  // namespace hexapod
