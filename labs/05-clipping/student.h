// Lab 5: which faces look away from the eye, and which part of a polygon is in the picture. You
// write student.cpp; handout.md explains.
//
// Clip space is homogeneous: (x, y, z, w) with w the distance along the gaze, in world units. The
// visible part is
//   0 <= z <= w,  -w <= x <= w,  -w <= y <= w,
// boundary included. Nothing is divided by w in this lab.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glassbox/base/spaces.h>

namespace lab_05 {

// The types of <glassbox/base/spaces.h>, which comes with glassbox; this is all that you need:
//   Point<World>  p.x, p.y, p.z, floats; p - q is a Vector<World>
//   Point<Clip>   p.x, p.y, p.z, p.w, floats; Point<Clip>(x, y, z, w)
using glassbox::Clip;
using glassbox::Point;
using glassbox::World;

// ---- 5.1 ----

// Whether the face looks away from the eye: (P - eye) . m > 0, where P is a corner of the face and
// m its outward normal (of any length). A face seen exactly edge-on is no back face.
//   face  the corners of a plane polygon in world space, at least three, counter-clockwise seen
//         from outside. It may be concave, and its first corner may be the reflex one.
//   eye   in world space
// Coordinates are multiples of 1/16 below 512 in size, so that every product and sum you need is
// exact in double, though not in float. So no error is allowed: the answer is exactly right,
// edge-on too.
bool is_back_face(const std::vector<Point<World>>& face, const Point<World>& eye);

// ---- 5.2 ----

inline constexpr std::uint32_t kNear = 1, kFar = 2, kLeft = 4, kRight = 8, kBottom = 16, kTop = 32;

// The sum of the bits of all planes that the point is outside of; 0 for a point inside or on the
// boundary. w may be negative or 0, and coordinates may be infinite. Comparisons of floats are
// exact, so no error is allowed. A point is outside of a plane, too, if a coordinate that its
// inequality compares (z for near, z and w for far, x and w for left, ...) is NaN: nothing shows
// that it is inside.
std::uint32_t outcode(const Point<Clip>& p);

enum class Verdict { kReject, kAccept, kClip };

// The verdict from the outcodes of a polygon's vertices (at least one): kAccept if nothing of the
// polygon would be cut off; kReject if one plane alone shows that nothing would be left; kClip
// otherwise. kReject and kAccept have to be certain; kClip is always safe.
Verdict trivial_verdict(const std::vector<std::uint32_t>& outcodes);

// ---- 5.3 ----

// Inside is where a x + b y + c z + d w >= 0.
struct Plane {
  double a = 0, b = 0, c = 0, d = 0;
};

// In the order in which 5.5 clips: near, far, left, right, bottom, top.
inline constexpr std::array<Plane, 6> kFrustum{
    {{0, 0, 1, 0}, {0, 0, -1, 1}, {1, 0, 0, 1}, {-1, 0, 0, 1}, {0, 1, 0, 1}, {0, -1, 0, 1}}};

// The point where the edge from p to q meets the plane. p and q are strictly on different sides of
// it; either may be the one outside. `plane` is one of kFrustum. Coordinates are any finite floats.
// Required, with u = 2^-24 and M the largest |coordinate| of p and q:
// - each coordinate is within 8 u M + 2^-149 of the exact one (2^-149 is the step of the smallest
//   floats);
// - crossing(plane, q, p) has the same bits as crossing(plane, p, q): both triangles that share the
//   edge are cut at the same place (C-38);
// - the point is exactly on the plane: z = 0, z = w, x = -w, ... hold exactly (-0 is 0).
Point<Clip> crossing(const Plane& plane, const Point<Clip>& p, const Point<Clip>& q);

// ---- 5.4 ----

using Polygon = std::vector<Point<Clip>>;

// The part of a convex polygon inside one plane of kFrustum, in the polygon's order, beginning with
// any vertex. A vertex exactly on the plane is inside; it is kept as it is, and not repeated.
// Vertices that are kept have the same bits; new ones are as exact as those of 5.3, and on the
// plane. New vertices that are equal may stay, or become one. If fewer than three vertices would be
// left, the answer is empty.
Polygon clip_by_plane(const Polygon& polygon, const Plane& plane);

// ---- 5.5 ----

// The part of a triangle inside all six planes: 3 to 9 vertices in the triangle's order, beginning
// with any, or none. No two neighbours (the last and the first are neighbours) have equal
// coordinates. w of the corners may be negative; coordinates are 0 or from 2^-106 to 2^125 in size.
// Two triangles that share an edge, which one of them passes from A to B and the other from B to A,
// are cut at points with the same bits.
// Error bound: with u and M as in 5.3, a new vertex may be off by 8 u M plus what the errors of its
// edge's ends do to the exact crossing. Each vertex may be off by as much as the worst of all
// vertices after any of the planes. Within twice that, rounding decides: vertices so near to each
// other may be one, and where a plane passes so near to an edge (of the triangle, or made by an
// earlier plane), a vertex on both may be there or not.
Polygon clip_to_frustum(const std::array<Point<Clip>, 3>& triangle);

}  // namespace lab_05
