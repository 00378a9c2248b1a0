#include <cstdlib>

#include "study/extremes/common/coverage.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/coverage.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c52 {

// Tests every multiple of 1/512 px near 0 and the neighbouring floats; then the same at 2^10 and
// 2^15 px, where floats are coarser.
Outcome measure_error(std::int32_t (*snap)(float)) {
  ErrorsAboveBound errors(0);
  const auto ask = [&](float pixels) {
    const auto right = std::int64_t(std::floor(double(pixels) * 256 + 0.5));
    errors.add(double(std::abs(std::int64_t(snap(pixels)) - right)));
  };
  for (const float base : {0.0f, 1024.0f, 32768.0f, -1024.0f}) {
    for (int k = -2048; k <= 2048; ++k) {
      const float tie = base + float(k) / 512.0f;
      for (const float pixels : {std::nextafter(tie, -1e9f), tie, std::nextafter(tie, 1e9f)}) {
        ask(pixels);
      }
    }
  }
  return errors.outcome("positions are snapped to another place");
}

// 4,096 small triangles whose corners are up to 3/4 of a snapping step away from pixel centres,
// including exactly half a step. A corner that is snapped to the wrong side changes pixels, because
// their centres are on the edges of the right triangle.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const CoverageReference ties(
      [] {
        Random random(152);
        std::vector<ScreenTriangle> all;
        for (int cell = 0; cell < 4096; ++cell) {
          const auto near_centre = [&](int at) {
            const double centre = at * 8 + double(random.integer(0, 7)) + 0.5;
            return centre + double(random.integer(-3, 3)) / 1024;
          };
          const auto corner = [&] {
            const double x = near_centre(cell % 64), y = near_centre(cell / 64);
            return screen_vertex(x, y);
          };
          all.push_back({corner(), corner(), corner()});
        }
        return all;
      }(),
      512);
  return ties.measure_error(engine);
}

}  // namespace c52

ExtremeCase c52_snap_ties() {
  using namespace c52;
  return {
      .id = "C-52",
      .name = "Ties of subpixel rounding",
      .construction =
          "positions k/512 px around 0, +-1024 and 32768 px, and their neighbours in float",
      .stage = "snap",
      .right_answer = "floor(256 v + 1/2), so halves are rounded up everywhere",
      .unit = "1/256 px",
      .oracle = Oracle::kInteger,
      .ours = {"halves are rounded up, exactly", [] { return measure_error(glassbox::snap); }},
      .naive = {"std::round, which rounds halves away from zero",
                [] { return measure_error(naive::snap_away); }},
      .mutants = {{"halves are rounded to even, as the processor does",
                   [] { return measure_error(naive::snap_to_even); }},
                  {"floor(256 v + 0.5), whose sum is rounded in float",
                   [] { return measure_error(naive::snap_float_half); }},
                  {"the position is truncated",
                   [] { return measure_error(naive::snap_truncating); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
