#include <array>

#include "study/extremes/cases/clip_case.h"
#include "study/extremes/kit/extreme_case.h"

namespace glassbox::study {
namespace c42 {

using Verdict = ClipVerdict (*)(std::span<const Outcode>);

Outcome judge(Verdict verdict) {
  Random random(742);
  const auto planes = frustum_planes();
  int wrong = 0, spared = 0;
  constexpr int kTriangles = 20000;
  for (int i = 0; i < kTriangles; ++i) {
    // Small ones, most of which are wholly inside or outside.
    const Point<Clip> a = random_position(random, 0.5, 1.5);
    const auto beside = [&] {
      const double x = random.between(-0.5, 0.5), y = random.between(-0.5, 0.5);
      return Point<Clip>{a.x + float(x), a.y + float(y), a.z + float(random.between(-0.2, 0.2)),
                         a.w};
    };
    const Point<Clip> b = beside();
    const ClipTriangle t = clip_corners(a, b, beside());
    std::array<Outcode, 3> codes;
    for (std::size_t k = 0; k < 3; ++k) codes[k] = outcode(t[k].position, planes);
    const Outline clipped = pipeline_clips(t, planes);
    const ClipVerdict found = verdict(codes);
    const Outline whole{t[0].position, t[1].position, t[2].position};
    wrong += (found == ClipVerdict::kAccept && clipped != whole) ||
             (found == ClipVerdict::kReject && !clipped.empty());
    spared += found != ClipVerdict::kClip;
  }
  if (spared < kTriangles / 10) return must_be_zero(HUGE_VAL, "hardly any clipping spared");
  return wrong_of(wrong, kTriangles, "triangles differ from the clipped ones",
                  fmt::format("; clipping spared for {}", spared));
}

// Outside is outside, whichever the planes: loses what reaches across a corner of the picture.
ClipVerdict all_corners_outside(std::span<const Outcode> codes) {
  bool any = false, all = true;
  for (const Outcode code : codes) {
    any = any || code != 0;
    all = all && code != 0;
  }
  return all ? ClipVerdict::kReject : any ? ClipVerdict::kClip : ClipVerdict::kAccept;
}
ClipVerdict one_corner_inside(std::span<const Outcode> codes) {
  for (const Outcode code : codes) {
    if (code == 0) return ClipVerdict::kAccept;
  }
  return trivial_verdict(codes);
}

}  // namespace c42

ExtremeCase c42_trivial_accept() {
  using namespace c42;
  return {
      .id = "C-42",
      .name = "Clipping spared",
      .construction = "20000 small triangles in and around the frustum",
      .stage = "clip",
      .right = "what is accepted is what clipping returns, bit for bit; what is rejected, nothing",
      .unit = "triangles",
      .oracle = Oracle::kProperty,
      .ours = {"trivial_verdict of the outcodes", [] { return judge(trivial_verdict); }},
      .naive = {"rejected where every corner is outside",
                [] { return judge(all_corners_outside); }},
      .mutants = {{"accepted where one corner is inside", [] { return judge(one_corner_inside); }}},
  };
}

}  // namespace glassbox::study
