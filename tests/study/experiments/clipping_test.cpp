// D-32: clipping with the pyramid in eye space leaves the same polygon as clipping with the box in
// clip space (S3-11).
#include <cmath>

#include "exact/clip.h"
#include "exact/number.h"
#include "study/experiments/d32_clippers.h"
#include "tests/study/experiments/check_experiment.h"

namespace glassbox::test {
namespace {

using namespace study;
using exact::ExactPoint;
using exact::ExactPolygon;
using exact::Rational;

// A lens with near 1 and far 2, for which depth and offset are exact floats.
d32::Lens exact_lens() {
  d32::Lens lens = d32::course_lens();
  lens.depth = -2, lens.offset = -2;
  lens.near = 1, lens.far = 2;
  return lens;
}

// The planes of the pyramid, for points with w = 1, in the order of frustum_planes.
std::array<ClipPlane, 6> pyramid(const d32::Lens& lens) {
  const double a = double(lens.a), b = double(lens.b);
  return {{{0, 0, -1, -double(lens.near), 0, "near"},
           {0, 0, 1, double(lens.far), 0, "far"},
           {a, 0, -1, 0, 0, "left"},
           {-a, 0, -1, 0, 0, "right"},
           {0, b, -1, 0, 0, "bottom"},
           {0, -b, -1, 0, 0, "top"}}};
}

ExactPoint<Rational> project(const d32::Lens& lens, const ExactPoint<Rational>& p) {
  const auto exactly = [](float x) { return Rational(double(x)); };
  return {exactly(lens.a) * p.x, exactly(lens.b) * p.y,
          exactly(lens.depth) * p.z + exactly(lens.offset), -p.z};
}

TEST_CASE("in exact arithmetic the pyramid and the box leave the same polygon (S3-11)") {
  const d32::Lens lens = exact_lens();
  int cut = 0, empty = 0, whole = 0;
  for (const d32::EyeTriangle& triangle : d32::random_triangles(0.25, 600)) {
    ExactPolygon<Rational> in_eye, in_clip;
    for (const Point<Eye>& p : triangle) {
      in_eye.push_back({Rational(double(p.x)), Rational(double(p.y)), Rational(double(p.z)), 1});
      in_clip.push_back(project(lens, in_eye.back()));
    }
    in_eye = exact::clip(in_eye, std::span<const ClipPlane>(pyramid(lens)));
    in_clip = exact::clip(in_clip, std::span<const ClipPlane>(frustum_planes()));
    REQUIRE(in_eye.size() == in_clip.size());
    ++(in_eye.empty() ? empty : in_eye.size() == 3 ? whole : cut);
    for (std::size_t i = 0; i < in_eye.size(); ++i) {
      const ExactPoint<Rational> p = project(lens, in_eye[i]), &q = in_clip[i];
      CHECK((p.x == q.x && p.y == q.y && p.z == q.z && p.w == q.w));
    }
  }
  CHECK(cut > 20);
  CHECK(whole > 2);
  CHECK(empty > 20);
}

TEST_CASE("in floats both leave as many vertices, nearly all in the same places") {
  const d32::EyeSpace eye{d32::course_lens()};
  const d32::ClipSpace box{d32::course_lens()};
  double farthest = 0;
  int polygons = 0, vertices = 0, apart = 0;
  for (const d32::EyeTriangle& triangle : d32::random_triangles(0.25, 20000)) {
    d32::Outline a, b;
    d32::clip(eye, triangle, a);
    d32::clip(box, triangle, b);
    REQUIRE(a.count == b.count);
    polygons += a.count > 3;
    for (std::size_t i = 0; i < a.count; ++i) {
      const Point<Clip>&p = a.vertices[i], &q = b.vertices[i];
      CHECK(a.cut_by[i] == b.cut_by[i]);
      const double across = std::abs(double(p.x) / p.w - double(q.x) / q.w) * 512;
      const double down = std::abs(double(p.y) / p.w - double(q.y) / q.w) * 342;
      REQUIRE((std::isfinite(across) && std::isfinite(down)));
      const double distance = std::max(across, down);
      farthest = std::max(farthest, distance);
      ++vertices;
      apart += !(distance <= 1e-3);
    }
  }
  WARN("S3-11: of " << vertices << " vertices " << apart << " more than 0.001 px apart, at most "
                    << farthest << " px");
  CHECK(polygons > 1000);
  // The roundings of an edge's ends, 2^-24 of 512 px, move its crossing with a plane by that much
  // divided by the sine of the angle: by more than 0.001 px for a sine below 1/33, which 2 % of
  // random directions have.
  CHECK(apart < vertices / 50);
}

TEST_CASE("D-32: the box's vertices lie on the picture's edges, and the pyramid's beside them") {
  const auto all = check_experiment(d32_clipping());
  CHECK(largest_error(all, "clip space, against the box") == 0);
  const double beside = largest_error(all, "eye space, against the viewing pyramid");
  CHECK(beside > 0);
  CHECK(beside < 1e-4);  // px: three roundings, 3 * 2^-24 * 512
}

}  // namespace
}  // namespace glassbox::test
