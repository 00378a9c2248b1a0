// Lab 3: your part. student.h says what each function must do, handout.md why.
#include "student.h"

#include <algorithm>
#include <cmath>

namespace lab_03 {

// BEGIN SOLUTION
using Direction = Vector<World, double>;

static double length(const Direction& v) {
  return std::sqrt(dot(v, v));
}

// The vector divided by its length, which may be as small or as large as a double can be: it is
// divided by its largest component first, so that no square overflows or becomes 0.
static Direction unit(const Direction& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const Direction near{v.x / largest, v.y / largest, v.z / largest};
  const double l = length(near);
  return {near.x / l, near.y / l, near.z / l};
}

static bool is_finite(double x, double y, double z) {
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
}

// The view matrix p -> R p - R e: the rows of R are the axes of the eye, e is its position.
static Transform<Eye, World> view_of(const Direction& x, const Direction& y, const Direction& z,
                                     const Point<World, double>& eye) {
  const Direction axes[3] = {x, y, z};
  const Direction e{eye.x, eye.y, eye.z};
  Transform<Eye, World> m;
  for (int i = 0; i < 3; ++i) {
    m.at(i, 0) = axes[i].x;
    m.at(i, 1) = axes[i].y;
    m.at(i, 2) = axes[i].z;
    m.at(i, 3) = -dot(axes[i], e);
  }
  return m;
}
// STUB:
// END SOLUTION

// ---- task 3.1: the axes of the eye ----

std::optional<Transform<Eye, World>> uvn_view(const Camera& camera) {
  // BEGIN SOLUTION
  const auto& [eye, target, up] = camera;
  if (!is_finite(eye.x, eye.y, eye.z) || !is_finite(target.x, target.y, target.z) ||
      !is_finite(up.x, up.y, up.z))
    return std::nullopt;
  const Direction gaze = target - eye;
  if (length(gaze) == 0 || length(up) == 0) return std::nullopt;
  const Direction n = gaze * (-1 / length(gaze));
  const Direction across = cross(up * (1 / length(up)), n);
  if (length(across) < 0x1p-20) return std::nullopt;
  const Direction right = across * (1 / length(across));
  return view_of(right, cross(n, right), n, eye);
  // STUB: return Transform<Eye, World>(glm::dmat4(NAN));  // [U, -U.e; V, -V.e; N, -N.e]
  // END SOLUTION
}

// ---- task 3.2: one direction onto another ----

Transform<World, World> rotation_onto(const Vector<World, double>& from,
                                      const Vector<World, double>& to) {
  // BEGIN SOLUTION
  const Direction f = unit(from), t = unit(to);
  Direction axis = cross(f, t);
  const double sine = length(axis), cosine = dot(f, t);
  if (sine > 0) {
    axis = axis * (1 / sine);
  } else {
    // A vector perpendicular to f is the cross product of f with the coordinate axis that is
    // furthest from the direction of f.
    const double x = std::abs(f.x), y = std::abs(f.y), z = std::abs(f.z);
    const Direction far = x <= y && x <= z ? Direction{1, 0, 0}
                          : y <= z         ? Direction{0, 1, 0}
                                           : Direction{0, 0, 1};
    axis = cross(f, far) * (1 / length(cross(f, far)));
  }
  const double a[3] = {axis.x, axis.y, axis.z};
  const double angle = std::atan2(sine, cosine);
  const double c = sine > 0 ? std::cos(angle) : (cosine < 0 ? -1 : 1), s = sine;
  Transform<World, World> m;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    m.at(i, i) = a[i] * a[i] * (1 - c) + c;
    m.at(i, j) = a[i] * a[j] * (1 - c) - a[k] * s;
    m.at(j, i) = a[i] * a[j] * (1 - c) + a[k] * s;
  }
  return m;
  // STUB: return Transform<World, World>(glm::dmat4(NAN));  // the smallest rotation
  // END SOLUTION
}

// ---- task 3.3: two rotations ----

Transform<Eye, World> axis_angle_view(const Camera& camera) {
  // BEGIN SOLUTION
  const Direction gaze = camera.target - camera.eye;
  const Direction ahead{0, 0, -1};
  const Transform<World, World> turn = rotation_onto(gaze, ahead);
  const Direction up = turn * camera.up;
  // The second rotation is about z, by the angle that makes the x of `up` 0 and its y positive.
  const double across = std::sqrt(up.x * up.x + up.y * up.y);
  const double c = up.y / across, s = up.x / across;
  const auto row = [&](int i) { return Direction{turn.at(i, 0), turn.at(i, 1), turn.at(i, 2)}; };
  return view_of(row(0) * c - row(1) * s, row(0) * s + row(1) * c, row(2), camera.eye);
  // STUB: return Transform<Eye, World>(glm::dmat4(NAN));  // Rz(roll) R(axis, angle) T(-eye)
  // END SOLUTION
}

// ---- task 3.4: rotation or mirror ----

Kind kind_of(const Transform<World, World>& matrix) {
  // BEGIN SOLUTION
  const auto column = [&](int j) {
    return Direction{matrix.at(0, j), matrix.at(1, j), matrix.at(2, j)};
  };
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!(std::abs(dot(column(i), column(j)) - (i == j ? 1 : 0)) <= 1e-5)) return Kind::kNeither;
    }
  }
  const double determinant = dot(cross(column(0), column(1)), column(2));
  return determinant > 0 ? Kind::kRotation : Kind::kMirror;
  // STUB: return Kind::kUnknown;
  // END SOLUTION
}

// ---- task 3.5: the other hand ----

Transform<Clip, Eye> for_right_handed_eye(const Transform<Clip, Eye>& clip_from_left_handed_eye) {
  // BEGIN SOLUTION
  Transform<Clip, Eye> m = clip_from_left_handed_eye;
  for (int i = 0; i < 4; ++i) m.at(i, 2) = -m.at(i, 2);
  return m;
  // STUB: return Transform<Clip, Eye>(glm::dmat4(NAN));  // the projection after diag(1, 1, -1, 1)
  // END SOLUTION
}

}  // namespace lab_03
