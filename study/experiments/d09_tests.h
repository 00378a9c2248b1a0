// The back-face tests that are compared (D-9), on a closed surface that is completely inside the
// picture.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/mesh/normals.h>
#include <glassbox/pipeline/back_face.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/raster/fan.h>
#include <glassbox/raster/snap.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/vertex_stage.h>

#include "exact/coverage.h"

namespace glassbox::study::d09 {

inline constexpr int kSide = 512;  // in px

using ObjectTriangle = std::array<Point<Object>, 3>;
using ScreenTriangle = std::array<ScreenVertex, 3>;

// A closed surface that is completely inside the picture, with its triangles on the screen.
struct Surface {
  std::vector<ObjectTriangle> object_triangles;
  std::vector<ScreenTriangle> screen_triangles;
  Transform<Clip, Object> clip_from_object;
  ObjectViewer viewer;
  double snapping_margin = 0;  // large enough for all of its triangles
  Viewport viewport;
};

inline void add_triangles(const Draw& draw, const View& view, Surface& surface) {
  const ClipTable table = project_vertices(draw, view);
  double largest_w = 0, longest_edge = 0;
  for (const Triangle& triangle : draw.triangulation->triangles) {
    ObjectTriangle modelled;
    ScreenTriangle placed;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t index = draw.mesh->corners[triangle.corners[k]].position;
      modelled[k] = draw.mesh->positions[index];
      placed[k] = to_screen(divide(table.positions[index]), view.viewport);
      largest_w = std::max(largest_w, double(table.positions[index].w));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &a = placed[k].position, &b = placed[(k + 1) % 3].position;
      longest_edge =
          std::max({longest_edge, std::abs(double(a.x) - b.x), std::abs(double(a.y) - b.y)});
    }
    surface.object_triangles.push_back(modelled);
    surface.screen_triangles.push_back(placed);
  }
  // Snapping moves a vertex by up to 2^-9 px; divide and viewport round by at most 3 u 512 px (u:
  // the unit roundoff, 2^-24).
  constexpr double kDisplacement = 0x1p-9 + 3 * 0x1p-24 * kSide;
  surface.snapping_margin = snapping_margin(surface.clip_from_object, surface.viewer, view.viewport,
                                            largest_w * (1 + 0x1p-20), longest_edge, kDisplacement);
}

inline std::shared_ptr<const Surface> make_surface(const Scene& scene, const View& view) {
  auto surface = std::make_shared<Surface>();
  surface->viewport = view.viewport;
  const PreparedScene prepared = prepare_scene(scene, Transfer::kNone);
  const DrawList list = make_draw_list(scene, prepared, view);
  const Draw& draw = list.draws.front();
  const auto& node = scene.nodes[scene.instances[draw.instance].node];
  const Transform<Eye, Object> eye_from_object = view.eye_from_world * node.world_from_node;
  surface->clip_from_object = view.clip_from_eye * eye_from_object;
  surface->viewer = viewer_in_object_space(eye_from_object, true).value();
  add_triangles(draw, view, *surface);
  return surface;
}

// ---- what is right ----

inline std::int64_t snapped_area(const ScreenTriangle& t) {  // positive: clockwise on the screen
  return double_area(snap(t[0]), snap(t[1]), snap(t[2]));
}

// Whether the triangle shows its front. The snapped area alone decides this, as in the pipeline: a
// front face is counter-clockwise.
inline bool shows_front(const ScreenTriangle& t) {
  return snapped_area(t) < 0;
}

// Whether the triangle shows its front, computed with exact integers by code that is independent of
// the pipeline.
inline bool shows_front_exactly(const ScreenTriangle& t) {
  __extension__ typedef __int128 Int128;
  return exact::orientation<Int128>(exact::snapped(t)) < 0;
}

// ---- the tests: whether a triangle is thrown away before it is set up ----

using KeepFlags = std::vector<std::uint8_t>;

