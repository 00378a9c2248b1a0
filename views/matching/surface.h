// The surface that a disparity map shows, in space: a mesh with the picture's colours, as PLY.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

#include "views/matching/calibration.h"

namespace glassbox::views {

// Of the left camera's eye space: x right, y up, the gaze is -z; units of the baseline.
struct Surface {
  struct Vertex {
    float x, y, z;
    std::uint8_t r, g, b;
  };
  std::vector<Vertex> vertices;  // one for each pixel that has a depth, by rows
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise as the camera sees them
};

// A pixel's point is ((x - cx) Z/f, -(y - cy) Z/f, -Z) of its centre (x, y) and the left camera's principal point (cx, cy). Neighbours are
// joined where their disparities differ by at most kSameSurface px: a greater step is from one surface to another (C-113).
inline constexpr float kSameSurface = 1;
Surface surface_of(const Image<Rgba8>& picture, const Image<float>& disparity,
                   const Calibration& calibration);

// binary_little_endian: vertices with colours, then faces. `comment` is a line of the header.
std::vector<std::byte> encode_ply(const Surface& surface, const std::string& comment);

// What the left picture's camera sees of it: edges of the window on a near plane, as glFrustum has them, and distances that hold it all.
struct SurfaceView {
  double left = 0, right = 0, bottom = 0, top = 0, near = 0, far = 0;
};
// An error where no pixel has a depth.
Result<SurfaceView> view_of(const Surface& surface, const Calibration& calibration, int width,
                            int height);

}  // namespace glassbox::views
