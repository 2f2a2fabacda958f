#include "ros_interface/panel/curve_view.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <utility>

namespace hexapod {
namespace {

constexpr int kSmallestHeight = 90;
constexpr double kHeadroom = 1.1;
const QColor kCurveColor(26, 95, 180);

}  // namespace

CurveView::CurveView(QString name, QString unit, QWidget* parent)
    : QWidget(parent), name_(std::move(name)), unit_(std::move(unit)) {
  setMinimumHeight(kSmallestHeight);
}

void CurveView::show(std::vector<QPointF> points) {
  points_ = std::move(points);
  update();
}

void CurveView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int line = fontMetrics().height();
  const QRect plot = rect().adjusted(4, line + 4, -4, -line - 4);
  const QRect above(plot.left(), 0, plot.width(), line + 2);
  const QRect below(plot.left(), plot.bottom() + 2, plot.width(), line + 2);
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(plot);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(above, Qt::AlignLeft, name_);
  if (points_.empty()) {
    painter.drawText(plot, Qt::AlignCenter, "nothing yet");
    return;
  }
  const QPointF last = points_.back();
  painter.drawText(above, Qt::AlignRight, QString("%1 %2").arg(last.y(), 0, 'f', 2).arg(unit_));
  painter.drawText(below, Qt::AlignRight, QString("%1 candidates").arg(last.x(), 0, 'f', 0));
  const double top =
      kHeadroom * std::max_element(points_.begin(), points_.end(), [](auto a, auto b) {
                    return a.y() < b.y();
                  })->y();
  painter.drawText(below, Qt::AlignLeft, QString("0 to %1 %2").arg(top, 0, 'f', 2).arg(unit_));
  if (top <= 0.0 || last.x() <= 0.0) return;
  QPolygonF curve;
  for (const QPointF& point : points_) {
    curve << QPointF(plot.left() + plot.width() * point.x() / last.x(),
                     plot.bottom() - plot.height() * point.y() / top);
  }
  painter.setPen(QPen(kCurveColor, 2.0));
  painter.drawPolyline(curve);
}

}  // namespace hexapod
