#pragma once

#include <QObject>
#include <QPoint>
#include <QTimer>
#include <functional>
#include <optional>
#include <string>

namespace rviz {
class DisplayContext;
class RenderPanel;
}  // namespace rviz

namespace hexapod {

/// Follows the mouse over rviz's view, and tells where on the floor of a frame it points.
class PointerWatch : public QObject {
 public:
  struct Place {
    double x_m = 0.0;  ///< in the frame, at z = 0
    double y_m = 0.0;
    QPoint on_screen;
  };
  /// None: it does not point at the floor, has left, or a button is pressed. In Qt's thread, at
  /// most every 50 ms.
  using Tell = std::function<void(const std::optional<Place>& place)>;

  /// Both must outlive it.
  PointerWatch(rviz::DisplayContext& context, rviz::RenderPanel& view, std::string frame,
               Tell tell);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::optional<Place> placeBelow() const;

  rviz::DisplayContext& context_;
  rviz::RenderPanel& view_;
  const std::string frame_;
  const Tell tell_;
  QPoint mouse_;  // in the view
  bool points_ = false;
  QTimer timer_;
};

}  // namespace hexapod
