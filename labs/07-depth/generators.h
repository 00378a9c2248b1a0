// The generated inputs of lab 7: up to 100,000 for each function, of all kinds that student.h names
// and of the borders between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "cases.h"
#include "labs/framework/choices.h"

namespace lab_07 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

inline Range any_range(Choices& c) {
  return c.one_of({Range::kStandard, Range::kReversed});
}

// ---- matrix entries (task 7.1) ----

inline Planes planes_apart(Choices& c, double near, double ratio) {
  return {near, near * ratio, any_range(c)};
}

inline std::vector<InputClass<Planes>> generated_planes() {
  return {{"planes of every size", 8'000,
           [](Choices& c) {
             const double near = c.positive(-500, 500);
             return planes_apart(c, near, 1 + c.positive(-30, 500));
           }},
          {"planes as close together as two doubles", 4'000,
           [](Choices& c) {
             const double near = c.positive(-900, 900);
             double far = near;
             const auto steps = c.integer(1, 4);
             for (std::int64_t i = 0; i < steps; ++i) far = std::nextafter(far, kInfinity);
             return Planes{near, far, any_range(c)};
           }},
          {"far planes beyond 10^30", 4'000,
           [](Choices& c) {
             const double near = c.positive(-20, 20);
             return Planes{near, c.positive(100, 1022), any_range(c)};
           }},
          {"an infinite far plane", 4'000, [](Choices& c) {
             const double near = c.positive(-1000, 1000);
             return Planes{near, kInfinity, any_range(c)};
           }}};
}

// ---- depths to distances (task 7.2) ----

inline Planes any_planes(Choices& c) {
  const double near = c.positive(-300, 150);
  switch (c.below(3)) {
    case 0:
      return {near, kInfinity, any_range(c)};
    case 1:
      return planes_apart(c, near, 1 + c.positive(-52, 0));
    default:
      return planes_apart(c, near, 1 + c.positive(0, 170));
  }
}

inline DistanceCase one_depth(const Planes& planes, double depth) {
  return {"a depth", planes, {depth}};
}

inline std::vector<InputClass<DistanceCase>> generated_depths() {
  return {{"depths of every size", 8'000,
           [](Choices& c) {
             const Planes planes = any_planes(c);
             return one_depth(planes, c.positive(-300, -1));
           }},
          {"depths next to 1", 6'000,
           [](Choices& c) {
             const Planes planes = any_planes(c);
             return one_depth(planes, 1 - c.positive(-53, -2));
           }},
          {"depths of both planes", 2'000,
           [](Choices& c) {
             const Planes planes = any_planes(c);
             return one_depth(planes, c.one_of({0.0, 1.0}));
           }},
          {"depths close to that of a distant far plane", 4'000, [](Choices& c) {
             const Planes planes = planes_apart(c, 1, c.positive(30, 60));
             const double from_far = c.positive(-60, -10);
             return one_depth(planes, planes.range == Range::kReversed ? from_far : 1 - from_far);
           }}};
}

// ---- codes (task 7.3) ----

inline Format any_format(Choices& c) {
  return kFormats[c.below(4)];
}
inline CodeCase one_code(Choices& c, double depth) {
  return {"a depth", any_format(c), {float(depth)}};
}

// A depth between 0 and 1: of every size, next to 0 or 1, or the smallest floats.
inline double depth_inside(Choices& c) {
  switch (c.below(4)) {
    case 0:
      return c.positive(-30, -1);
    case 1:
      return double(c.near(c.one_of({0.5f, 1.0f, 0.0f, 0x1p-126f})));
    case 2:
      return c.positive(-149, -100);
    default:
      return 1 - double(c.below(1 << 12)) * 0x1p-24;
  }
}
inline double depth_outside(Choices& c) {
  switch (c.below(5)) {
    case 0:
      return c.one_of({-0.0, 1.5, -0.25, 1e30, -1e30});
    case 1:
      return c.one_of({kInfinity, -kInfinity, 0x1.fffffep127, -0x1.fffffep127});
    case 2:
      return -c.positive(-149, 126);
    case 3:
      return c.positive(0, 126);
    default:
      return c.one_of({1 + 0x1p-23, -0x1p-149, -0x1p-126, 2.0, -1.0, 65536.0, 0x1p40});
  }
}

