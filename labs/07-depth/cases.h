// The inputs of lab 7's test cases: for the runner, which calls the student's functions, and for
// the checks, which compute the expected answers.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <glassbox/base/random.h>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_07 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::Random;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Planes {
  double near = 0.1, far = 1e4;
  Range range = Range::kStandard;
};

// ---- matrix entries (task 7.1) ----

inline std::vector<Planes> planes() {
  return {{1, 2, Range::kStandard},           {0.1, 1e4, Range::kStandard},
          {0.5, kInfinity, Range::kStandard}, {1, 2, Range::kReversed},
          {0.1, 1e4, Range::kReversed},       {0.25, kInfinity, Range::kReversed}};
}

// BEGIN HIDDEN
inline std::vector<Planes> more_planes() {
  std::vector<Planes> all;
  for (const Range range : {Range::kStandard, Range::kReversed}) {
    for (const auto& [near, far] : {std::pair{1e-3, 1e9},
                                    {3.0, 3.0009765625},
                                    {7.0, 11.0},
                                    {1e5, kInfinity},
                                    {2.0, 3e40},
                                    {3e160, 7e160}})
      all.push_back({near, far, range});
  }
  return all;
}
// END HIDDEN

// ---- depths to distances (task 7.2) ----

struct DistanceCase {
  const char* what;
  Planes planes;
  std::vector<double> depths;
};

inline std::vector<DistanceCase> depths() {
  const std::vector<double> some{0, 0.25, 0.5, 0.9, 0.999, 1};
  return {{"near and far of similar size, standard depth", {1, 4, Range::kStandard}, some},
          {"near and far of similar size, reversed depth", {1, 4, Range::kReversed}, some},
          {"far / near = 10^5, standard (C-10)", {0.1, 1e4, Range::kStandard}, some},
          {"far / near = 10^5, reversed (C-10)", {0.1, 1e4, Range::kReversed}, some},
          {"an infinite far plane", {0.1, kInfinity, Range::kStandard}, some}};
}

// BEGIN HIDDEN
inline std::vector<DistanceCase> more_depths() {
  DistanceCase close{"depths close to 1 with far / near = 10^9", {1e-2, 1e7, Range::kStandard}, {}};
  for (int k = 10; k <= 50; k += 4) close.depths.push_back(1 - std::ldexp(1.0, -k));
  DistanceCase small{"small depths of the reversed range", {1e-2, 1e7, Range::kReversed}, {}};
  for (int k = 10; k <= 50; k += 4) small.depths.push_back(std::ldexp(1.0, -k));
  DistanceCase infinite{"small reversed depths, with an infinite far plane",
                        {0.3, kInfinity, Range::kReversed},
                        small.depths};
  infinite.depths.push_back(0);
  return {close, small, infinite};
}
// END HIDDEN

// ---- codes (task 7.3) ----

struct CodeCase {
  std::string what;
  Format format = Format::kUnorm16;
  std::vector<float> depths;
};

inline constexpr Format kFormats[] = {Format::kUnorm16, Format::kUnorm24, Format::kFloat32,
                                      Format::kFloat32Reversed};
inline const char* name_of(Format format) {
  const char* const names[] = {"16 bits", "24 bits", "float", "reversed float"};
  return names[int(format)];
}

inline std::vector<CodeCase> codes() {
  std::vector<CodeCase> all;
  for (const Format format : kFormats)
    all.push_back({std::string(name_of(format)) +
                       ": depths 0 and 1, the middle, and depths outside [0, 1] (C-61)",
                   format,
                   {0.0f, 1.0f, 0.5f, 0.75f, 0.1f, 1 - 0x1p-24f, -0.25f, 1.5f, -0.0f}});
  return all;
}

// BEGIN HIDDEN
inline std::vector<CodeCase> more_codes() {
  std::vector<CodeCase> all;
  Random random = glassbox::labs::varied(71);
  for (const Format format : kFormats) {
    CodeCase c{std::string(name_of(format)) + ": random depths", format, {}};
    for (int i = 0; i < 200; ++i) c.depths.push_back(float(random.unit()));
    all.push_back(c);
    c = {std::string(name_of(format)) + ": halves and the floats next to them (C-61)", format, {}};
    const double steps = format == Format::kUnorm16 ? 65535 : 16777215;
    for (int k = 1; k < int(steps); k += int(steps) / 37) {
      const float tie = float((k + 0.5) / steps);
      c.depths.insert(c.depths.end(), {std::nextafter(tie, 0.0f), tie, std::nextafter(tie, 1.0f)});
    }
    all.push_back(c);
  }
  return all;
}
// END HIDDEN

