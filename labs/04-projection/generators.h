// The generated inputs of lab 4: up to 100,000 for each function, of all kinds that student.h names
// and of the borders between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "cases.h"
#include "labs/framework/choices.h"

namespace lab_04 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

inline constexpr double kPi = std::numbers::pi;  // the double nearest to pi
inline constexpr double kSmallest = 0x1p-1074;   // the smallest double

// A positive number of any size from 2^lowest to 2^highest.
inline double positive(Choices& c, int lowest, int highest) {
  return c.positive(lowest, highest - 1);
}
// A number of either sign or 0, of a size up to 2^highest.
inline double any_number(Choices& c, int highest) {
  return c.below(8) == 1 ? 0 : c.real(-highest, highest - 1);
}

// The next doubles after `value`, `steps` of them.
inline double steps_beyond(double value, std::int64_t steps) {
  const double towards = steps < 0 ? -kInfinity : kInfinity;
  for (std::int64_t i = steps < 0 ? -steps : steps; i > 0; --i)
    value = std::nextafter(value, towards);
  return value;
}

// ---- perspective views (task 4.1) ----

// An angle that is valid: of every size, close to the ends of its range, and plain ones.
inline double angle(Choices& c) {
  switch (c.below(4)) {
    case 0:
      return double(1 + c.below(31)) / 10;
    case 1:
      return positive(c, -300, 1);
    case 2:
      return kPi - positive(c, -51, 1);  // the doubles below pi are 2^-51 apart
    default:
      return c.near(kPi / 2);
  }
}
inline double aspect(Choices& c) {
  return c.flag() ? positive(c, -300, 300) : double(1 + c.below(64)) / 16;
}

inline Camera any_view(Choices& c) {
  const double fovy = angle(c), width_to_height = aspect(c), near = positive(c, -300, 298);
  return {fovy, width_to_height, near, near * 2 + positive(c, -300, 298)};
}
// A view of a usual shape, in which no entry is very large or very small.
inline Camera plain_view(Choices& c) {
  const double fovy = 0.5 + double(c.below(std::uint64_t(1) << 40)) * 0x1p-40 * 2.5;
  const double width_to_height = 0.5 + double(c.below(std::uint64_t(1) << 40)) * 0x1p-39;
  const double near = positive(c, -30, 1);
  return {fovy, width_to_height, near, near * 2 + positive(c, -10, 10)};
}
inline Camera far_by_far(Choices& c) {
  Camera view = plain_view(c);
  view.far = c.below(4) == 3 ? kInfinity : std::ldexp(view.near, int(c.integer(1, 70)));
  return view;
}
inline Camera far_beside_near(Choices& c) {
  Camera view = c.flag() ? any_view(c) : plain_view(c);
  view.far = c.flag() ? steps_beyond(view.near, c.integer(1, 40))
                      : view.near * (1 + std::ldexp(1.0, -int(c.below(50))));
  return view;
}

// A view with one number that is not valid, or is the last valid one on its side.
inline Camera view_at_the_border(Choices& c) {
  Camera view = plain_view(c);
  const double small = std::ldexp(1.0, -int(c.below(301)));
  const double negative = -positive(c, -1074, 1024);
  switch (c.below(4)) {
    case 0:
      view.fovy_radians = c.one_of({0.0, -0.0, small, -small, kPi, std::nextafter(kPi, 0.0),
                                    std::nextafter(kPi, 4.0), kPi + small, 2 * kPi, 3.2, 45.0, 90.0,
                                    negative, -kSmallest, kNaN, kInfinity, -kInfinity});
      break;
    case 1:
      view.aspect = c.one_of(
          {0.0, -0.0, small, -small, 1 / small, negative, -kSmallest, kNaN, kInfinity, -kInfinity});
      break;
    case 2:
      view.near =
          c.one_of({0.0, -0.0, small, -small, negative, -kSmallest, kNaN, kInfinity, -kInfinity});
      if (c.flag()) view.far = kInfinity;
      break;
    default:
      view.far = c.one_of({view.near, std::nextafter(view.near, 0.0),
                           std::nextafter(view.near, kInfinity), view.near * (1 - small), 0.0, -0.0,
                           -view.near, negative, kNaN, kInfinity, -kInfinity});
  }
  return view;
}

