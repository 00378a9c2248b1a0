// The generated inputs of lab 8 for pixels, rows and footprints: up to 100,000 for each function,
// of all kinds that student.h names and of the borders between them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "cases.h"
#include "labs/framework/choices.h"

namespace lab_08 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

// ---- one pixel (task 8.1) ----

// An edge function: of any size, or beside a power of two, such as those of 32-bit integers.
inline std::int64_t any_edge(Choices& c) {
  if (c.flag()) return std::abs(c.sized(51));
  const std::int64_t power = std::int64_t(1) << c.below(52);
  return std::clamp<std::int64_t>(power + c.integer(-2, 2), 0, std::int64_t(1) << 51);
}
// A float from 2^-20 to 2^20, for 1/w.
inline float any_inverse_w(Choices& c) {
  return float(c.flag() ? c.positive(-20, 19) : c.positive(-4, 3));
}
// A coordinate: 0, or of either sign and from 2^-20 to 2^20 in magnitude.
inline float any_texcoord(Choices& c) {
  switch (c.below(4)) {
    case 0:
      return float(c.integer(-2, 2));
    case 1:
      return float(c.multiple(-16, 16, 8));
    case 2:
      return float(c.real(-5, 5));
    default:
      return float(c.real(-20, 19));
  }
}

inline PixelOfTriangle any_pixel(Choices& c) {
  PixelOfTriangle at;
  for (std::int64_t& edge : at.edges) edge = any_edge(c);
  if (at.edges[0] == 0 && at.edges[1] == 0 && at.edges[2] == 0) at.edges[c.below(3)] = 1;
  for (float& each : at.inverse_w) each = any_inverse_w(c);
  for (auto& vertex : at.texcoords) {
    for (float& each : vertex) each = any_texcoord(c);
  }
  return at;
}
inline PixelCase one_pixel(const PixelOfTriangle& at) {
  return {"a pixel", at};
}

// A pixel of a triangle whose vertices have nearly the same weight, so that each of them counts.
inline PixelOfTriangle balanced_pixel(Choices& c) {
  PixelOfTriangle at = any_pixel(c);
  const std::int64_t size = std::int64_t(1) << c.below(50);
  for (std::int64_t& edge : at.edges) edge = size + std::int64_t(c.below(std::uint64_t(size) + 1));
  for (float& each : at.inverse_w) each = float(c.positive(-2, 2));
  return at;
}

inline PixelCase pixel_on_edge(Choices& c) {
  PixelOfTriangle at = any_pixel(c);
  const auto k = std::size_t(c.below(3));
  const bool in_vertex = c.flag();
  at.edges[k] = 0;
  std::int64_t& next = at.edges[(k + 1) % 3];
  std::int64_t& last = at.edges[(k + 2) % 3];
  if (in_vertex) next = 0;
  if (next == 0 && last == 0) last = 1;
  return one_pixel(at);
}

// A coordinate that is the same at all vertices, at two of them, or nearly the same.
inline PixelCase pixel_with_equal_coordinates(Choices& c) {
  PixelOfTriangle at = c.flag() ? balanced_pixel(c) : any_pixel(c);
  for (std::size_t i = 0; i < 2; ++i) {
    const float same = at.texcoords[0][i];
    const auto which = c.below(4);
    if (which < 2) at.texcoords[1][i] = same;
    if (which < 1 || which == 2) at.texcoords[2][i] = same;
  }
  return one_pixel(at);
}

// Coordinates far from 0 that differ by little, even by one ulp.
inline PixelCase pixel_with_large_coordinates(Choices& c) {
  PixelOfTriangle at = balanced_pixel(c);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto base = float(c.real(4, 18));
    const double step = std::ldexp(1.0, int(c.integer(-20, 1)));
    for (auto& vertex : at.texcoords) {
      if (c.flag())
        vertex[i] = c.near(base);
      else
        vertex[i] = float(double(base) * (1 + double(c.integer(-4, 4)) * step / 16));
    }
  }
  return one_pixel(at);
}

