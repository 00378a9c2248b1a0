// Cameras as beginners first write them. Each one has an error; the pipeline uses none of them.
#pragma once

#include <cmath>

#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/look_at.h>

namespace glassbox::study::naive {

using WorldPoint = Point<World, double>;
using WorldVector = Vector<World, double>;

inline WorldVector normalise(const WorldVector& v) {
  const double length = std::sqrt(dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

inline Transform<Eye, World> view_matrix(const WorldVector& u, const WorldVector& v,
                                         const WorldVector& n, const WorldPoint& eye) {
  const WorldVector from_origin = eye - WorldPoint(0, 0, 0);
  Transform<Eye, World> m;
  int row = 0;
  for (const WorldVector& axis : {u, v, n}) {
    m.at(row, 0) = axis.x;
    m.at(row, 1) = axis.y;
    m.at(row, 2) = axis.z;
    m.at(row, 3) = -dot(axis, from_origin);
    ++row;
  }
  return m;
}

// Computes the axes of eye space without any checks: the result is 0/0 if up is parallel to the
// gaze or the eye is at the target (S4.6).
inline Result<Transform<Eye, World>> unchecked_look_at(const WorldPoint& eye,
                                                       const WorldPoint& target,
                                                       const WorldVector& up) {
  const WorldVector n = normalise(eye - target);
  const WorldVector u = normalise(cross(up, n));
  return view_matrix(u, cross(n, u), n, eye);
}

// The right code, but without its error for an up that is nearly parallel to the gaze.
inline Result<Transform<Eye, World>> look_at_without_limit(const WorldPoint& eye,
                                                           const WorldPoint& target,
                                                           const WorldVector& up) {
  const auto checked = look_at(eye, target, up);
  return checked || checked.error().place != "up" ? checked : unchecked_look_at(eye, target, up);
}

// The right code, but the given up is used as the axis V of eye space although it is not
// perpendicular to the gaze.
inline Result<Transform<Eye, World>> look_at_with_given_up(const WorldPoint& eye,
                                                           const WorldPoint& target,
                                                           const WorldVector& up) {
  return look_at(eye, target, up).map([&](const Transform<Eye, World>&) {
    const WorldVector n = normalise(eye - target);
    return view_matrix(normalise(cross(up, n)), normalise(up), n, eye);
  });
}

// The right code, computed in float.
inline Result<Transform<Eye, World>> look_at_in_float(const WorldPoint& eye,
                                                      const WorldPoint& target,
                                                      const WorldVector& up) {
  return look_at(eye, target, up).map([&](const Transform<Eye, World>&) {
    using V = Vector<World, float>;
    const auto normalised = [](const V& v) {
      const float length = std::sqrt(dot(v, v));
      return V(v.x / length, v.y / length, v.z / length);
    };
    const WorldVector back = eye - target;
    const V n = normalised(V(float(back.x), float(back.y), float(back.z)));
    const V u = normalised(cross(V(float(up.x), float(up.y), float(up.z)), n));
    const V v = cross(n, u);
    return view_matrix({u.x, u.y, u.z}, {v.x, v.y, v.z}, {n.x, n.y, n.z}, eye);
  });
}

// Rotates v to t as in a textbook: the axis is v x t divided by its length, the angle comes from
// the arccosine. The result is 0/0 if the two vectors are parallel.
inline Transform<World, World> rotation_between(const WorldVector& v, const WorldVector& t) {
  const WorldVector axis = normalise(cross(v, t));
  const double angle = std::acos(dot(v, t));
  const double s = std::sin(angle), c = std::cos(angle);
  const double x = axis.x, y = axis.y, z = axis.z, k = 1 - c;
  Transform<World, World> r;
  r.at(0, 0) = c + x * x * k;
  r.at(0, 1) = x * y * k - z * s;
  r.at(0, 2) = x * z * k + y * s;
  r.at(1, 0) = y * x * k + z * s;
  r.at(1, 1) = c + y * y * k;
  r.at(1, 2) = y * z * k - x * s;
  r.at(2, 0) = z * x * k - y * s;
  r.at(2, 1) = z * y * k + x * s;
  r.at(2, 2) = c + z * z * k;
  return r;
}

// Turns the gaze to the direction `towards`, then rolls about z until up is in the upper half of
// the yz plane.
inline Transform<Eye, World> axis_angle_view(const WorldPoint& eye, const WorldPoint& target,
                                             const WorldVector& up, const WorldVector& towards) {
  const auto turn = rotation_between(normalise(target - eye), towards);
  const WorldVector turned_up = turn * up;
  const double roll = std::atan2(turned_up.x, turned_up.y);
  Transform<World, World> about_z;
  about_z.at(0, 0) = about_z.at(1, 1) = std::cos(roll);
  about_z.at(0, 1) = -std::sin(roll);
  about_z.at(1, 0) = std::sin(roll);
  const auto m = about_z * turn * translate<World>(WorldPoint(0, 0, 0) - eye);
  return Transform<Eye, World>(m.columns);
}

// The angle of a rotation, from the arccosine of its trace. The cosine hardly changes near the
// angles 0 and pi, so a small error of the trace becomes a large error of the angle.
template <class T>
double arccosine_angle(const glm::mat<4, 4, T>& r) {
  const T cosine = (r[0][0] + r[1][1] + r[2][2] - 1) / 2;
  return double(std::acos(cosine < T(-1) ? T(-1) : cosine > T(1) ? T(1) : cosine));
}

}  // namespace glassbox::study::naive