// ---- fragments (task 7.4) ----

struct BufferCase {
  std::string what;
  Format format = Format::kFloat32;
  int pixels = 0;
  std::vector<Fragment> fragments;
};

inline std::vector<BufferCase> buffers() {
  return {{"the nearer fragment is seen, whichever comes first",
           Format::kFloat32,
           3,
           {{0, 0.5f}, {0, 0.25f}, {1, 0.25f}, {1, 0.5f}}},
          {"reversed depth: the larger depth is nearer",
           Format::kFloat32Reversed,
           3,
           {{0, 0.5f}, {0, 0.25f}, {1, 0.25f}, {1, 0.5f}}},
          {"the same surface twice: the first stays (C-58)",
           Format::kUnorm24,
           4,
           {{0, 0.5f}, {1, 0.5f}, {2, 0.75f}, {0, 0.5f}, {1, 0.5f}, {2, 0.75f}, {2, 0.75f}}},
          {"fragments on the far plane, and an empty pixel",
           Format::kUnorm24,
           3,
           {{0, 1.0f}, {2, 1.0f}, {2, 0.0f}}},
          {"fragments on the far plane, with reversed depth (C-62)",
           Format::kFloat32Reversed,
           3,
           {{0, 0.0f}, {2, 0.0f}, {2, 1.0f}}},
          {"depths that 16 bits cannot tell apart (C-64)",
           Format::kUnorm16,
           2,
           {{0, 0.500006f}, {0, 0.5f}, {1, 0.50002f}, {1, 0.5f}}}};
}

// BEGIN HIDDEN
inline std::vector<BufferCase> more_buffers() {
  std::vector<BufferCase> all;
  Random random = glassbox::labs::varied(72);
  for (const Format format : kFormats) {
    // Depths of few different values, including 0 and 1, so that ties are frequent.
    BufferCase c{std::string(name_of(format)) + ": many fragments, many of them with equal depths",
                 format,
                 40,
                 {}};
    for (int i = 0; i < 400; ++i)
      c.fragments.push_back({int(random.integer(0, 39)), float(random.integer(0, 16)) / 16});
    all.push_back(c);
    c = {std::string(name_of(format)) + ": surfaces a few steps apart", format, 40, {}};
    for (int i = 0; i < 400; ++i)
      c.fragments.push_back(
          {int(random.integer(0, 39)), 0.75f + float(random.integer(-200, 200)) * 0x1p-24f});
    all.push_back(c);
  }
  return all;
}
// END HIDDEN

// ---- the ladder (task 7.5) ----

struct LadderCase {
  std::string what;
  Format format = Format::kUnorm16;
  double near = 0.1, far = 1e4;
  std::vector<double> distances;
};

inline std::vector<LadderCase> ladders() {
  std::vector<LadderCase> all;
  for (const Format format : kFormats)
    all.push_back({std::string(name_of(format)) + ": the table from 0.15 to 9000 (C-56)",
                   format,
                   0.1,
                   1e4,
                   {0.15, 1, 10, 100, 1000, 9000}});
  return all;
}

// BEGIN HIDDEN
inline std::vector<LadderCase> more_ladders() {
  std::vector<LadderCase> all;
  for (const Format format : kFormats) {
    all.push_back({std::string(name_of(format)) + ": an infinite far plane",
                   format,
                   0.25,
                   kInfinity,
                   {0.3, 3, 70, 900, 5e5, 3e7}});
    all.push_back({std::string(name_of(format)) + ": near and far of similar size",
                   format,
                   5,
                   10,
                   {5.7, 7, 9.5, 9.9999}});
    all.push_back({std::string(name_of(format)) + ": depths next to a half (C-56)",
                   format,
                   1,
                   kInfinity,
                   {1.999999996, 2.000000004}});
  }
  return all;
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_07
