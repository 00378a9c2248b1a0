#include <glassbox/render/plan/cluster_test.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <glassbox/base/rounding.h>
#include <glassbox/render/plan/box_place.h>

namespace glassbox {

namespace {

Vector<Object, double> sizes_of(const Vector<Object, double>& v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

}  // namespace

// As classify_box of clip.h, term by term, so that a cluster costs six products for a plane.
ClusterTest::HalfSpace ClusterTest::half_space(const ClipPlane& plane,
                                               const Transform<Clip, Object, float>& m) {
  const std::array<double, 4> coefficients{plane.a, plane.b, plane.c, plane.d};
  std::array<double, 4> slope{}, error{};
  for (int row = 0; row < 4; ++row) {
    const double coefficient = coefficients[std::size_t(row)];
    for (int k = 0; k < 4; ++k) {
      const double term = coefficient * double(m.at(row, k));
      slope[std::size_t(k)] += term;
      // Four roundings in float, and some twenty in double here and where the box is asked.
      error[std::size_t(k)] +=
          (gamma<float>(4) * (1 + 0x1p-40) + gamma<double>(20)) * std::abs(term);
    }
    error[3] += std::abs(coefficient) * 4 * 0x1p-149;  // products may be subnormal
  }
  error[3] += gamma<double>(20) * std::abs(plane.e);
  return {
      {slope[0], slope[1], slope[2]}, {error[0], error[1], error[2]}, slope[3] + plane.e, error[3]};
}

ClusterTest::ClusterTest(const Draw& draw, const View& view, Cull cull)
    : anchor_(double(draw.anchor.x), double(draw.anchor.y), double(draw.anchor.z)),
      cull_(certain_culling(draw, view, cull).test) {
  for (const ClipPlane& plane : picture_edges(view.viewport, kOutsideMarginPx)) {
    picture_edges_.push_back(half_space(plane, draw.clip_from_anchored));
  }
  if (place_box(draw, view).inside) return;
  for (const ClipPlane& plane : render_planes(view)) {
    clip_planes_.push_back(half_space(plane, draw.clip_from_anchored));
  }
}

ClusterVerdict ClusterTest::judge(const Cluster& cluster) const {
  const Point<Object, double> p = centre_of(cluster);
  const Vector<Object, double> centre{p.x - anchor_.x, p.y - anchor_.y, p.z - anchor_.z};
  const Vector<Object, double> half = half_size_of(cluster);
  const Vector<Object, double> farthest = sizes_of(centre) + half;
  struct Values {
    double least = 0, greatest = 0;  // as computed, anywhere in the box
  };
  const auto values = [&](const HalfSpace& side) {
    const double middle = dot(side.slope, centre) + side.offset;
    const double reach =
        dot(sizes_of(side.slope), half) + dot(side.error, farthest) + side.error_offset;
    return Values{middle - reach, middle + reach};
  };

  for (const HalfSpace& side : picture_edges_) {
    if (values(side).greatest < 0) return ClusterVerdict::kOutside;
  }
  bool uncut = true;
  for (const HalfSpace& side : clip_planes_) {
    const Values v = values(side);
    if (v.greatest < 0) return ClusterVerdict::kOutside;
    uncut = uncut && v.least >= 0;
  }
  return uncut && cull_ && cull_->removes_all(cluster) ? ClusterVerdict::kTurnedAway
                                                       : ClusterVerdict::kDrawn;
}

}  // namespace glassbox
