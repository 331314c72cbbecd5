// The walk of a camera through points of view, as a person would do it: it turns towards where it goes, walks
// there looking ahead, slows down for corners, turns to the point of view, and stays to look. Metres,
// seconds, radians.
#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "model/camera.h"

namespace idap {

// A smooth curve through all points, as points about spacing apart: a centripetal Catmull-Rom spline, which
// has neither loops nor cusps @cite yuksel2011catmull. Fewer than two distinct points give just those.
std::vector<Vec2> smoothCurve(const std::vector<Vec2>& points, double spacing = 0.02);

struct WalkPace {
  double speed = 1.2;             // m/s
  double acceleration = 0.9;      // m/s2
  double turn = 0.9;              // rad/s, the most in yaw and in pitch
  double turnAcceleration = 1.6;  // rad/s2
  double lookAhead = 0.9;         // m along the way
  double pause = 1;               // s at each point of view
  double walkingEye = 1.6;        // m above the floor between points of view that are higher or lower
};

// One uninterrupted take.
class CameraPath {
 public:
  static constexpr double kStep = 1.0 / 200;  // s between the poses

  // floor: world height that the walk is on.
  CameraPath(const Camera& first, double floor, const WalkPace& pace);
  // Walks on along the curve, which begins at the point of view before.
  void walkTo(const Camera& next, const std::vector<Vec2>& curve);
  // Stays where it is.
  void stay(double seconds);

  const std::vector<Camera>& poses() const { return poses_; }
  double seconds() const { return static_cast<double>(poses_.size()) * kStep; }

 private:
  void keep(Vec3 eye, double yaw, double pitch, double fieldOfView);

  double floor_;
  WalkPace pace_;
  std::vector<Camera> poses_;
  double yawRate_ = 0, pitchRate_ = 0;
};

}  // namespace idap
