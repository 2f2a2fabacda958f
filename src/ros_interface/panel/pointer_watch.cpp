#include "ros_interface/panel/pointer_watch.h"

#include <OgrePlane.h>
#include <OgreQuaternion.h>
#include <OgreVector3.h>
#include <ros/time.h>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/geometry.h>
#include <rviz/render_panel.h>

#include <QMouseEvent>
#include <utility>

namespace hexapod {
namespace {

constexpr int kPeriod_ms = 50;

}  // namespace

PointerWatch::PointerWatch(rviz::DisplayContext& context, rviz::RenderPanel& view,
                           std::string frame, Tell tell)
    : context_(context), view_(view), frame_(std::move(frame)), tell_(std::move(tell)) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout,
          [this] { tell_(points_ ? placeBelow() : std::optional<Place>()); });
  view.installEventFilter(this);
}

bool PointerWatch::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  if (type == QEvent::MouseMove) {
    const auto* move = static_cast<QMouseEvent*>(event);
    mouse_ = move->pos();
    points_ = move->buttons() == Qt::NoButton;
  } else if (type == QEvent::Leave || type == QEvent::MouseButtonPress) {
    points_ = false;
  } else {
    return QObject::eventFilter(watched, event);
  }
  if (!timer_.isActive()) timer_.start(kPeriod_ms);
  return false;  // rviz's tools get it, too
}

std::optional<PointerWatch::Place> PointerWatch::placeBelow() const {
  Ogre::Vector3 origin;
  Ogre::Quaternion turn;
  if (!context_.getFrameManager()->getTransform(frame_, ros::Time(), origin, turn)) {
    return std::nullopt;
  }
  Ogre::Plane floor(turn * Ogre::Vector3::UNIT_Z, origin);
  Ogre::Vector3 found;
  if (!rviz::getPointOnPlaneFromWindowXY(view_.getViewport(), floor, mouse_.x(), mouse_.y(),
                                         found)) {
    return std::nullopt;
  }
  const Ogre::Vector3 here = turn.Inverse() * (found - origin);
  return Place{here.x, here.y, view_.mapToGlobal(mouse_)};
}

}  // namespace hexapod
