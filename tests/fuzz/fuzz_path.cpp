// Reads any bytes as a camera path: the result is an error that names the place, or a path whose
// cameras stay between their keyframes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "cli/frames/path_file.h"
#include "tests/fuzz/promises.h"

namespace {

using namespace glassbox;
using fuzz::require;

// Requires a finite value between the smallest and the largest one of all keyframes.
template <class ValueOf>
void check_range(const CameraPath& path, double value, const ValueOf& value_of) {
  const auto [low, high] = std::ranges::minmax(path.keyframes, {}, value_of);
  require(value >= value_of(low) && value <= value_of(high), "no overshoot");
}

void check_camera(const CameraPath& path, double time) {
  const CameraPose camera = camera_at(path, time);
  for (std::size_t k = 0; k < 3; ++k) {
    check_range(path, camera.eye[k], [k](const Keyframe& key) { return key.eye[k]; });
    check_range(path, camera.look_at[k], [k](const Keyframe& key) { return key.look_at[k]; });
    check_range(path, camera.up[k], [k](const Keyframe& key) { return key.up[k]; });
  }
  require(camera.fov_degrees.has_value() == path.has_fov, "angles in all keyframes or in none");
  if (path.has_fov) {
    check_range(path, *camera.fov_degrees, [](const Keyframe& key) { return key.fov_degrees; });
  }
  if (path.has_window) {
    const double window = window_at(path, time, 3.0);
    require(window > 0 && std::isfinite(window), "windows in front of the camera");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto path = parse_camera_path({reinterpret_cast<const char*>(data), size}, "p.json");
  if (!path) {
    require(path.error().file == "p.json", "the file's name");
    fuzz::check_error(path.error());
    return 0;
  }
  require(!path->keyframes.empty() && path->keyframes.size() <= kMaxKeyframes, "keyframes");
  for (std::size_t i = 1; i < path->keyframes.size(); ++i) {
    require(path->keyframes[i].time > path->keyframes[i - 1].time, "growing times");
  }
  for (int number = 1; number <= 33; ++number) {
    check_camera(*path, time_of_frame(*path, number, 33));
  }
  const std::size_t first = std::min<std::size_t>(path->keyframes.size(), 20);
  for (std::size_t i = 0; i < first; ++i) {
    const Keyframe& key = path->keyframes[i];
    require(camera_at(*path, key.time).eye == key.eye, "a keyframe's camera at its time");
  }
  return 0;
}