inline void keep_all(const Surface& surface, KeepFlags& keep) {
  std::ranges::fill(keep, std::uint8_t(1));
  (void)surface;
}

// The test of the slides (S4.29) in float: rejects a triangle if its normal, from a cross product,
// and the direction from the eye to one of its vertices have a positive product.
inline void keep_by_dot(const Surface& surface, KeepFlags& keep) {
  const auto& e = surface.viewer.eye_or_gaze;
  const Point<Object> eye(float(e.x), float(e.y), float(e.z));
  for (std::size_t i = 0; i < keep.size(); ++i) {
    const auto& [a, b, c] = surface.object_triangles[i];
    keep[i] = !(dot(three_point_normal(a, b, c), a - eye) > 0);
  }
}

inline void keep_by_area(const Surface& surface, KeepFlags& keep) {
  for (std::size_t i = 0; i < keep.size(); ++i) keep[i] = shows_front(surface.screen_triangles[i]);
}

// Rejects a triangle only if a test proves that it is a back face, even if snapping moves its
// corners (the margin). The test is computed in double first, and with exact expansions if rounding
// errors could change the answer.
inline void keep_by_exact_test(const Surface& surface, KeepFlags& keep) {
  for (std::size_t i = 0; i < keep.size(); ++i)
    keep[i] = !certainly_back(test_back_face(surface.object_triangles[i], surface.viewer),
                              surface.snapping_margin);
}

// Triangles that follow each other in the mesh, with a ball around them and a cone that contains
// all their normals.
struct Cluster {
  std::size_t first = 0, count = 0;
  Vector<Object, double> centre, axis;
  double radius = 0, sine = 1;  // sine of the cone's half angle
};
inline constexpr std::size_t kClusterSize = 32;

inline Vector<Object, double> in_double(const Point<Object>& p) {
  return {double(p.x), double(p.y), double(p.z)};
}
inline double length(const Vector<Object, double>& v) {
  return std::sqrt(dot(v, v));
}

inline Cluster make_cluster(const std::vector<ObjectTriangle>& triangles, std::size_t first) {
  Cluster cluster{first, std::min(kClusterSize, triangles.size() - first), {}, {}};
  std::vector<Vector<Object, double>> normals;
  for (std::size_t i = first; i < first + cluster.count; ++i) {
    const auto a = in_double(triangles[i][0]), b = in_double(triangles[i][1]),
               c = in_double(triangles[i][2]);
    const auto normal = cross(b + -a, c + -b);
    if (length(normal) > 0) normals.push_back(normal * (1 / length(normal)));
    cluster.centre = cluster.centre + (a + b + c) * (1.0 / double(3 * cluster.count));
  }
  for (const auto& normal : normals) cluster.axis = cluster.axis + normal;
  if (length(cluster.axis) > 0) cluster.axis = cluster.axis * (1 / length(cluster.axis));
  double cosine = 1;
  for (const auto& normal : normals) cosine = std::min(cosine, dot(normal, cluster.axis));
  cluster.sine = cosine > 0 ? std::sqrt(1 - cosine * cosine) : 1;
  for (std::size_t i = first; i < first + cluster.count; ++i) {
    for (const Point<Object>& p : triangles[i])
      cluster.radius = std::max(cluster.radius, length(in_double(p) + -cluster.centre));
  }
  return cluster;
}

inline std::vector<Cluster> make_clusters(const Surface& surface) {
  std::vector<Cluster> clusters;
  for (std::size_t first = 0; first < surface.object_triangles.size(); first += kClusterSize)
    clusters.push_back(make_cluster(surface.object_triangles, first));
  return clusters;
}

