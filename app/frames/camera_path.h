// A camera that moves: keyframes, and what is between them.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace glassbox::app {

struct Keyframe {
  double at = 0;  // a time, or a frame's number from 1
  std::array<double, 3> eye{0, 0, 0}, look_at{0, 0, -1}, up{0, 1, 0};
  double fov_degrees = 0;        // where the path has angles
  std::optional<double> window;  // where the path has windows; absent: where the camera looks
};

enum class Interpolation { kLinear, kSmooth };
enum class PathClock { kTime, kFrames };

// At least one keyframe, the times growing. Angles and windows are there in all keyframes or in none.
struct CameraPath {
  Interpolation interpolation = Interpolation::kLinear;
  PathClock clock = PathClock::kTime;
  bool has_fov = false;
  bool has_window = false;
  std::vector<Keyframe> keyframes;
};

// When frame `number` (from 1) of `count` is taken: at its number, or where `count` frames stand evenly from the first
// keyframe to the last.
double time_of_frame(const CameraPath& path, int number, int count);

// The camera at a time; before the first keyframe and after the last it stands still. Every number is interpolated by
// itself:
//
//   linear   a + u (b - a) between the keyframes' a and b, u = (t - ta)/(tb - ta)
//   smooth   the cubic through a and b with the slopes ma and mb,
//            a + u (h ma + u (3 (b - a) - h (2 ma + mb) + u (h (ma + mb) - 2 (b - a)))), h = tb - ta
//            with the slope 0 at the first and the last keyframe and where the number turns round, else the weighted
//            harmonic mean of the slopes before and after, (v + w)/(v/d + w/e), v = h + 2g, w = 2h + g, where d and e are the
//            slopes (b - a)/h before and after and h and g how long they last (Fritsch and Butland 1984)
//
// Between two keyframes a number never leaves what they have: nothing overshoots. Sums, products and quotients alone, so
// that the same path gives the same bytes everywhere.
struct CameraAt {
  std::array<double, 3> eye, look_at, up;
  std::optional<double> fov_degrees;
};
CameraAt camera_at(const CameraPath& path, double time);

// The window of a path that has windows. What is interpolated is 1/window, in which parallax is linear; `looked_at` is the
// distance that stands for the windows left to the camera.
double window_at(const CameraPath& path, double time, double looked_at);

}  // namespace glassbox::app