inline std::vector<InputClass<Camera>> generated_views() {
  return {{"views of moderate size", 10'000, plain_view},
          {"views of every size", 10'000, any_view},
          {"far planes up to 2^70 times the near plane, and at infinity (C-10)", 5'000, far_by_far},
          {"far planes just behind the near plane", 5'000, far_beside_near},
          {"numbers at and beyond the borders of what is valid (C-08, C-09)", 10'000,
           view_at_the_border}};
}

// ---- parallel views (task 4.2) ----

// Two different numbers in their order, of any size up to 2^302 and at least 2^-300 apart.
struct Range {
  double low, high;
};
inline Range any_range(Choices& c) {
  if (c.flag()) {  // one end anywhere, and the other near it or far from it
    const double low = any_number(c, 298);
    const double high = low + positive(c, -299, 298);
    if (high > low) return {low, high};
    // What was added is at most half a step of `low`, so its neighbours are far enough apart.
    if (c.flag()) return {low, steps_beyond(low, c.integer(1, 20))};
    return {low, low + std::fabs(low)};
  }
  const double half = positive(c, -299, 298);
  const double middle = half * c.multiple(-8, 8, 4);
  return {middle - half, middle + half};
}
inline Range plain_range(Choices& c) {
  const double low = c.multiple(-1000, 1000, 7);
  return {low, low + double(1 + c.below(std::uint64_t(1) << 40)) * 0x1p-30};
}

template <Range (*kRange)(Choices&)>
Box box_of(Choices& c) {
  const Range x = kRange(c), y = kRange(c), z = kRange(c);
  return {x.low, x.high, y.low, y.high, z.low, z.high};
}

inline std::vector<InputClass<Box>> generated_boxes() {
  return {{"boxes of moderate size", 20'000, box_of<plain_range>},
          {"boxes of every size, in front of the eye and behind it", 20'000, box_of<any_range>}};
}

// ---- dialects (task 4.3) ----

inline Dialect any_dialect(Choices& c) {
  return c.one_of({Dialect::kOpenGl, Dialect::kReversed, Dialect::kLeftHandedEye});
}

// A matrix with any entries, of which few or many are 0; w of clip space may depend on everything.
inline DialectCase any_matrix(Choices& c) {
  DialectCase made{"any matrix", any_dialect(c), {}};
  const int size = int(c.integer(-500, 500)), spread = c.one_of({0, 4, 60, 400});
  const std::uint64_t zeros = c.below(4);
  for (int i = 0; i < 16; ++i) {
    const bool is_zero = c.below(4) < zeros;
    const double entry = c.real(size - spread, size + spread);
    made.m.at(i / 4, i % 4) = is_zero ? 0 : entry;
  }
  return made;
}
// The rows of z and w are the same, the double or the negative of each other, or beside that.
inline DialectCase cancelling_matrix(Choices& c) {
  DialectCase made{"z cancels w", any_dialect(c), {}};
  for (int i = 0; i < 4; ++i) {
    const double entry = c.real(-3, 3);
    made.m.at(3, i) = entry;
    made.m.at(2, i) = c.near(entry * c.one_of({0.5, 1.0, 2.0, -1.0}));
    made.m.at(0, i) = c.real(-60, -20);
    made.m.at(1, i) = c.real(-60, -20);
  }
  return made;
}

inline std::vector<InputClass<DialectCase>> generated_matrices() {
  return {{"matrices of every kind", 30'000, any_matrix},
          {"matrices in which z and w nearly cancel", 10'000, cancelling_matrix}};
}

// ---- the divide (task 4.4) ----

using ClipPoint = Point<Clip, double>;

// A coordinate whose quotient by w is about 2^size, or 0.
inline double coordinate_for(Choices& c, double w, int size) {
  if (c.below(8) == 7) return c.one_of({0.0, -0.0});
  const double factor = c.real(0, 0);
  const double value = std::ldexp(factor * w, size);
  return std::isfinite(value) ? value : w;
}
// A point whose coordinates in NDC have any sizes from 2^-60 to 2^60.
inline ClipPoint point_with_w(Choices& c, double w) {
  const int size = int(c.integer(-30, 30)), spread = c.one_of({0, 2, 30});
  const auto size_of = [&] { return size + int(c.integer(-spread, spread)); };
  const int size_x = size_of(), size_y = size_of(), size_z = size_of();
  const double x = coordinate_for(c, w, size_x), y = coordinate_for(c, w, size_y);
  return {x, y, coordinate_for(c, w, size_z), w};
}

inline std::vector<InputClass<ClipPoint>> generated_points() {
  return {{"points in front of the eye", 40'000,
           [](Choices& c) {
             const double w = positive(c, -20, 20);
             return point_with_w(c, w);
           }},
          {"w of every size", 20'000,
           [](Choices& c) {
             const double w = positive(c, -1074, 1024);
             return point_with_w(c, w);
           }},
          {"w so small that 1/w overflows (C-33)", 10'000,
           [](Choices& c) {
             const double w = double(1 + c.below(std::uint64_t(1) << c.below(50))) * kSmallest;
             return point_with_w(c, w);
           }},
          {"w so large that 1/w loses digits", 10'000,
           [](Choices& c) {
             const double w = positive(c, 1021, 1024);
             return point_with_w(c, w);
           }},
          {"w at 1 and one step beside it", 10'000,
           [](Choices& c) {
             const double w = c.near(1.0);
             ClipPoint p = point_with_w(c, w);
             // Divided by the number before 1, the largest one here is still finite.
             if (c.flag())
               p.z = c.one_of({-0.0, 0.0, kSmallest, -kSmallest, 0x1.ffffffffffffep1023});
             return p;
           }},
          {"w at 0, below it, and NaN", 10'000, [](Choices& c) {
             const double below = -positive(c, -1074, 1024);
             const double w = c.one_of({0.0, -0.0, kSmallest, -kSmallest, below, kNaN});
             ClipPoint p = point_with_w(c, w > 0 ? w : 1);
             p.w = w;
             return p;
           }}};
}

// ---- the viewport (task 4.5) ----

// A depth: in the picture, beyond it, and numbers whose bits are easily lost.
inline double any_depth(Choices& c) {
  const double real = c.real(-1074, 1023);
  return c.one_of({0.0, 1.0, 0.5, -0.0, -1.0, -0.25, 1.5, std::nextafter(0.0, -1.0),
                   std::nextafter(1.0, 2.0), kSmallest, kInfinity, -kInfinity, kNaN, real, real});
}
// A coordinate in NDC: in the picture, at its edges, and beyond it.
inline double ndc(Choices& c, int largest) {
  switch (c.below(4)) {
    case 0:
      return c.near(c.one_of({0.0, 1.0, -1.0, 0.5, -0.5}));
    case 1:
      return c.real(-1074, -1);
    case 2:
      return double(c.integer(-(std::int64_t(1) << 52), std::int64_t(1) << 52)) * 0x1p-52;
    default:
      return c.real(0, largest);
  }
}
inline ViewportCase any_viewport(Choices& c) {
  const int largest = c.one_of({1, 7, 63});
  const double x = ndc(c, largest), y = ndc(c, largest), z = any_depth(c);
  const double left = any_number(c, 32), top = any_number(c, 32);
  const double width = positive(c, -32, 32);
  return {{x, y, z}, {left, top, width, positive(c, -32, 32)}};
}
// A rectangle of whole pixels, as windows have.
inline ViewportCase window(Choices& c) {
  const double x = ndc(c, 1), y = ndc(c, 1), z = any_depth(c);
  const auto left = double(c.sized(14)), top = double(c.sized(14));
  const auto width = double(c.integer(1, 32768));
  return {{x, y, z}, {left, top, width, double(c.integer(1, 32768))}};
}

inline std::vector<InputClass<ViewportCase>> generated_viewports() {
  return {{"windows of whole pixels", 50'000, window},
          {"rectangles of every size, and points far outside", 50'000, any_viewport}};
}

// ---- distances (task 4.6) ----

// A depth in [0, 1]: of every size, close to 1, and its ends.
inline double depth_in_range(Choices& c) {
  switch (c.below(5)) {
    case 0:
      return double(c.below(17)) / 16;
    case 1:
      return positive(c, -1074, 0);
    case 2:
      return 1 - positive(c, -53, 0);
    case 3:
      return steps_beyond(1, -std::int64_t(c.below(8)));
    default:
      return double(c.below(std::uint64_t(1) << 53)) * 0x1p-53;
  }
}

inline std::vector<InputClass<DepthCase>> generated_depths() {
  return {{"planes as of most scenes", 40'000,
           [](Choices& c) {
             const double depth = depth_in_range(c), near = positive(c, -10, 4);
             return DepthCase{depth, near, near * (1 + positive(c, -4, 16))};
           }},
          {"far planes up to 2^80 times the near plane, and just behind it (C-10, C-20)", 40'000,
           [](Choices& c) {
             const double depth = depth_in_range(c), near = positive(c, -200, 200);
             const double far = c.flag() ? near * (1 + positive(c, -50, 80))
                                         : steps_beyond(near, c.integer(1, 20));
             return DepthCase{depth, near, far};
           }},
          {"a far plane at infinity", 20'000, [](Choices& c) {
             const double depth = depth_in_range(c);
             return DepthCase{depth, positive(c, -200, 200), kInfinity};
           }}};
}

}  // namespace inputs
}  // namespace lab_04