// Rejects a cluster if the eye is behind the planes of all triangles that its ball and cone may
// contain: (c - eye) . axis >= |c - eye| sin + r (c and r: centre and radius of the ball; axis and
// sin: axis of the cone and sine of its half angle).
inline void keep_by_cones(const Surface& surface, const std::vector<Cluster>& clusters,
                          KeepFlags& keep) {
  for (const Cluster& cluster : clusters) {
    const auto sight = cluster.centre + -surface.viewer.eye_or_gaze;
    const bool back = cluster.sine < 1 &&
                      dot(sight, cluster.axis) >= length(sight) * cluster.sine + cluster.radius;
    std::fill_n(keep.begin() + std::ptrdiff_t(cluster.first), cluster.count, std::uint8_t(!back));
  }
}

using Test = std::function<void(const Surface&, KeepFlags&)>;

// ---- filters: a bound tells whether the value's sign is right; if not, expansions decide ----

struct Filtered {
  bool back = false;
  double bound = 0;  // bound for the rounding error of (b - a) x (c - a) . (a - eye)
  bool used_exact = false;
};
using Filter = Filtered (*)(const ObjectTriangle&, const Vector<Object, double>& eye);

inline Filtered filter_in_double(const ObjectTriangle& t, const Vector<Object, double>& eye) {
  const BackFaceTest test = test_back_face(t, ObjectViewer{true, eye, {}});
  return {test.facing == Facing::kBack, test.bound, test.used_exact};
}

// Computes in float, for an eye rounded to float. Each term has eight rounding errors: a difference
// in each of the three vectors, two products, their difference, and two sums. So the bound is
// gamma(8), about eight units roundoff, times the sum of the sizes of all terms, which is itself
// rounded.
inline Filtered filter_in_float(const ObjectTriangle& t, const Vector<Object, double>& eye) {
  const auto minus = [](const Point<Object>& p, const auto& q) {
    return std::array{p.x - float(q.x), p.y - float(q.y), p.z - float(q.z)};
  };
  const auto b = minus(t[1], t[0]), c = minus(t[2], t[0]), a = minus(t[0], eye);
  float value = 0, size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const float one = b[j] * c[k], other = b[k] * c[j];
    value += (one - other) * a[i];
    size += (std::abs(one) + std::abs(other)) * std::abs(a[i]);
  }
  const double error = gamma<double>(1) + gamma<float>(8),
               bound = error / (1 - error) * double(size);
  if (std::abs(double(value)) > bound) return {value > 0, bound, false};
  const Vector<Object, double> rounded{float(eye.x), float(eye.y), float(eye.z)};
  return {filter_in_double(t, rounded).back, bound, true};
}

// The fraction of eyes for which a filter cannot decide, if the eyes are far away in all
// directions. The cosine of the angle between normal and gaze is uniformly distributed in [-1, 1],
// so a fraction bound/(|normal| distance) of the eyes is too near to the face's plane. Such eyes
// are rare, so eyes are chosen from a slab around the plane that is kSlab times as thick, and the
// result is weighted accordingly.
struct Fallbacks {
  double measured = 0, expected = 0;
};
inline Fallbacks fallbacks(const std::vector<ObjectTriangle>& triangles, Filter filter, int eyes) {
  constexpr double kSlab = 32, kDistance = 64;
  Random random(9);
  Fallbacks mean;
  for (int used = 0; used < eyes;) {
    const auto& t = triangles[std::size_t(random.integer(0, std::int64_t(triangles.size()) - 1))];
    const auto a = in_double(t[0]), b = in_double(t[1]) + -a, c = in_double(t[2]) + -a;
    const auto area = cross(b, c);
    if (!(length(area) > 0)) continue;
    ++used;
    const auto normal = area * (1 / length(area)), side = b * (1 / length(b));
    const SinCos turn = sin_cos(random.between(0, 2 * kPi));
    const auto in_plane = a + (side * turn.cos + cross(normal, side) * turn.sin) * kDistance;
    const double share = filter(t, in_plane).bound / (length(area) * kDistance);
    const auto eye = in_plane + normal * (kDistance * kSlab * share * random.between(-1, 1));
    mean.expected += share / eyes;
    mean.measured += filter(t, eye).used_exact ? kSlab * share / eyes : 0;
  }
  return mean;
}

}  // namespace glassbox::study::d09
