// The records of rasterisation, in the order in which a triangle passes through them. They continue
// where pipeline/stages.h ends (ScreenVertex):
//
//   SnappedVertex  rounded to 1/256 pixel: from here on, positions are exact  snap.h
//   TriangleSetup  edge functions, area, winding, depth and 1/w of vertices   triangle_setup.h
//   Coverage       which pixel centres it covers, the edge functions there    coverage.h
//   Fragment       depth and perspective-correct weights at a pixel centre    interpolate.h
//   Varyings       the attributes there                                       interpolate.h
//   depth test     which fragment is in front                                 depth.h
//   Rgba           textured and lit                                           texture.h, shading.h
//   Rgba8          masked, blended, encoded                                   blend.h
//
// Lines and points enter at the snap and also become fragments (line.h, point.h).
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/mesh/mesh.h>

namespace glassbox {

inline constexpr int kSubpixelBits = 8;
inline constexpr std::int32_t kSubpixels = 1 << kSubpixelBits;  // steps per pixel
inline constexpr std::int32_t kPixelCentre = kSubpixels / 2;

// A position on the screen in 1/256 pixel. |x|, |y| < 2^24: the guard band reaches 2^15 pixels from
// the centre of a screen at most 2^15 pixels wide.
struct SnappedVertex {
  std::int32_t x = 0, y = 0;
  friend bool operator==(const SnappedVertex&, const SnappedVertex&) = default;
};

// Pixels x0 <= x < x1, y0 <= y < y1.
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

// E(x, y) = a x + b y + c in units of 1/65536 square pixel; positive on the inner side. Exact in 64
// bits, because the factors have at most 26 bits.
struct EdgeFunction {
  std::int64_t a = 0, b = 0, c = 0;
  bool owns_zero = false;  // a top or left edge: its points belong to the triangle

  std::int64_t at(std::int64_t x, std::int64_t y) const { return a * x + b * y + c; }
  bool covers(std::int64_t value) const { return value > 0 || (value == 0 && owns_zero); }
};

struct TriangleSetup {
  // Edge k is opposite vertex k, so E_k / double_area is vertex k's weight.
  std::array<EdgeFunction, 3> edges;
  std::int64_t double_area = 0;  // E_0 + E_1 + E_2, always positive
  bool clockwise = false;  // winding as seen on the screen, in the order of the incoming vertices
  std::array<int, 3> order{};    // order[k]: the incoming vertex that became vertex k
  std::array<float, 3> depth{};  // depth[0] is the smallest: see interpolate.h
  std::array<float, 3> inverse_w{};
  bool affine = false;     // all three w are equal, so perspective changes nothing
  float inverse_area = 0;  // 1 / double_area
  PixelRect bounds;        // no pixel outside of it is covered
};

// A pixel whose centre the triangle covers, with the three edge functions there.
struct Coverage {
  int x = 0, y = 0;
  std::array<std::int64_t, 3> edges{};
};

struct Fragment {
  int x = 0, y = 0;
  std::array<float, 3> lambda{};  // barycentric weights on the screen
  // Barycentric weights on the triangle in space: lambda corrected for perspective.
  std::array<float, 3> weights{};
  float depth = 0;  // NDC z
  float inverse_w = 1;
};

// The attributes that are interpolated over a primitive. The material and the shading decide which
// of them are used.
template <class F>
struct VaryingsOf {
  std::array<F, 3> normal{};    // eye space, unit length at the vertices
  std::array<F, 3> position{};  // eye space
  std::array<F, 3> diffuse{};   // received light, where lighting is done per vertex
  std::array<F, 3> specular{};
  std::array<F, 4> color{1.0f, 1.0f, 1.0f, 1.0f};
  std::array<F, 2> texcoord{};
};
using Varyings = VaryingsOf<float>;

}  // namespace glassbox
