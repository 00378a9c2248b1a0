// A moving camera: keyframes, and the interpolation between them.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace glassbox {

struct Keyframe {
  double time = 0;  // a time, or a frame's number from 1
  std::array<double, 3> eye{0, 0, 0}, look_at{0, 0, -1}, up{0, 1, 0};
  double fov_degrees = 0;        // used where the path has angles
  std::optional<double> window;  // used where the path has windows; absent: at the target
};

enum class Interpolation { kLinear, kSmooth };
enum class PathClock { kTime, kFrames };

// Has at least one keyframe; the times grow. Angles and windows are given in all keyframes or in
// none.
struct CameraPath {
  Interpolation interpolation = Interpolation::kLinear;
  PathClock clock = PathClock::kTime;
  bool has_fov = false;
  bool has_window = false;
  std::vector<Keyframe> keyframes;
};

// The time at which frame `number` (from 1) of `count` is taken. It is the number itself if the
// path counts frames; otherwise `count` frames are spaced evenly from the first keyframe to the
// last.
double time_of_frame(const CameraPath& path, int number, int count);

// The camera at a time. Before the first keyframe and after the last it stands still. Every number
// is interpolated on its own. Let it be a at the keyframe before, at time ta, and b at the keyframe
// after, at time tb. With h = tb - ta and u = (t - ta)/h, its value at time t is
//   linear   a + u (b - a)
//   smooth   a + u (h ma + u (3 (b - a) - h (2 ma + mb) + u (h (ma + mb) - 2 (b - a)))),
//            the cubic through a and b that has the slopes ma and mb there
//
// The slope of `smooth` is 0 at the first and the last keyframe, and at a keyframe where the number
// has a maximum or a minimum. At other keyframes it is the weighted harmonic mean
//   (v + w)/(v/d + w/e), v = h + 2g, w = 2h + g,
// where d is the slope (b - a)/h over the interval before the keyframe, h that interval's length,
// and e and g the same for the interval after the keyframe (Fritsch and Butland 1984).
//
// Between two keyframes a number stays between their two values: nothing overshoots. Only sums,
// products and quotients are used, so that the same path gives the same bytes everywhere.
struct CameraPose {
  std::array<double, 3> eye, look_at, up;
  std::optional<double> fov_degrees;
};
CameraPose camera_at(const CameraPath& path, double time);

// The distance of the stereo window at a time. 1/window is interpolated, because parallax is linear
// in it. `looked_at` is the window's distance at keyframes without a window: the distance of the
// point that the camera looks at.
double window_at(const CameraPath& path, double time, double looked_at);

}  // namespace glassbox
