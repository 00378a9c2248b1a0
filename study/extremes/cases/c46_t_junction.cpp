#include <cstdlib>

#include "study/extremes/common/coverage.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c46 {

constexpr int kSide = 64;

// A triangle (a, b, top) above a long edge from a to b, and two triangles (a, m, bottom) and (m, b,
// bottom) below it, where m is as close to the edge as floats and snapping allow.
struct Junction {
  ScreenVertex a, b, m, top, bottom;

  std::vector<ScreenTriangle> with_junction() const {
    return {{a, b, top}, {a, m, bottom}, {m, b, bottom}};
  }
  std::vector<ScreenTriangle> with_vertex_inserted() const {
    return {{a, m, top}, {m, b, top}, {a, m, bottom}, {m, b, bottom}};
  }
};

Junction random_junction(Random& random) {
  const double ya = random.between(20, 44), yb = random.between(20, 44);
  const double xa = random.between(-4, 4), xb = random.between(60, 68);
  const double t = random.between(0.2, 0.8);
  return {screen_vertex(xa, ya), screen_vertex(xb, yb),
          screen_vertex(xa + t * (xb - xa), ya + t * (yb - ya)), screen_vertex(30, -40),
          screen_vertex(34, 110)};
}

// Counts the pixels near the edge, well inside the outer triangles, that are not covered exactly
// once.
int faults_along(const std::vector<ScreenTriangle>& triangles) {
  const Image<int> times = times_covered(pipeline_covers, triangles, kSide, kSide);
  int faults = 0;
  for (int y = 16; y < 48; ++y) {
    for (int x = 16; x < 48; ++x) faults += times.at(x, y) != 1;
  }
  return faults;
}

// Counts the pixels between the snapped vertex m and the edge from a to b, which are those of the
// triangle (a, m, b). These pixels are covered by no triangle or by two.
int predicted(const Junction& j) {
  const SnappedTriangle sliver = exact::snapped(ScreenTriangle{j.a, j.m, j.b});
  int pixels = 0;
  for (int y = 16; y < 48; ++y) {
    for (int x = 16; x < 48; ++x) pixels += covers_exactly(sliver, x, y) ? 1 : 0;
  }
  return pixels;
}

Outcome measure_error(bool insert_the_vertex, bool predict) {
  Random random(46);
  int faults = 0, foretold = 0;
  for (int i = 0; i < 2000; ++i) {
    const Junction j = random_junction(random);
    faults += faults_along(insert_the_vertex ? j.with_vertex_inserted() : j.with_junction());
    if (predict) foretold += std::abs(faults_along(j.with_junction()) - predicted(j));
  }
  return must_be_zero(
      faults + foretold,
      fmt::format("{} pixels along 2,000 edges are not covered exactly once{}", faults,
                  predict ? "; the wrong pixels at T-junctions are the predicted ones" : ""));
}

// Pictures with m inserted into the upper triangle too, and without that: no rasterizer can repair
// a T-junction, but it can be predicted which pixels are wrong.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<CoverageReference> junctions = [] {
    Random random(146);
    std::vector<CoverageReference> all;
    for (int i = 0; i < 24; ++i) {
      const Junction j = random_junction(random);
      all.emplace_back(j.with_vertex_inserted(), kSide);
      all.emplace_back(j.with_junction(), kSide);
    }
    return all;
  }();
  return worst_of(junctions, engine);
}

// The vertex m is inserted on both sides of the edge, but one side has a copy of it that is one
// snapping step lower.
Outcome measure_copies_error() {
  Random random(46);
  int faults = 0;
  for (int i = 0; i < 2000; ++i) {
    const Junction j = random_junction(random);
    ScreenVertex copy = j.m;
    copy.position.y += 0x1p-8f;
    faults += faults_along(
        {{j.a, j.m, j.top}, {j.m, j.b, j.top}, {j.a, copy, j.bottom}, {copy, j.b, j.bottom}});
  }
  return must_be_zero(
      faults, fmt::format("{} pixels along 2,000 edges are not covered exactly once", faults));
}

}  // namespace c46

ExtremeCase c46_t_junction() {
  using namespace c46;
  return {
      .id = "C-46",
      .name = "T-junction",
      .construction =
          "2,000 long edges with two triangles on one side that meet in a vertex on the edge, and "
          "one triangle on the other side",
      .stage = "coverage",
      .right_answer =
          "no pixel is wrong if the vertex is inserted into the long edge; otherwise exactly the "
          "pixels of the sliver between the snapped vertex and the edge are wrong, which no "
          "rasterizer can avoid",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"the vertex is inserted into the edge on both sides",
               [] { return measure_error(true, true); }},
      .naive = {"a mesh with T-junctions", [] { return measure_error(false, false); }},
      .mutants = {{"one side has a copy of the vertex 1/256 px lower", measure_copies_error}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
