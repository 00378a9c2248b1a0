// Camera paths from JSON files (docs/stereo.md has the format).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "app/frames/camera_path.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

inline constexpr int kPathVersion = 1;

// What a path may not exceed.
inline constexpr std::size_t kMaxPathBytes = 4u << 20;
inline constexpr std::size_t kMaxKeyframes = 10000;
inline constexpr int kMaxFrames = 100000;

// Keyframes of one path are at least this far apart in time, so that slopes between positions that floats can hold are far
// from overflowing.
inline constexpr double kMinKeyframeGap = 1e-9;

// Strict: what is not of the format, or there twice, is an error, which names `file` and the place in it ("keyframe 3,
// \"eye\"", counted from 1). Every keyframe is a camera that can be set up.
Result<CameraPath> parse_camera_path(std::string_view text, const std::string& file);

Result<CameraPath> read_camera_path(const std::string& file);

}  // namespace glassbox::app
