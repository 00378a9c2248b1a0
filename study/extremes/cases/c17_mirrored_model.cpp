#include <glassbox/pipeline/affine.h>

#include <string>

#include "study/extremes/cases/cases.h"
#include "study/extremes/kit/normals_case.h"
#include "study/extremes/kit/worst.h"
#include "study/naive/transform.h"
#include "study/random.h"

namespace glassbox::study {
namespace {

Vector<World, double> axis_from(Random& random) {
  const double x = random.between(-1, 1), y = random.between(-1, 1);
  return {x, y, random.between(0.1, 1)};
}

// The outward normals of a cube must point away from the centre of what any map makes of it.
Outcome judge(TransformNormal transform) {
  Random random(717);
  int inward = 0, all = 0;
  for (int i = 0; i < 200; ++i) {
    const auto sign = [&] { return random.integer(0, 1) == 0 ? -1.0 : 1.0; };
    const auto map =
        rotate_degrees<World>(axis_from(random), random.between(0, 360)).value() *
        scale<World, Object>(sign() * random.between(0.1, 3), sign() * random.between(0.1, 3),
                             sign() * random.between(0.1, 3));
    for (int axis = 0; axis < 3; ++axis) {
      for (const float side : {-1.0f, 1.0f}) {
        const Normal<Object> n(axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0);
        const Normal<World> outward = transform(map, n);
        const Vector<World, double> centre = map * Vector<Object, double>(n.x, n.y, n.z);
        const double along = double(outward.x) * centre.x + double(outward.y) * centre.y +
                             double(outward.z) * centre.z;
        inward += !(along > 0);
        ++all;
      }
    }
  }
  return wrong_of(inward, all, "normals point inwards");
}

// The cross product of two edges, as one computes it from the vertices in the world: their order turns round in a mirror.
Normal<World> by_edges(const Transform<World, Object>& m, const Normal<Object>& n) {
  const Vector<Object, double> normal(n.x, n.y, n.z);
  const Vector<Object, double> u(normal.y, normal.z, normal.x);  // perpendicular for an axis
  const Vector<Object, double> v = cross(normal, u);
  const Vector<World, double> crossed = cross(m * u, m * v);
  return {float(crossed.x), float(crossed.y), float(crossed.z)};
}

}  // namespace

ExtremeCase c17_mirrored_model() {
  return {
      .id = "C-17",
      .name = "A mirrored model",
      .construction =
          "cubes under 200 rotations and scales by -3 .. 3 of each axis, half of them "
          "mirrors",
      .stage = "normals",
      .right =
          "every outward normal stays outward: the sign of the determinant is part of the "
          "map",
      .unit = "normals",
      .oracle = Oracle::kProperty,
      .ours = {"normal_transform", [] { return judge(by_cofactors); }},
      .naive = {"cross product of transformed edges", [] { return judge(by_edges); }},
      .mutants = {{"no sign of the determinant", [] { return judge(naive::normal_without_sign); }}},
  };
}

}  // namespace glassbox::study
