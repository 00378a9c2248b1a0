#include "cli/frames/sequence_frames.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/bounding_box.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/number_text.h>

namespace glassbox {

namespace {

// The options, with their camera replaced by the frame's.
PictureOptions options_for(const PictureOptions& picture, const CameraPose& pose) {
  PictureOptions own = picture;
  own.camera.camera.reset();
  own.camera.eye = pose.eye;
  own.camera.look_at = pose.look_at;
  own.camera.up = pose.up;
  if (pose.fov_degrees) own.camera.fov_degrees = pose.fov_degrees;
  return own;
}

Result<void> choose_frame_camera(const Scene& scene, const PictureOptions& own,
                                 SequenceFrame& frame) {
  return choose_view(scene, own).map([&](const ChosenView& chosen) {
    frame.camera = chosen.camera;
    frame.centre = chosen.view;
  });
}

// Chooses the two eyes with separation zero, because this gives the automatic window without
// further checks.
Result<void> choose_frame_eyes(const Scene& scene, const PictureOptions& picture,
                               PictureOptions own, const CameraPath& path, SequenceFrame& frame) {
  own.eyes.separation = 0;
  own.eyes.window.reset();
  return choose_eyes(scene, own).map([&](const ChosenEyes& chosen) {
    frame.camera = chosen.camera;
    frame.centre = chosen.centre;
    const double looked_at = chosen.eyes.pair.window;
    frame.window = path.has_window ? window_at(path, frame.time, looked_at)
                                   : picture.eyes.window.value_or(looked_at);
  });
}

std::string comma_separated(const std::array<double, 3>& triple) {
  return number_text(triple[0]) + "," + number_text(triple[1]) + "," + number_text(triple[2]);
}

}  // namespace

Result<std::vector<SequenceFrame>> make_sequence_frames(const Scene& scene,
                                                        const PictureOptions& picture,
                                                        const CameraPath& path,
                                                        const std::optional<Turntable>& turntable,
                                                        const FrameRange& range, bool stereo) {
  std::vector<SequenceFrame> frames;
  for (int number = range.first; number <= range.last; ++number) {
    SequenceFrame frame{
        number, turntable ? number : time_of_frame(path, number, range.count), {}, {}, {}, 0};
    frame.pose = turntable ? turntable->camera(number, range.count) : camera_at(path, frame.time);
    const PictureOptions own = options_for(picture, frame.pose);
    const Result<void> aimed = stereo ? choose_frame_eyes(scene, picture, own, path, frame)
                                      : choose_frame_camera(scene, own, frame);
    if (!aimed) {
      const Error& error = aimed.error();
      return fail(fmt::format("frame {}", number),
                  error.place.empty() ? error.cause : error.place + ": " + error.cause,
                  error.remedy);
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

std::vector<std::string> frame_command_words(const SequenceFrame& frame, const StereoPair* pair,
                                             const std::vector<const CLI::Option*>& options) {
  const std::vector<std::string> replaced{"--eye-separation", "--window", "--camera", "--eye",
                                          "--look-at",        "--up"};
  std::vector<const CLI::Option*> kept;
  for (const CLI::Option* option : options) {
    if (std::ranges::find(replaced, option->get_name()) == replaced.end()) kept.push_back(option);
  }
  std::vector<std::string> words = option_words(kept);
  const auto add = [&words](const char* name, const std::string& value) {
    words.insert(words.end(), {name, value});
  };
  add("--eye", comma_separated(frame.pose.eye));
  add("--look-at", comma_separated(frame.pose.look_at));
  add("--up", comma_separated(frame.pose.up));
  if (frame.pose.fov_degrees) add("--fov", number_text(*frame.pose.fov_degrees));
  if (pair != nullptr) {
    add("--eye-separation", number_text(2 * pair->half_separation));
    add("--window", number_text(pair->window));
  }
  return words;
}

namespace {

using WorldPoint = Point<World, double>;
using WorldVector = Vector<World, double>;

WorldPoint point_of(const std::array<double, 3>& p) {
  return {p[0], p[1], p[2]};
}

// Scales to length 1. A vector without a direction (zero or infinite) stays as it is; look_at
// refuses it.
WorldVector unit(const WorldVector& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0 && std::isfinite(length) ? WorldVector{v.x / length, v.y / length, v.z / length}
                                             : v;
}

WorldVector turned(const WorldVector& v, const WorldVector& axis, const SinCos& angle) {
  const WorldVector across = cross(axis, v);
  const double along = dot(axis, v) * (1 - angle.cos);
  const auto sum = [&](double own, double side, double up) {
    return own * angle.cos + side * angle.sin + up * along;
  };
  return {sum(v.x, across.x, axis.x), sum(v.y, across.y, axis.y), sum(v.z, across.z, axis.z)};
}

// The distance of the eye from the target that keeps a point in the picture during the whole turn.
// Let the point be at height h above the target and at distance rho from the axis, and e the eye's
// elevation. When the eye has turned to the angle phi from the point, the point's coordinates along
// the eye's axes (right, up, towards the eye), with the target as origin, are
//   x = rho sin phi,  y = h cos e - rho cos phi sin e,  z = h sin e + rho cos phi cos e.
// `across` and `up` are the tangents of half the angles of view, less a margin. The point is in the
// picture if the distance is at least z + |x|/across and at least z + |y|/up. The function returns
// the maximum of these over phi.
double distance_needed(double h, double rho, const SinCos& e, double across, double up) {
  const double sides = h * e.sin + rho * std::sqrt(e.cos * e.cos + 1 / (across * across));
  const double top = h * (e.sin + e.cos / up) + rho * std::abs(e.cos - e.sin / up);
  const double bottom = h * (e.sin - e.cos / up) + rho * std::abs(e.cos + e.sin / up);
  return std::max({sides, top, bottom});
}

double framing_distance(const Scene& scene, const WorldPoint& target, const WorldVector& axis,
                        const WorldVector& to_eye, double fov_degrees, double aspect) {
  const double sine = std::clamp(dot(axis, to_eye), -1.0, 1.0);
  const SinCos elevation{sine, std::sqrt(1 - sine * sine)};
  const double up = tan_half_degrees(fov_degrees) / FramingOptions{}.margin;
  double distance = 0;
  for_each_drawn_position(scene, [&](const WorldPoint& p) {
    const WorldVector from_target{p.x - target.x, p.y - target.y, p.z - target.z};
    const double h = dot(axis, from_target);
    const double rho = std::sqrt(std::max(0.0, dot(from_target, from_target) - h * h));
    distance = std::max(distance, distance_needed(h, rho, elevation, aspect * up, up));
  });
  return distance;
}

// The options for placing a camera automatically: of the given options only the up vector and the
// angle of view are kept.
CameraOptions automatic_options(const CameraOptions& options) {
  CameraOptions automatic;
  automatic.camera = "none";
  automatic.up = options.up;
  automatic.fov_degrees = options.fov_degrees;
  return automatic;
}

}  // namespace

CameraPose Turntable::camera(int number, int count) const {
  const SinCos angle = sin_cos_degrees(360.0 * (number - 1) / count);
  const WorldVector offset = turned(from_target, unit({up[0], up[1], up[2]}), angle);
  return {{target.x + offset.x, target.y + offset.y, target.z + offset.z},
          {target.x, target.y, target.z},
          up,
          {}};
}

Result<Turntable> make_turntable(const Scene& scene, const CameraOptions& options, double aspect) {
  const Result<Camera> automatic = choose_camera(scene, automatic_options(options), aspect);
  if (!automatic) return tl::unexpected(automatic.error());
  Turntable turntable;
  turntable.up = options.up.value_or(turntable.up);
  turntable.target = options.look_at ? point_of(*options.look_at) : bounds(scene).center();
  const WorldPoint& target = turntable.target;
  if (options.eye) {
    const WorldPoint eye = point_of(*options.eye);
    turntable.from_target = {eye.x - target.x, eye.y - target.y, eye.z - target.z};
    return turntable;
  }
  const auto& m = automatic->world_from_eye;
  const WorldVector to_eye{m.at(0, 2), m.at(1, 2), m.at(2, 2)};
  const WorldVector axis = unit({turntable.up[0], turntable.up[1], turntable.up[2]});
  const double fov = options.fov_degrees.value_or(FramingOptions{}.fovy_degrees);
  double distance = framing_distance(scene, target, axis, to_eye, fov, aspect);
  // If all points are at the target, the computed distance is 0, so the automatic camera's is used.
  const WorldVector stands{m.at(0, 3) - target.x, m.at(1, 3) - target.y, m.at(2, 3) - target.z};
  if (!(distance > 0)) distance = std::sqrt(dot(stands, stands));
  turntable.from_target = {to_eye.x * distance, to_eye.y * distance, to_eye.z * distance};
  return turntable;
}

}  // namespace glassbox