inline std::vector<InputClass<CodeCase>> generated_codes() {
  return {{"depths from 0 to 1", 40'000,
           [](Choices& c) {
             const double depth = depth_inside(c);
             return one_code(c, depth);
           }},
          {"halves between two codes of 16 bits, and the floats beside them", 20'000,
           [](Choices& c) {
             const auto tie = float((double(c.below(65535)) + 0.5) / 65535);
             return one_code(c, double(c.near(tie)));
           }},
          {"halves between two codes of 24 bits, and the floats beside them", 20'000,
           [](Choices& c) {
             const std::int64_t below = std::min<std::int64_t>(std::abs(c.sized(24)), 16777214);
             const auto tie = float((double(below) + 0.5) / 16777215);
             return one_code(c, double(c.near(tie)));
           }},
          {"depths outside 0 to 1, infinite ones too", 20'000, [](Choices& c) {
             const double depth = depth_outside(c);
             return one_code(c, depth);
           }}};
}

// ---- fragments (task 7.4) ----

inline BufferCase any_buffer(Choices& c, float (*depth)(Choices&)) {
  BufferCase made{"fragments", any_format(c), int(1 + c.below(4)), {}};
  const auto count = c.below(13);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto pixel = int(c.below(std::uint64_t(made.pixels)));
    made.fragments.push_back({pixel, depth(c)});
  }
  return made;
}

inline std::vector<InputClass<BufferCase>> generated_buffers() {
  return {
      {"fragments with few depths, both planes among them", 20'000,
       [](Choices& c) { return any_buffer(c, [](Choices& d) { return float(d.below(5)) / 4; }); }},
      {"depths a few floats apart", 10'000,
       [](Choices& c) {
         return any_buffer(c,
                           [](Choices& d) { return 0.75f + float(d.integer(-4, 4)) * 0x1p-24f; });
       }},
      {"depths of few steps of 16 or 24 bits", 10'000,
       [](Choices& c) {
         return any_buffer(c, [](Choices& d) {
           const double steps = d.flag() ? 16777215 : 65535;
           return float(double(d.below(9)) / 4 / steps);
         });
       }},
      {"depths outside 0 to 1", 10'000, [](Choices& c) {
         return any_buffer(c, [](Choices& d) {
           return float(d.flag() ? depth_outside(d) : d.one_of({0.0, 1.0, -0.0, 0x1p-149}));
         });
       }}};
}

// ---- the ladder (task 7.5) ----

// A rung at the given distance, moved inside if it is too near to one of the planes.
inline LadderCase one_rung(Choices& c, double near, double far, double d) {
  const Format format = any_format(c);
  const double last = std::isinf(far) ? near * 0x1p99 : far * (1 - 0x1p-13);
  return {"a rung", format, near, far, {std::clamp(d, near * (1 + 0x1p-13), last)}};
}
inline double any_far(Choices& c, double near) {
  return c.flag() ? near * c.positive(1, 99) : kInfinity;
}

inline std::vector<InputClass<LadderCase>> generated_ladders() {
  return {{"distances of every size", 6'000,
           [](Choices& c) {
             const double near = c.positive(-100, 100), far = any_far(c, near);
             return one_rung(c, near, far, near * c.positive(0, 98));
           }},
          {"distances next to the near plane", 4'000,
           [](Choices& c) {
             const double near = c.positive(-100, 100), far = any_far(c, near);
             return one_rung(c, near, far, near * (1 + c.positive(-13, 0)));
           }},
          {"distances next to the far plane", 4'000,
           [](Choices& c) {
             const double near = c.positive(-100, 100);
             const double far = near * c.positive(1, 30);
             return one_rung(c, near, far, far * (1 - c.positive(-13, -2)));
           }},
          {"distances where one step is about as large as the distance", 6'000, [](Choices& c) {
             const double near = c.positive(-30, 30);
             const double far = c.flag() ? near * c.positive(12, 40) : kInfinity;
             const double steps = c.one_of({65535.0, 16777215.0});
             return one_rung(c, near, far, near * steps * c.positive(-6, 2));
           }}};
}

}  // namespace inputs
}  // namespace lab_07
