// The generated inputs of lab 9: up to 100,000 for each function, of all kinds that student.h names
// and of the borders between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cases.h"
#include "labs/framework/choices.h"

namespace lab_09 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

// ---- projections (task 9.1) ----

inline Pair any_pair(Choices& c) {
  const double window = c.below(6) == 5 ? kInfinity : c.positive(-40, 40);
  return {c.positive(-40, 40), window};
}

inline ProjectionCase any_projection(Choices& c, const Pair& pair) {
  const double scale = c.positive(-6, 6);
  const double off_middle = c.flag() ? c.real(-10, 2) : 0;
  const double a = c.one_of({-1.25, -1.0, 0.0, 0.25}), b = c.one_of({-1.25, -2.0, 0.1, 5.0});
  const bool parallel = c.flag();
  ProjectionCase made{"a projection",
                      parallel ? parallel_matrix(scale, off_middle, a, b)
                               : perspective_matrix(scale, off_middle, a, b),
                      pair};
  // A picture that is not square, with its middle above or below the gaze.
  made.centre.at(1, 1) = c.positive(-6, 6);
  made.centre.at(1, parallel ? 3 : 2) = c.flag() ? c.real(-10, 2) : 0;
  return made;
}

inline std::vector<InputClass<ProjectionCase>> generated_projections() {
  return {{"perspective and parallel projections, windows at every distance", 6'000,
           [](Choices& c) {
             const Pair pair = any_pair(c);
             return any_projection(c, pair);
           }},
          {"no separation", 2'000,
           [](Choices& c) {
             const Pair pair{0, any_pair(c).window};
             return any_projection(c, pair);
           }},
          {"a window at infinity", 2'000, [](Choices& c) {
             const Pair pair{c.positive(-40, 40), kInfinity};
             return any_projection(c, pair);
           }}};
}

// ---- parallax (task 9.2) ----

