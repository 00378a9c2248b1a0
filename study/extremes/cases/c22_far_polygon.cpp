#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>

#include "study/extremes/common/drawn_normals.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/polygons.h"
#include "study/naive/normals.h"

namespace glassbox::study {
namespace c22 {

Outcome measure_error(PolygonNormal normal) {
  WorstError worst;
  for (const double offset : {0.0, 1e2, 1e4, 1e6}) {
    Polygon octagon;
    for (int i = 0; i < 8; ++i) {
      const SinCos turn = sin_cos_degrees(45.0 * i);
      // The polygon is tilted, so that all three components matter.
      octagon.emplace_back(float(offset + turn.cos), float(offset + turn.sin),
                           float(offset + 0.5 * turn.cos - 0.25 * turn.sin));
    }
    // The corners count as exact after they are rounded to float, because the test is made with the
    // rounded polygon. In double, differences of floats are exact here. The bound of Newell's sums
    // is gamma_(N+3) sum |difference| |sum| (docs/references.md, bound 6), with N = 8 edges shorter
    // than 1.1 and sums below 5, measured from the first corner, in three components. The bound of
    // the angle is this divided by |m|, the length of Newell's vector, which is above 5.
    const double bound = gamma<double>(11) * std::sqrt(3.0) * 8 * 1.1 * 5 / 5;
    worst.add(angle_to(normal(octagon), exact_newell(octagon)), bound,
              fmt::format("offset {:g}", offset), 1 + offset);
  }
  return worst.outcome();
}

Vector<Object, double> newell_in_float(std::span<const Point<Object>> polygon) {
  const auto m = newell_vector<float>(polygon);
  return {m.x, m.y, m.z};
}

// The octagon and similar polygons, each moved back to the origin by the matrix of its node.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<NormalTestMesh> meshes = [] {
    std::vector<NormalTestMesh> all;
    for (const double offset : {0.0, 1e2, 1e4, 1e6}) {
      for (const double lean : {0.5, -0.25}) {
        Polygon octagon;
        for (int i = 0; i < 8; ++i) {
          const SinCos turn = sin_cos_degrees(45.0 * i);
          octagon.emplace_back(float(offset + turn.cos), float(offset + turn.sin),
                               float(offset + lean * turn.cos - 0.25 * turn.sin));
        }
        const Vector<World, double> back{-offset, -offset, -offset};
        all.push_back(make_normal_test_mesh(mesh_of(octagon), translate<World, Object>(back),
                                            exact_newell(octagon)));
      }
    }
    return all;
  }();
  return measure_normal_error(engine, meshes, Shading::kFlat, kShownNormal);
}

}  // namespace c22

ExtremeCase c22_far_polygon() {
  using namespace c22;
  return {
      .id = "C-22",
      .name = "A polygon far from the origin",
      .construction = "a tilted octagon of radius 1 at 0, 1e2, 1e4 and 1e6 along each axis",
      .stage = "face normals",
      .right_answer =
          "the normal is the rational Newell vector of the same floats, to gamma_11 in double, "
          "because coordinates are relative to the first corner",
      .unit = "radian",
      .oracle = Oracle::kRational,
      .ours = {"newell_vector", [] { return measure_error(newell_in_double); }},
      .naive = {"Newell's sums of the coordinates as they are (S4.33), in float",
                [] { return measure_error(naive::raw_newell<float>); }},
      .mutants = {{"Newell's sums relative to the first corner, but in float",
                   [] { return measure_error(newell_in_float); }},
                  {"Newell's sums with a minus in place of a plus",
                   [] { return measure_error(naive::newell_of_differences); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
