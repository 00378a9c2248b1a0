#include <cstdlib>

#include "study/extremes/kit/coverage.h"
#include "study/extremes/kit/drawn_coverage.h"
#include "study/extremes/kit/extreme_case.h"
#include "study/naive/coverage.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c52 {

// Tests every k/512 px near 0 and the neighbouring floats; then the same at 2^10 and 2^15 px, where
// floats are coarse.
Outcome judge(std::int32_t (*snap)(float)) {
  ErrorsBeyond errors(0);
  const auto ask = [&](float pixels) {
    const auto right = std::int64_t(std::floor(double(pixels) * 256 + 0.5));
    errors.see(double(std::abs(std::int64_t(snap(pixels)) - right)));
  };
  for (const float base : {0.0f, 1024.0f, 32768.0f, -1024.0f}) {
    for (int k = -2048; k <= 2048; ++k) {
      const float tie = base + float(k) / 512.0f;
      for (const float pixels : {std::nextafter(tie, -1e9f), tie, std::nextafter(tie, 1e9f)}) {
        ask(pixels);
      }
    }
  }
  return errors.outcome("positions snapped to another place");
}

// 4,096 small triangles whose corners are up to 3/4 of a snapping step away from pixel centres,
// including exactly half a step. A corner that is snapped to the wrong side changes pixels, because
// their centres are on the edges of the right triangle.
Outcome judge_drawn(const Drawer& by) {
  static const CoverageDrawn ties(
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
  return ties.judge(by);
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
      .right = "floor(256 v + 1/2), the same everywhere: halves go up",
      .unit = "1/256 px",
      .oracle = Oracle::kInteger,
      .ours = {"halves up, exactly", [] { return judge(glassbox::snap); }},
      .naive = {"std::round: halves away from zero", [] { return judge(naive::snap_away); }},
      .mutants = {{"halves to even, as the processor rounds",
                   [] { return judge(naive::snap_to_even); }},
                  {"floor(256 v + 0.5) with a rounded sum",
                   [] { return judge(naive::snap_float_half); }},
                  {"truncation", [] { return judge(naive::snap_truncating); }}},
      .drawn = judge_drawn,
  };
}

}  // namespace glassbox::study
