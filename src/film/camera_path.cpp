#include "film/camera_path.h"

#include <algorithm>
#include <cmath>

namespace idap {

namespace {

constexpr double kWalkingPitch = 0.06;  // radians; people look a little down where they walk
constexpr double kArrival = 1.3;        // m before a point of view from where it is turned to
constexpr double kLongest = 600;        // s, of one leg; a walk that never arrives would be an error in here

double turned(double angle) { return std::remainder(angle, 2 * kPi); }

double smooth(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// One step of an angle towards where it should be, with bounded speed and acceleration, without overshoot.
void follow(double& angle, double& rate, double error, const WalkPace& pace, double step) {
  const double far = std::abs(error);
  const double wanted =
      std::copysign(std::min({pace.turn, 2.5 * far, std::sqrt(1.2 * pace.turnAcceleration * far)}), error);
  rate += std::clamp(wanted - rate, -pace.turnAcceleration * step, pace.turnAcceleration * step);
  angle += rate * step;
}

// A curve by the way along it.
class Along {
 public:
  explicit Along(const std::vector<Vec2>& points) : points_(points) {
    far_.push_back(0);
    for (std::size_t i = 1; i < points.size(); ++i)
      far_.push_back(far_.back() + length(points[i] - points[i - 1]));
  }
  double length() const { return far_.back(); }
  Vec2 at(double s) const {
    if (points_.size() < 2 || s <= 0) return points_.front();
    if (s >= length()) return points_.back();
    const auto i = static_cast<std::size_t>(std::upper_bound(far_.begin(), far_.end(), s) - far_.begin());
    const double span = far_[i] - far_[i - 1];
    return points_[i - 1] + (points_[i] - points_[i - 1]) * (span > 0 ? (s - far_[i - 1]) / span : 0);
  }

 private:
  static double length(Vec2 v) { return idap::length(v); }
  const std::vector<Vec2>& points_;
  std::vector<double> far_;
};

}  // namespace

std::vector<Vec2> smoothCurve(const std::vector<Vec2>& points, double spacing) {
  std::vector<Vec2> p;
  for (const Vec2& q : points)
    if (p.empty() || length(q - p.back()) > 1e-6) p.push_back(q);
  if (p.size() < 2) return p;
  // The ends are continued by their mirror images.
  const Vec2 before = p[0] * 2.0 - p[1], after = p.back() * 2.0 - p[p.size() - 2];
  std::vector<Vec2> curve;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    const Vec2 p0 = i ? p[i - 1] : before, p1 = p[i], p2 = p[i + 1], p3 = i + 2 < p.size() ? p[i + 2] : after;
    // The knots are as far apart as the roots of the distances (Barry and Goldman's pyramid).
    const double t1 = std::sqrt(length(p1 - p0)), t2 = t1 + std::sqrt(length(p2 - p1)),
                 t3 = t2 + std::sqrt(length(p3 - p2));
    const auto mix = [](Vec2 a, Vec2 b, double ta, double tb, double t) {
      return a * ((tb - t) / (tb - ta)) + b * ((t - ta) / (tb - ta));
    };
    const int steps = std::max(1, static_cast<int>(std::ceil(length(p2 - p1) / spacing)));
    for (int k = 0; k < steps; ++k) {
      const double t = t1 + (t2 - t1) * k / steps;
      const Vec2 a1 = mix(p0, p1, 0, t1, t), a2 = mix(p1, p2, t1, t2, t), a3 = mix(p2, p3, t2, t3, t);
      curve.push_back(mix(mix(a1, a2, 0, t2, t), mix(a2, a3, t1, t3, t), t1, t2, t));
    }
  }
  curve.push_back(p.back());
  return curve;
}

CameraPath::CameraPath(const Camera& first, double floor, const WalkPace& pace) : floor_(floor), pace_(pace) {
  keep(first.eye, first.yaw, first.pitch, first.fieldOfView);
}

void CameraPath::keep(Vec3 eye, double yaw, double pitch, double fieldOfView) {
  Camera pose;
  pose.eye = eye;
  pose.yaw = yaw;
  pose.pitch = pitch;
  pose.fieldOfView = fieldOfView;
  poses_.push_back(std::move(pose));
}

void CameraPath::stay(double seconds) {
  const Camera pose = poses_.back();
  poses_.insert(poses_.end(), static_cast<std::size_t>(std::lround(std::max(seconds, 0.0) / kStep)), pose);
}

void CameraPath::walkTo(const Camera& next, const std::vector<Vec2>& curve) {
  const Camera from = poses_.back();
  const Along along(curve);
  const double flat = along.length(), rise = std::abs(next.eye.z - from.eye.z);
  const double whole = std::max(flat, rise);  // where it only rises or sinks, that is the way
  const double ease = std::min(1.2, flat / 2.5);
  const double low = std::min(from.eye.z, next.eye.z), high = std::max(from.eye.z, next.eye.z);
  // Between two points of view the eye is a walking person's, as far as the way is long enough to get there.
  const double middle = floor_ + pace_.walkingEye;
  const double between = flat < 2 ? std::clamp(middle, low, high) : middle;

  double s = 0, v = 0, yaw = from.yaw, pitch = from.pitch;
  const double goalYaw = next.yaw;
  for (int i = 0; i < static_cast<int>(kLongest / kStep); ++i) {
    const double left = whole - s;
    const double t = whole > 0 ? s / whole : 1;
    const double here = t * flat;
    const bool arriving = left < std::min(kArrival, 0.45 * whole) || flat < 0.4;
    double wantedYaw = goalYaw, wantedPitch = next.pitch;
    double limit = pace_.speed;
    if (!arriving) {
      const Vec2 ahead = along.at(here + pace_.lookAhead) - along.at(here);
      if (length(ahead) > 1e-6) wantedYaw = std::atan2(-ahead.x, ahead.y);
      wantedPitch = kWalkingPitch;
      // Who must turn much stands; who must turn little walks.
      const double off = std::abs(turned(wantedYaw - yaw));
      limit *= 1 - smooth((off - 0.35) / 0.6);
    }
    follow(yaw, yawRate_, turned(wantedYaw - yaw), pace_, kStep);
    follow(pitch, pitchRate_, wantedPitch - pitch, pace_, kStep);
    // Soon enough to stop at the end.
    const double brake = std::sqrt(2 * 0.8 * pace_.acceleration * std::max(left - 0.002, 0.0)) + 0.01;
    const double wanted = std::min(limit, brake);
    v += std::clamp(wanted - v, -1.6 * pace_.acceleration * kStep, pace_.acceleration * kStep);
    s = std::min(whole, s + std::max(v, 0.0) * kStep);

    const double done = whole > 0 ? s / whole : 1;
    const Vec2 p = along.at(done * flat);
    double z;
    if (flat < 0.4) {
      z = from.eye.z + (next.eye.z - from.eye.z) * smooth(done);
    } else {
      const double out = done * flat, in = flat - out;
      const double lift = smooth(1 - out / ease), land = smooth(1 - in / ease);
      z = between + (from.eye.z - between) * lift + (next.eye.z - between) * land;
    }
    keep({p.x, p.y, z}, yaw, pitch, from.fieldOfView + (next.fieldOfView - from.fieldOfView) * smooth(done));
    const bool looks = std::abs(turned(goalYaw - yaw)) < 0.004 && std::abs(next.pitch - pitch) < 0.004;
    if (s >= whole - 1e-4 && looks) break;
  }
  yawRate_ = pitchRate_ = 0;
  // Exactly there; what is left is less than can be seen.
  keep(next.eye, yaw + turned(goalYaw - yaw), next.pitch, next.fieldOfView);
}

}  // namespace idap