inline ParallaxCase one_parallax(Choices& c, const Pair& pair, double distance) {
  const auto width = int(1 + c.below(20'000));
  return {"a distance", pair, {c.positive(-6, 6), width}, distance};
}

inline std::vector<InputClass<ParallaxCase>> generated_distances() {
  return {{"distances of every size", 8'000,
           [](Choices& c) {
             const Pair pair{c.positive(-100, 100), c.positive(-300, 300)};
             return one_parallax(c, pair, c.positive(-300, 300));
           }},
          {"distances close to the window's, or equal to it", 8'000,
           [](Choices& c) {
             const Pair pair{c.positive(-10, 10), c.positive(-300, 300)};
             const double off = c.flag() ? c.real(-52, -2) : 0;
             return one_parallax(c, pair, pair.window * (1 + off));
           }},
          {"no separation, a distance or a window that is infinite", 4'000, [](Choices& c) {
             Pair pair{c.positive(-10, 10), c.positive(-300, 300)};
             double distance = c.positive(-300, 300);
             const auto which = c.below(4);
             if (which == 0) pair.half_separation = 0;
             if (which == 1 || which == 3) distance = kInfinity;
             if (which == 2 || which == 3) pair.window = kInfinity;
             return one_parallax(c, pair, distance);
           }}};
}

// ---- triangles (task 9.3) ----

// A coordinate relative to w: on a plane, one ulp beside it, inside or outside.
inline float beside_planes(Choices& c, float w, bool outside_above) {
  switch (c.below(6)) {
    case 0:
      return outside_above ? 2 * std::abs(w) + 1 : -2 * std::abs(w) - 1;
    case 1:
      return c.near(outside_above ? w : -w);
    case 2:
      return c.near(c.flag() ? w : -w);
    case 3:
      return c.near(0.0f);
    case 4:
      return w * float(c.integer(-6, 6)) / 4;
    default:
      return outside_above ? c.near(w) : c.near(-w);
  }
}
inline float any_w(Choices& c) {
  switch (c.below(6)) {
    case 0:
      return c.one_of({1.0f, 8.0f, -1.0f, 0.0f, -0.0f});
    case 1:
      return float(c.real(-149, 123));
    default:
      return float(c.real(-3, 6));
  }
}

// Each coordinate of one kind, or of all, tends to one side for all three corners, so that many
// triangles are outside. With `outside`, each eye misses the triangle at its left or right side,
// unless a corner is spared.
inline CullCase any_triangle(Choices& c, bool outside) {
  CullCase made{"a triangle", {}, {}};
  std::array<StereoPoint, 3> triangle;
  const std::uint64_t tends = outside ? 4 : c.below(4);
  const bool left_above = c.flag(), right_above = c.flag(), above = c.flag();
  for (StereoPoint& p : triangle) {
    p.w = any_w(c);
    p.left_x = p.right_x = p.y = 0;
    p.z = p.w / 2;
    if (tends == 0 || tends == 3 || tends == 4) {
      p.left_x = beside_planes(c, p.w, left_above);
      p.right_x = beside_planes(c, p.w, right_above);
    }
    if (tends == 1 || tends == 3) p.y = beside_planes(c, p.w, above);
    if (tends == 2 || tends == 3) p.z = above ? beside_planes(c, p.w, true) : c.near(0.0f);
    if (tends == 2 && c.flag()) p.z = c.one_of({-1.0f, -0.0f, -0x1p-149f, -9.0f}) * p.w;
  }
  if (outside) {
    const auto spared = c.below(4);
    for (std::size_t k = 0; k < 3; ++k) {
      StereoPoint& p = triangle[k];
      if (k == spared) continue;
      p.left_x = (left_above ? 1.0f : -1.0f) * (std::abs(p.w) + 1);
      p.right_x = (right_above ? 1.0f : -1.0f) * (std::abs(p.w) + 1);
    }
  }
  made.add("generated", triangle);
  return made;
}

inline float any_float(Choices& c) {
  return c.below(8) == 7 ? c.one_of({0.0f, -0.0f, 0x1.fffffep127f, -0x1.fffffep127f})
                         : float(c.real(-149, 126));
}

inline std::vector<InputClass<CullCase>> generated_triangles() {
  return {{"corners on the planes and one ulp beside them", 60'000,
           [](Choices& c) { return any_triangle(c, false); }},
          {"triangles that one eye or both miss", 30'000,
           [](Choices& c) { return any_triangle(c, true); }},
          {"numbers of every size and sign", 10'000, [](Choices& c) {
             CullCase made{"a triangle", {}, {}};
             std::array<StereoPoint, 3> triangle;
             for (StereoPoint& p : triangle)
               p = {any_float(c), any_float(c), any_float(c), any_float(c), any_float(c)};
             made.add("generated", triangle);
             return made;
           }}};
}

// ---- anaglyphs (task 9.4) ----

inline Rgba8 any_colour(Choices& c) {
  const auto byte = [&c] { return std::uint8_t(c.below(256)); };
  return {byte(), byte(), byte(), byte()};
}

inline AnaglyphCase any_anaglyph(Choices& c, float (*depth)(Choices&)) {
  const Lenses lenses = c.one_of({Lenses::kRedCyan, Lenses::kGreenMagenta, Lenses::kAmberBlue});
  const int width = int(1 + c.below(3)), height = int(1 + c.below(2));
  AnaglyphCase made = anaglyph_case("fragments", lenses, width, height);
  // The masks the other way round: the right eye has the left eye's channels.
  if (c.flag()) std::swap(made.anaglyph.left_mask, made.anaglyph.right_mask);
  made.anaglyph.background = any_colour(c);
  for (auto* fragments : {&made.anaglyph.left, &made.anaglyph.right}) {
    const auto count = c.below(6);
    for (std::uint64_t i = 0; i < count; ++i) {
      const int x = int(c.below(std::uint64_t(width))), y = int(c.below(std::uint64_t(height)));
      const float at = depth(c);
      fragments->push_back({x, y, at, any_colour(c)});
    }
  }
  return made;
}

