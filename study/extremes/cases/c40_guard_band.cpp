#include <set>

#include <glassbox/raster/rasterise_polygon.h>

#include "exact/coverage.h"
#include "study/extremes/cases/clip_case.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

namespace glassbox::study {
namespace c40 {

using exact::Decimal;
constexpr int kSide = 256, kStep = 8;

using Pixels = std::set<std::pair<int, int>>;
using Covers = Pixels (*)(const ClipTriangle&, const Viewport&);

bool sampled(int x, int y) {
  return x % kStep == kStep / 2 && y % kStep == kStep / 2;
}

// Returns 1 inside, -1 outside, and 0 where rounding may decide, which is within 2^-7 px of an
// edge: 2^-9 px for a clipped vertex (half an ulp of 2^15 px), 2^-9 px each for the quotient and
// the viewport, and 2^-9 px for snapping. Computed with 168 bits: with corners 2^100 px away, the
// error of the cross product is 2^(200 - 168) = 2^32, much less than the 2^93 that correspond to
// 2^-7 px.
int exact_side(const std::array<std::array<Decimal, 2>, 3>& corners, int x, int y) {
  const Decimal px = Decimal(x) + Decimal(0.5), py = Decimal(y) + Decimal(0.5);
  int signs[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &a = corners[k], &b = corners[(k + 1) % 3];
    const Decimal dx = b[0] - a[0], dy = b[1] - a[1];
    const Decimal cross = dx * (py - a[1]) - dy * (px - a[0]);
    // |cross| / |edge| is the distance from the edge.
    if (cross * cross <= (dx * dx + dy * dy) * Decimal(0x1p-14)) return 0;
    signs[k] = cross.sign();
  }
  return signs[0] == signs[1] && signs[1] == signs[2] ? 1 : -1;
}

Outcome measure_error(Covers covers) {
  const Viewport viewport{0, 0, kSide, kSide};
  int wrong = 0, samples = 0;
  double worst_px = 0;
  for (const double px : {32767.99, 32768.0, 32768.01, 1e6, 1e9, 1e30}) {
    // Converts pixels, counted from the picture's centre, to NDC; converting back is exact for a
    // picture of 2^8 pixels.
    const auto at = [](double x, double y) {
      return Point<Clip>{float(x / 128), float(y / 128), 0.5f, 1};
    };
    for (const ClipTriangle& t : {clip_corners(at(-100, -100), at(px, px / 2), at(-100, 60)),
                                  clip_corners(at(-px, -70), at(90, -px), at(30, px)),
                                  clip_corners(at(-px, -px), at(px, -px), at(0, px))}) {
      std::array<std::array<Decimal, 2>, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const Decimal half(kSide / 2);
        corners[k] = {half * (Decimal(1) + Decimal(double(t[k].position.x))),
                      half * (Decimal(1) - Decimal(double(t[k].position.y)))};
      }
      const Pixels found = covers(t, viewport);
      for (int y = kStep / 2; y < kSide; y += kStep) {
        for (int x = kStep / 2; x < kSide; x += kStep) {
          const int side = exact_side(corners, x, y);
          if (side == 0) continue;
          ++samples;
          const bool differs = found.contains({x, y}) != (side > 0);
          wrong += differs;
          if (differs) worst_px = std::max(worst_px, px);
        }
      }
    }
  }
  return wrong_count_outcome(
      wrong, samples, "pixels differ from the exact ones",
      wrong > 0 ? fmt::format("; corners up to {:g} px away", worst_px) : "");
}

Pixels covered_by(const Outline& outline, const Viewport& viewport) {
  Pixels pixels;
  for_each_covered(outline, viewport, {0, 0, kSide, kSide}, [&](const Coverage& pixel) {
    if (sampled(pixel.x, pixel.y)) pixels.insert({pixel.x, pixel.y});
  });
  return pixels;
}

Pixels ours(const ClipTriangle& t, const Viewport& viewport) {
  return covered_by(pipeline_clips(t, guard_band_planes(viewport)), viewport);
}

// Rasterizes without a guard band: positions become 32-bit integers, and edges are computed in 128
// bits, so that only the conversion to integers is wrong.
template <class ToInteger>
Pixels without_guard_band(const ClipTriangle& t, ToInteger to_integer) {
  exact::SnappedTriangle snapped;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = 128 + 128 * double(t[k].position.x), y = 128 - 128 * double(t[k].position.y);
    snapped[k] = {to_integer(std::floor(x * 256 + 0.5)), to_integer(std::floor(y * 256 + 0.5))};
  }
  Pixels pixels;
  for (int y = kStep / 2; y < kSide; y += kStep) {
    for (int x = kStep / 2; x < kSide; x += kStep) {
      if (exact::covers<exact::Integer>(snapped, x, y)) pixels.insert({x, y});
    }
  }
  return pixels;
}
// Converts as x86 processors do: a number that does not fit becomes the smallest integer.
Pixels as_x86_converts(const ClipTriangle& t, const Viewport&) {
  return without_guard_band(t, [](double v) {
    return std::abs(v) < 0x1p31 ? std::int32_t(v) : std::numeric_limits<std::int32_t>::min();
  });
}
Pixels clamped(const ClipTriangle& t, const Viewport&) {
  return without_guard_band(
      t, [](double v) { return std::int32_t(std::min(std::max(v, -0x1p23), 0x1p23)); });
}
Pixels kept_to_24_bits(const ClipTriangle& t, const Viewport&) {
  return without_guard_band(t, [](double v) {
    const double turn = std::fmod(v, 0x1p24);
    return std::int32_t(turn >= 0x1p23 ? turn - 0x1p24 : turn < -0x1p23 ? turn + 0x1p24 : turn);
  });
}

// Triangles with far corners in eye space, up to 10^9 px outside the picture.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    Random random(840);
    std::vector<RayCastReference> all;
    for (int i = 0; i < 48; ++i) {
      // The corners are far away in all directions, or only to the left and right, or only up and
      // down.
      EyeTriangle t;
      for (Point<Eye>& p : t) {
        const double far = std::pow(10, random.between(0, 7));
        p = {float(random.between(-1, 1) * (i % 3 == 2 ? 1 : far)),
             float(random.between(-1, 1) * (i % 3 == 1 ? 1 : far)), float(random.between(-4, -1))};
      }
      all.emplace_back(make_ray_scene({t}, PerspectiveLens{1.0, 0.5, 8.0}, 64));
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c40

ExtremeCase c40_guard_band() {
  using namespace c40;
  return {
      .id = "C-40",
      .name = "At the guard band and far beyond it",
      .construction =
          "triangles with corners 32767.99 .. 1e30 px from the centre of a 256 x 256 picture, "
          "every eighth pixel",
      .stage = "clip",
      .right_answer =
          "the covered pixels are those of the exact triangle, except pixels within 2^-7 px of its "
          "edges",
      .unit = "pixels",
      .oracle = Oracle::kExtended,
      .ours = {"clip_triangle by the guard band", [] { return measure_error(ours); }},
      .naive = {"no guard band, and 32-bit integers",
                [] { return measure_error(as_x86_converts); }},
      .mutants = {{"coordinates are clamped to the guard band",
                   [] { return measure_error(clamped); }},
                  {"only 24 bits of each coordinate are kept",
                   [] { return measure_error(kept_to_24_bits); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
