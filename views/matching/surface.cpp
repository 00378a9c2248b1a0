#include "views/matching/surface.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "views/matching/winner.h"

namespace glassbox::views {

namespace {

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

// Writes the least significant byte first, on machines of any byte order.
void put(std::vector<std::byte>& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(std::byte((value >> shift) & 255));
}

void put(std::vector<std::byte>& bytes, std::string_view text) {
  for (const char letter : text) bytes.push_back(std::byte(letter));
}

// Adds the vertices. Returns the number of each pixel's vertex.
Image<std::uint32_t> add_vertices(const Image<Rgba8>& picture, const Image<float>& depths,
                                  const Calibration& calibration, Surface& surface) {
  const Principal centre = principal_of(calibration, picture.width, picture.height);
  Image<std::uint32_t> numbers(picture.width, picture.height, kNoVertex);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const double depth = double(depths.at(x, y));
      if (!std::isfinite(depth)) continue;
      const double share = depth / calibration.focal_px;
      const Rgba8& color = picture.at(x, y);
      numbers.at(x, y) = std::uint32_t(surface.vertices.size());
      surface.vertices.push_back({float((x + 0.5 - centre.x) * share),
                                  float((centre.y - (y + 0.5)) * share), float(-depth), color.r,
                                  color.g, color.b});
    }
  }
  return numbers;
}

}  // namespace

Surface surface_of(const Image<Rgba8>& picture, const Image<float>& disparity,
                   const Calibration& calibration) {
  Surface surface;
  const Image<std::uint32_t> numbers =
      add_vertices(picture, depths_of(disparity, calibration), calibration, surface);
  const auto joined = [&](std::size_t a, std::size_t b) {
    return std::abs(disparity.pixels[a] - disparity.pixels[b]) <= kSameSurface;
  };
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    const std::array<std::uint32_t, 3> triangle{numbers.pixels[a], numbers.pixels[b],
                                                numbers.pixels[c]};
    if (std::ranges::count(triangle, kNoVertex) > 0) return;
    if (joined(a, b) && joined(b, c) && joined(c, a)) surface.triangles.push_back(triangle);
  };
  for (int y = 0; y + 1 < picture.height; ++y) {
    for (int x = 0; x + 1 < picture.width; ++x) {
      const std::size_t above = disparity.index(x, y), below = disparity.index(x, y + 1);
      add(above, below, above + 1);
      add(above + 1, below, below + 1);
    }
  }
  return surface;
}

std::vector<std::byte> encode_ply(const Surface& surface, const std::string& comment) {
  constexpr std::size_t kVertexBytes = 15, kFaceBytes = 13;
  std::vector<std::byte> bytes;
  const std::string header = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\nproperty float x\n"
      "property float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nelement face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      comment, surface.vertices.size(), surface.triangles.size());
  bytes.reserve(header.size() + surface.vertices.size() * kVertexBytes +
                surface.triangles.size() * kFaceBytes);
  put(bytes, header);
  for (const Surface::Vertex& vertex : surface.vertices) {
    for (const float value : {vertex.x, vertex.y, vertex.z}) {
      put(bytes, std::bit_cast<std::uint32_t>(value));
    }
    for (const std::uint8_t value : {vertex.r, vertex.g, vertex.b}) {
      bytes.push_back(std::byte(value));
    }
  }
  for (const auto& triangle : surface.triangles) {
    bytes.push_back(std::byte(triangle.size()));
    for (const std::uint32_t corner : triangle) put(bytes, corner);
  }
  return bytes;
}

Result<SurfaceView> view_of(const Surface& surface, const Calibration& calibration, int width,
                            int height) {
  if (surface.vertices.empty()) {
    return fail("the surface", "no pixel has a depth",
                "check --calibration: F B/(disparity + OFFSET) must be above 0");
  }
  const auto [farthest, nearest] = std::ranges::minmax(surface.vertices, {}, &Surface::Vertex::z);
  const Principal centre = principal_of(calibration, width, height);
  SurfaceView view;
  // A margin of 1 %, because rounding could cut off points that are exactly on the near or far
  // plane.
  view.near = -double(nearest.z) * 0.99;
  view.far = -double(farthest.z) * 1.01;
  const double scale = view.near / calibration.focal_px;
  view.left = -centre.x * scale;
  view.right = (width - centre.x) * scale;
  view.bottom = (centre.y - height) * scale;
  view.top = centre.y * scale;
  return view;
}

}  // namespace glassbox::views