inline std::vector<InputClass<PixelCase>> generated_pixels() {
  return {{"edge functions, distances and coordinates of every size", 30'000,
           [](Choices& c) { return one_pixel(any_pixel(c)); }},
          {"pixels at which all three vertices count", 30'000,
           [](Choices& c) { return one_pixel(balanced_pixel(c)); }},
          {"pixels on an edge or in a vertex", 15'000, pixel_on_edge},
          {"a coordinate that is the same at two or three vertices", 10'000,
           pixel_with_equal_coordinates},
          {"large coordinates that differ by little (C-67)", 15'000, pixel_with_large_coordinates}};
}

// ---- rows of pixels (tasks 8.2 and 8.3) ----

// A coordinate at an end of a row: 0, or of either sign and from 2^-100 to 2^100 in magnitude.
inline double coordinate_at_end(Choices& c) {
  switch (c.below(4)) {
    case 0:
      return double(c.integer(-512, 512));
    case 1:
      return c.multiple(-8, 8, 16);
    case 2:
      return c.real(-4, 12);
    default:
      return c.real(-100, 99);
  }
}

// The lengths of rows: every number of digits is equally likely.
inline int any_pixels(Choices& c, int bits) {
  const auto pixels = int(std::abs(c.sized(bits)));
  return std::max(1, pixels);
}

inline Line any_line(Choices& c, int pixels) {
  Line line;
  line.u0 = coordinate_at_end(c);
  switch (c.below(4)) {
    case 0:
      line.u1 = coordinate_at_end(c);
      break;
    case 1:
      line.u1 = line.u0 + c.multiple(-4, 4, 64) * std::abs(line.u0);
      break;
    case 2:
      line.u1 = -line.u0;
      break;
    default:
      line.u1 = line.u0;
  }
  // The sum of two numbers of this range may be too small.
  if (std::abs(line.u1) < 0x1p-100 || std::abs(line.u1) > 0x1p100) line.u1 = 0;
  switch (c.below(4)) {
    case 0:
      line.inverse_w0 = line.inverse_w1 = c.positive(-100, 99);
      break;
    case 1:
      line.inverse_w0 = c.positive(-20, 19);
      line.inverse_w1 = c.near(line.inverse_w0);
      break;
    case 2:
      line.inverse_w0 = c.positive(-90, 89);
      line.inverse_w1 = line.inverse_w0 * c.positive(-8, 7);
      break;
    default:
      line.inverse_w0 = c.positive(-3, 2);
      line.inverse_w1 = c.positive(-3, 2);
  }
  line.pixels = pixels;
  return line;
}

inline int any_every(Choices& c, int pixels) {
  switch (c.below(4)) {
    case 0:
      return 1;
    case 1:
      return pixels - int(c.below(std::uint64_t(std::min(3, pixels))));
    case 2:
      return std::min(pixels, 1 << c.below(13));
    default:
      return 1 + int(c.below(std::uint64_t(pixels)));
  }
}
inline SpanCase one_row(Choices& c, int pixels) {
  const Line line = any_line(c, pixels);
  return {"a row", line, any_every(c, pixels)};
}

// A row whose last span has one pixel, or one pixel less than the others.
inline SpanCase row_with_last_span(Choices& c) {
  const int every = 2 + int(c.below(15)), spans = 1 + int(c.below(5));
  const int pixels = every * spans + (c.flag() ? every - 1 : 1);
  return {"a row", any_line(c, pixels), every};
}

inline std::vector<InputClass<SpanCase>> generated_rows() {
  return {{"rows up to 32 pixels, with every distance between divisions", 10'000,
           [](Choices& c) {
             const int pixels = 1 + int(c.below(32));
             return one_row(c, pixels);
           }},
          {"rows whose last span is shorter", 5'000, row_with_last_span},
          {"one span, or a division in every pixel", 4'000,
           [](Choices& c) {
             const int pixels = any_pixels(c, 7);
             const int every = c.flag() ? pixels : 1;
             return SpanCase{"a row", any_line(c, pixels), every};
           }},
          {"rows up to 4096 pixels", 300, [](Choices& c) {
             const int pixels = c.flag() ? any_pixels(c, 12) : 4096 - int(c.below(100));
             return one_row(c, pixels);
           }}};
}

inline ChoiceCase any_choice(Choices& c, int pixels) {
  const Line line = any_line(c, pixels);
  const double larger = std::max(std::abs(line.u0), std::abs(line.u1));
  switch (c.below(8)) {
    case 0:
      return {line, 0};
    case 1:
      return {line, c.positive(-100, 99)};
    default:
      return {line, larger * c.positive(-24, 0)};
  }
}

// Over a row that is one span, 1/w changes by 9. A tolerance of half the coordinate's change,
// beside which the other one is, decides whether one span is enough.
inline ChoiceCase whole_row(Choices& c) {
  const double near = c.positive(-20, 19), change = c.real(-20, 19);
  const int pixels = 1 << (1 + c.below(9));
  Line line{0, change, near, near * 9, pixels};
  if (c.flag()) line = {0, change, near * 9, near, pixels};
  if (c.flag()) line = {change, 0, line.inverse_w0, line.inverse_w1, pixels};
  const auto size = int(20 + c.below(22));
  const double beside = std::ldexp(double(c.integer(-2, 2)), -size);
  return {line, std::abs(change) / 2 * (1 + beside)};
}

inline std::vector<InputClass<ChoiceCase>> generated_choices() {
  return {{"rows up to 64 pixels, and tolerances of every size", 12'000,
           [](Choices& c) {
             const int pixels = 1 + int(c.below(64));
             return any_choice(c, pixels);
           }},
          {"rows of a power of two, or of one pixel more or less", 3'000,
           [](Choices& c) {
             const int pixels = (1 << c.below(9)) + int(c.integer(-1, 1));
             return any_choice(c, std::max(1, pixels));
           }},
          {"tolerances next to the error of one span", 3'000, whole_row},
          {"rows up to 4096 pixels", 400, [](Choices& c) {
             const int pixels = c.flag() ? any_pixels(c, 12) : 4096 - int(c.below(100));
             return any_choice(c, pixels);
           }}};
}

// ---- footprints (task 8.4) ----

// A vector in steps of 1/256 pixel, of any size up to 2^bits.
struct Steps {
  std::int64_t x = 0, y = 0;
};
inline Steps any_steps(Choices& c, int bits) {
  const std::int64_t x = c.sized(bits);
  return {x, c.sized(bits)};
}
inline std::int64_t cross_of(const Steps& a, const Steps& b) {
  return a.x * b.y - a.y * b.x;
}

// Vertices at the given vectors from a pixel's centre. A vector is turned round where the centre
// would be outside the triangle.
inline FootprintCase around_pixel(Choices& c, std::array<Steps, 3> from_centre) {
  auto& [a, b, d] = from_centre;
  const std::int64_t parts[3] = {cross_of(b, d), cross_of(d, a), cross_of(a, b)};
  for (std::size_t k = 0; k < 3; ++k) {
    if (parts[k] < 0) from_centre[k] = {-from_centre[k].x, -from_centre[k].y};
  }
  if (parts[0] == 0 && parts[1] == 0 && parts[2] == 0)
    from_centre = {Steps{-256, -256}, Steps{768, -256}, Steps{-256, 768}};
  if (c.flag()) std::swap(from_centre[1], from_centre[2]);
  FootprintCase made{"a pixel", {}, 0, 0, 1, 1};
  made.x = double(c.sized(13)) + 0.5;
  made.y = double(c.sized(13)) + 0.5;
  for (std::size_t k = 0; k < 3; ++k) {
    made.triangle[k].x = made.x + double(from_centre[k].x) / 256;
    made.triangle[k].y = made.y + double(from_centre[k].y) / 256;
  }
  return made;
}
inline FootprintCase any_pixel_of_triangle(Choices& c, int bits) {
  const Steps a = any_steps(c, bits), b = any_steps(c, bits);
  return around_pixel(c, {a, b, any_steps(c, bits)});
}

inline int any_size(Choices& c) {
  return c.flag() ? 1 << c.below(15) : 1 + int(c.below(1 << 14));
}
// Gives the triangle's vertices 1/w and coordinates, and the texture its size.
inline FootprintCase textured(Choices& c, FootprintCase made) {
  const auto distances = c.below(3);
  const auto coordinates = c.below(4);
  const double far = c.real(-3, 10);
  for (TexturedVertex& vertex : made.triangle) {
    vertex.inverse_w = distances == 0   ? 1
                       : distances == 1 ? c.positive(-3, 2)
                                        : c.positive(-20, 19);
    for (double* each : {&vertex.u, &vertex.v}) {
      *each = coordinates == 0   ? c.multiple(-2, 2, 8)
              : coordinates == 1 ? c.real(-4, 3)
              : coordinates == 2 ? far * (1 + c.multiple(-4, 4, 16) / 16)
                                 : c.real(-20, 19);
    }
  }
  made.width = any_size(c);
  made.height = any_size(c);
  return made;
}

inline FootprintCase pixel_on_outline(Choices& c) {
  const Steps a = any_steps(c, 16), b = any_steps(c, 16);
  // In a vertex, or on an edge: the vectors to its ends have opposite directions.
  const std::int64_t back = c.integer(0, 16);
  std::array<Steps, 3> vertices{a, Steps{-a.x * back, -a.y * back}, b};
  std::rotate(vertices.begin(), vertices.begin() + std::ptrdiff_t(c.below(3)), vertices.end());
  return textured(c, around_pixel(c, vertices));
}

// A coordinate that is the same everywhere, or both of them.
inline FootprintCase constant_coordinates(Choices& c) {
  FootprintCase made = textured(c, any_pixel_of_triangle(c, 14));
  const bool both = c.flag(), second = c.flag();
  const TexturedVertex first = made.triangle[0];
  for (TexturedVertex& vertex : made.triangle) {
    if (both || !second) vertex.u = first.u;
    if (both || second) vertex.v = first.v;
  }
  return made;
}

// A triangle with legs along the axes that faces the eye, and a texture of which a pixel covers
// half a texel, one, two, ..., all of it, or a little more or less.
inline FootprintCase level_at_border(Choices& c) {
  const std::int64_t s = std::int64_t(64) << c.below(5);
  FootprintCase made = around_pixel(c, {Steps{-s, -s}, Steps{3 * s, -s}, Steps{-s, 3 * s}});
  made.width = any_size(c);
  made.height = any_size(c);
  const double leg = double(4 * s) / 256;
  const double inverse_w = c.positive(-20, 19);
  const bool turned = c.flag(), mirrored = c.flag();
  const auto level_u = int(c.integer(-2, 15)), level_v = int(c.integer(-2, 15));
  const double u = leg * std::ldexp(c.near(1.0), level_u) / made.width;
  const double v = leg * std::ldexp(c.near(1.0), level_v) / made.height;
  for (TexturedVertex& vertex : made.triangle) {
    vertex.inverse_w = inverse_w;
    const double x = vertex.x > made.x ? 1 : 0, y = vertex.y > made.y ? 1 : 0;
    vertex.u = (turned ? y : x) * u;
    vertex.v = (turned ? x : y) * (mirrored ? -v : v);
  }
  return made;
}

// A thin triangle: two of its vertices are almost opposite to each other, seen from the pixel.
inline FootprintCase thin_triangle(Choices& c) {
  const Steps a = any_steps(c, 14), off = any_steps(c, 4);
  const std::int64_t back = c.integer(1, 8);
  const Steps b{-a.x * back + off.x, -a.y * back + off.y};
  const std::int64_t part = c.integer(-8, 8);
  const Steps d{a.x * part / 8 + c.integer(-3, 3), a.y * part / 8 + off.y};
  return textured(c, around_pixel(c, {a, b, d}));
}

inline std::vector<InputClass<FootprintCase>> generated_footprints() {
  return {{"triangles of every size up to 2^14 pixels", 20'000,
           [](Choices& c) { return textured(c, any_pixel_of_triangle(c, 21)); }},
          {"triangles smaller than a few pixels", 15'000,
           [](Choices& c) { return textured(c, any_pixel_of_triangle(c, 9)); }},
          {"a pixel whose centre is in a vertex or on an edge", 10'000, pixel_on_outline},
          {"texture coordinates that do not change", 5'000, constant_coordinates},
          {"levels next to whole numbers, 0 and the last one among them", 10'000, level_at_border},
          {"thin triangles", 4'000, thin_triangle}};
}

}  // namespace inputs
}  // namespace lab_08
