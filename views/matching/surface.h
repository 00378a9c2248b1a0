// The surface in space that a disparity map shows: a mesh with the picture's colours, which can be
// encoded as a PLY file.
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

// In the left camera's eye space: x right, y up, the direction of view is -z; in units of the
// baseline.
struct Surface {
  struct Vertex {
    float x, y, z;
    std::uint8_t r, g, b;
  };
  std::vector<Vertex> vertices;                         // one for each pixel with a depth, by rows
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise as seen by the camera
};

// The point of a pixel with the centre (x, y) and the depth Z is ((x - cx) Z/f, -(y - cy) Z/f, -Z),
// with the focal length f and the left camera's principal point (cx, cy). Neighbouring pixels are
// joined by triangles if their disparities differ by at most kSameSurface px: a greater step leads
// to another surface (C-113).
inline constexpr float kSameSurface = 1;
Surface surface_of(const Image<Rgba8>& picture, const Image<float>& disparity,
                   const Calibration& calibration);

// The format is binary_little_endian: vertices with colours, then faces. `comment` is a line of the
// header.
std::vector<std::byte> encode_ply(const Surface& surface, const std::string& comment);

// The frustum of the left picture's camera that contains the surface: the window's edges on the
// near plane, as for glFrustum, and near and far distances.
struct SurfaceView {
  double left = 0, right = 0, bottom = 0, top = 0, near = 0, far = 0;
};
// An error if no pixel has a depth.
Result<SurfaceView> view_of(const Surface& surface, const Calibration& calibration, int width,
                            int height);

}  // namespace glassbox::views
