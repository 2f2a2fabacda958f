#pragma once

#include <QPointF>
#include <QString>
#include <QWidget>
#include <vector>

namespace hexapod {

/// One curve that grows, with its name, its newest value and the ends of its axes; y begins at 0.
class CurveView : public QWidget {
 public:
  /// `unit` goes with y.
  CurveView(QString name, QString unit, QWidget* parent);

  /// Points with x growing.
  void show(std::vector<QPointF> points);

 protected:
  void paintEvent(QPaintEvent* event) override;
  QSize sizeHint() const override { return {260, 130}; }

 private:
  const QString name_;
  const QString unit_;
  std::vector<QPointF> points_;
};

}  // namespace hexapod
