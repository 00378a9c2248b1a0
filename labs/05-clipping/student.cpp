#include "student.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lab_05 {

namespace {

// Your own helpers go here.
// BEGIN SOLUTION
double distance(const Plane& plane, const Point<Clip>& p) {
  return plane.a * p.x + plane.b * p.y + plane.c * p.z + plane.d * p.w;
}
// STUB:
// END SOLUTION

}  // namespace

bool is_back_face(const std::vector<Point<World>>& face, const Point<World>& eye) {
  // BEGIN SOLUTION
  // Newell's sums use every corner, so that a reflex corner cannot reverse the normal.
  double mx = 0, my = 0, mz = 0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Point<World>&p = face[i], &n = face[(i + 1) % face.size()];
    mx += (double(p.y) - n.y) * (double(p.z) + n.z);
    my += (double(p.z) - n.z) * (double(p.x) + n.x);
    mz += (double(p.x) - n.x) * (double(p.y) + n.y);
  }
  const double sx = double(face[0].x) - eye.x;
  const double sy = double(face[0].y) - eye.y;
  const double sz = double(face[0].z) - eye.z;
  return sx * mx + sy * my + sz * mz > 0;
  // STUB: throw std::logic_error("5.1: is_back_face is not written yet");
  // END SOLUTION
}

std::uint32_t outcode(const Point<Clip>& p) {
  // BEGIN SOLUTION
  // The conditions are negated, so that a NaN is outside: every comparison with NaN is false.
  std::uint32_t code = 0;
  if (!(p.z >= 0)) code |= kNear;
  if (!(p.z <= p.w)) code |= kFar;
  if (!(p.x >= -p.w)) code |= kLeft;
  if (!(p.x <= p.w)) code |= kRight;
  if (!(p.y >= -p.w)) code |= kBottom;
  if (!(p.y <= p.w)) code |= kTop;
  return code;
  // STUB: throw std::logic_error("5.2: outcode is not written yet");
  // END SOLUTION
}

Verdict trivial_verdict(const std::vector<std::uint32_t>& outcodes) {
  // BEGIN SOLUTION
  std::uint32_t every = ~0u, any = 0;
  for (const std::uint32_t code : outcodes) {
    every &= code;
    any |= code;
  }
  if (any == 0) return Verdict::kAccept;
  return every != 0 ? Verdict::kReject : Verdict::kClip;
  // STUB: throw std::logic_error("5.2: trivial_verdict is not written yet");
  // END SOLUTION
}

Point<Clip> crossing(const Plane& plane, const Point<Clip>& p, const Point<Clip>& q) {
  // BEGIN SOLUTION
  // Exchanging p and q exchanges the terms of two sums, which changes no bit of the result.
  const double at_p = std::abs(distance(plane, p)), at_q = std::abs(distance(plane, q));
  const auto between = [&](float a, float b) {
    return float((a * at_q + b * at_p) / (at_p + at_q));
  };
  Point<Clip> cut(between(p.x, q.x), between(p.y, q.y), between(p.z, q.z), between(p.w, q.w));
  // The plane's own coordinate follows from w: c z + d w = 0 with c = 1 or -1; likewise x and y.
  if (plane.a != 0) cut.x = float(-plane.d / plane.a) * cut.w;
  if (plane.b != 0) cut.y = float(-plane.d / plane.b) * cut.w;
  if (plane.c != 0) cut.z = float(-plane.d / plane.c) * cut.w;
  return cut;
  // STUB: throw std::logic_error("5.3: crossing is not written yet");
  // END SOLUTION
}

Polygon clip_by_plane(const Polygon& polygon, const Plane& plane) {
  // BEGIN SOLUTION
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point<Clip>&here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    const double d_here = distance(plane, here), d_next = distance(plane, next);
    if (d_here >= 0) kept.push_back(here);
    if (d_here * d_next < 0) kept.push_back(crossing(plane, here, next));
  }
  if (kept.size() < 3) kept.clear();
  return kept;
  // STUB: throw std::logic_error("5.4: clip_by_plane is not written yet");
  // END SOLUTION
}

Polygon clip_to_frustum(const std::array<Point<Clip>, 3>& triangle) {
  // BEGIN SOLUTION
  Polygon polygon(triangle.begin(), triangle.end());
  for (const Plane& plane : kFrustum) polygon = clip_by_plane(polygon, plane);
  Polygon tidy;
  for (const Point<Clip>& p : polygon) {
    if (tidy.empty() || !(tidy.back() == p)) tidy.push_back(p);
  }
  while (tidy.size() > 1 && tidy.back() == tidy.front()) tidy.pop_back();
  if (tidy.size() < 3) tidy.clear();
  return tidy;
  // STUB: throw std::logic_error("5.5: clip_to_frustum is not written yet");
  // END SOLUTION
}

}  // namespace lab_05
