#include "cli/frames/camera_path.h"

#include <algorithm>
#include <cstddef>

namespace glassbox {

namespace {

// One number of the keyframes as a function of time. `value_of` gives the number for a keyframe's
// index.
template <class ValueOf>
class Curve {
public:
  Curve(const CameraPath& path, const ValueOf& value_of) : path_(path), value_of_(value_of) {}

  double operator()(double time) const {
    const std::vector<Keyframe>& keys = path_.keyframes;
    const auto after = std::ranges::upper_bound(keys, time, {}, &Keyframe::time);
    if (after == keys.begin()) return value_of_(0);
    if (after == keys.end()) return value_of_(keys.size() - 1);
    const std::size_t i = std::size_t(after - keys.begin()) - 1;
    const double a = value_of_(i), b = value_of_(i + 1);
    const double h = keys[i + 1].time - keys[i].time;
    const double u = (time - keys[i].time) / h;
    // Rounding could put the result outside the two values by a few ulps, so it is clamped.
    return std::clamp(between(i, a, b, h, u), std::min(a, b), std::max(a, b));
  }

private:
  double between(std::size_t i, double a, double b, double h, double u) const {
    const double rise = b - a;
    if (path_.interpolation == Interpolation::kLinear) return a + u * rise;
    const double ma = h * slope_at(i), mb = h * slope_at(i + 1);
    return a + u * (ma + u * (3 * rise - (2 * ma + mb) + u * (ma + mb - 2 * rise)));
  }

  double slope_at(std::size_t i) const {
    const std::vector<Keyframe>& keys = path_.keyframes;
    if (i == 0 || i + 1 == keys.size()) return 0;
    const double h = keys[i].time - keys[i - 1].time, g = keys[i + 1].time - keys[i].time;
    const double before = (value_of_(i) - value_of_(i - 1)) / h;
    const double after = (value_of_(i + 1) - value_of_(i)) / g;
    const bool goes_on = (before > 0 && after > 0) || (before < 0 && after < 0);
    if (!goes_on) return 0;
    const double v = h + 2 * g, w = 2 * h + g;
    return (v + w) / (v / before + w / after);
  }

  const CameraPath& path_;
  const ValueOf& value_of_;
};

using TripleOf = std::array<double, 3> Keyframe::*;

std::array<double, 3> triple_at(const CameraPath& path, TripleOf member, double time) {
  std::array<double, 3> triple{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto value_of = [&](std::size_t i) { return (path.keyframes[i].*member)[k]; };
    triple[k] = Curve(path, value_of)(time);
  }
  return triple;
}

}  // namespace

double time_of_frame(const CameraPath& path, int number, int count) {
  if (path.clock == PathClock::kFrames) return number;
  const double first = path.keyframes.front().time, last = path.keyframes.back().time;
  if (number == 1) return first;
  if (number == count) return last;
  return first + (last - first) * (double(number - 1) / double(count - 1));
}

CameraPose camera_at(const CameraPath& path, double time) {
  CameraPose camera{triple_at(path, &Keyframe::eye, time),
                    triple_at(path, &Keyframe::look_at, time),
                    triple_at(path, &Keyframe::up, time),
                    {}};
  if (path.has_fov) {
    const auto value_of = [&](std::size_t i) { return path.keyframes[i].fov_degrees; };
    camera.fov_degrees = Curve(path, value_of)(time);
  }
  return camera;
}

double window_at(const CameraPath& path, double time, double looked_at) {
  const auto value_of = [&](std::size_t i) {
    return 1 / path.keyframes[i].window.value_or(looked_at);
  };
  return 1 / Curve(path, value_of)(time);
}

}  // namespace glassbox