inline std::vector<InputClass<AnaglyphCase>> generated_anaglyphs() {
  return {{"depths of every size from 0 to 1", 6'000,
           [](Choices& c) {
             return any_anaglyph(c, [](Choices& d) { return float(d.positive(-149, -1)); });
           }},
          {"depths of a few neighbouring floats", 6'000,
           [](Choices& c) {
             return any_anaglyph(
                 c, [](Choices& d) { return 0.75f + float(d.integer(-2, 2)) * 0x1p-24f; });
           }},
          {"both ends of depth, and the floats beside them", 4'000, [](Choices& c) {
             return any_anaglyph(c, [](Choices& d) {
               return d.one_of({1.0f, 0.0f, 1 - 0x1p-24f, -0.0f, 0x1p-149f, 0x1p-126f});
             });
           }}};
}

// ---- colours (task 9.5) ----

// A number from 0 to 1.
inline double fraction(Choices& c) {
  switch (c.below(4)) {
    case 0:
      return c.one_of({0.0, 1.0});
    case 1:
      return double(c.below(256)) / 255;
    case 2:
      return c.positive(-60, -1);
    default:
      return double(c.below(std::uint64_t(1) << 53)) * 0x1p-53;
  }
}

inline ColourCase any_colours(Choices& c, const Matrix& matrix) {
  const auto colour = [&c] { return Colour{fraction(c), fraction(c), fraction(c)}; };
  const Recolour recolour{fraction(c), fraction(c)};
  const Colour left = colour();
  return {"colours", matrix, recolour, left, colour()};
}

inline std::vector<InputClass<ColourCase>> generated_colours() {
  return {{"any matrix", 6'000,
           [](Choices& c) {
             Matrix matrix;
             for (auto& row : matrix) {
               for (double& entry : row) entry = double(c.integer(-1000, 1000)) / 3000;
             }
             return any_colours(c, matrix);
           }},
          {"the matrices of masks and of Dubois", 4'000, [](Choices& c) {
             const bool dubois = c.flag();
             return any_colours(c, dubois ? dubois_matrix() : mask_matrix());
           }}};
}

// ---- sequences of frames (task 9.6) ----

inline Frame any_frame(Choices& c, double unit) {
  const double window = c.below(6) == 5 ? kInfinity : unit * c.positive(-5, 5);
  const double from = std::isinf(window) || c.flag() ? unit : window;
  // Near to the window, on it, or of any size.
  const double nearest = c.below(4) == 3 ? from : from * c.positive(-4, 3);
  const auto which = c.below(4);
  double farthest = nearest;
  if (which == 1) farthest = nearest * (1 + c.positive(-10, 10));
  if (which == 2) farthest = std::max(nearest, std::isinf(window) ? nearest : window);
  if (which == 3) farthest = kInfinity;
  return {nearest, farthest, window};
}

inline ComfortCase any_sequence(Choices& c, std::uint64_t longest, double release_frames) {
  const Picture picture{c.positive(-3, 4), int(1 + c.below(8192))};
  const double front = c.below(4) == 3 ? 0 : c.positive(-3, 9);
  const double behind = c.below(4) == 3 ? 0 : c.positive(-3, 9);
  const double unit = c.positive(-30, 30);
  ComfortCase made{"frames", picture, {front, behind}, {}, release_frames};
  const auto count = 1 + c.below(longest);
  for (std::uint64_t i = 0; i < count; ++i) made.frames.push_back(any_frame(c, unit));
  return made;
}

inline std::vector<InputClass<ComfortCase>> generated_sequences() {
  return {
      {"frames that do not depend on each other", 2'000,
       [](Choices& c) { return any_sequence(c, 3, 0); }},
      {"sequences, with numbers of frames to release that are whole or not", 4'000, [](Choices& c) {
         const double release = double(c.below(200)) / 8;
         return any_sequence(c, 8, release);
       }}};
}

}  // namespace inputs
}  // namespace lab_09
