// Reads camera paths from JSON files. docs/stereo.md describes the format.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "cli/frames/camera_path.h"

#include <glassbox/base/error.h>

namespace glassbox {

inline constexpr int kPathVersion = 1;

// Upper limits of a path.
inline constexpr std::size_t kMaxPathBytes = 4u << 20;
inline constexpr std::size_t kMaxKeyframes = 10000;
inline constexpr int kMaxFrames = 100000;

// The minimum time between two keyframes of a path. It keeps slopes between float positions far
// from overflow.
inline constexpr double kMinKeyframeGap = 1e-9;

// Parses a camera path strictly: unknown or duplicate parts are errors, which name `file` and the
// place in it ("keyframe 3, \"eye\"", counted from 1). Every keyframe gives a valid camera.
Result<CameraPath> parse_camera_path(std::string_view text, const std::string& file);

Result<CameraPath> read_camera_path(const std::string& file);

}  // namespace glassbox
