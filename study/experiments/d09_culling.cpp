// D-9: where back faces are found out, and whether anything is lost by finding them early.
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/mesh/normals.h>
#include <glassbox/pipeline/back_face.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/raster/fan.h>
#include <glassbox/raster/snap.h>
#include <glassbox/raster/triangle_setup.h>
#include <glassbox/render/draw_list.h>
#include <glassbox/render/vertex_stage.h>

#include "study/bench/scenes.h"
#include "study/experiments/experiments.h"

namespace glassbox::study {

namespace {

constexpr int kSide = 512;  // px

using ObjectTriangle = std::array<Point<Object>, 3>;
using ScreenTriangle = std::array<ScreenVertex, 3>;

// A closed surface that lies wholly in the picture, carried to the screen.
struct Surface {
  std::vector<ObjectTriangle> modelled;
  std::vector<ScreenTriangle> placed;
  Transform<Clip, Object> clip_from_object;
  ObjectViewer viewer;
  double snapping_margin = 0;  // safe for every triangle of it
  Viewport viewport;
};

void place(const Draw& draw, const View& view, Surface& surface) {
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
    surface.modelled.push_back(modelled);
    surface.placed.push_back(placed);
  }
  // The snap moves by 2^-9 px; divide and viewport round by at most 3 u 512 px.
  constexpr double kDisplacement = 0x1p-9 + 3 * 0x1p-24 * kSide;
  surface.snapping_margin = snapping_margin(surface.clip_from_object, surface.viewer, view.viewport,
                                            largest_w * (1 + 0x1p-20), longest_edge, kDisplacement);
}

std::shared_ptr<const Surface> make_surface(const Scene& scene, const View& view) {
  auto surface = std::make_shared<Surface>();
  surface->viewport = view.viewport;
  const PreparedScene prepared = prepare(scene, Transfer::kNone);
  const DrawList list = make_draw_list(scene, prepared, view);
  const Draw& draw = list.draws.front();
  const auto& node = scene.nodes[scene.instances[draw.instance].node];
  const Transform<Eye, Object> eye_from_object = view.eye_from_world * node.world_from_node;
  surface->clip_from_object = view.clip_from_eye * eye_from_object;
  surface->viewer = viewer_in_object_space(eye_from_object, true).value();
  place(draw, view, *surface);
  return surface;
}

// ---- what is right ----

std::int64_t snapped_area(const ScreenTriangle& t) {  // positive: clockwise on the screen
  return double_area(snap(t[0]), snap(t[1]), snap(t[2]));
}

// The snapped area alone decides (DESIGN 2): a front runs counter-clockwise.
bool shows_front(const ScreenTriangle& t) {
  return snapped_area(t) < 0;
}

// ---- the tests: whether a triangle is thrown away before it is set up ----

using Keep = std::vector<std::uint8_t>;

void keep_all(const Surface& surface, Keep& keep) {
  std::ranges::fill(keep, std::uint8_t(1));
  (void)surface;
}

// The slides' test in float: any vertex, the normal by a cross product (S4.29).
void keep_by_dot(const Surface& surface, Keep& keep) {
  const auto& e = surface.viewer.eye_or_gaze;
  const Point<Object> eye(float(e.x), float(e.y), float(e.z));
  for (std::size_t i = 0; i < keep.size(); ++i) {
    const auto& [a, b, c] = surface.modelled[i];
    keep[i] = !(dot(three_point_normal(a, b, c), a - eye) > 0);
  }
}

void keep_by_area(const Surface& surface, Keep& keep) {
  for (std::size_t i = 0; i < keep.size(); ++i) keep[i] = shows_front(surface.placed[i]);
}

// The filter in double, expansions where it cannot tell, and a margin for the snap.
void keep_by_exact_test(const Surface& surface, Keep& keep) {
  for (std::size_t i = 0; i < keep.size(); ++i)
    keep[i] = !certainly_back(test_back_face(surface.modelled[i], surface.viewer),
                              surface.snapping_margin);
}

// Neighbours in the mesh's order, in a ball, their normals in a cone.
struct Cluster {
  std::size_t first = 0, count = 0;
  Vector<Object, double> centre, axis;
  double radius = 0, sine = 1;  // of the cone's half angle
};
constexpr std::size_t kClusterSize = 32;

Vector<Object, double> in_double(const Point<Object>& p) {
  return {double(p.x), double(p.y), double(p.z)};
}
double length(const Vector<Object, double>& v) {
  return std::sqrt(dot(v, v));
}

Cluster make_cluster(const std::vector<ObjectTriangle>& triangles, std::size_t first) {
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

std::vector<Cluster> make_clusters(const Surface& surface) {
  std::vector<Cluster> clusters;
  for (std::size_t first = 0; first < surface.modelled.size(); first += kClusterSize)
    clusters.push_back(make_cluster(surface.modelled, first));
  return clusters;
}

// A cluster is thrown away where the eye sees the back of every plane that its ball and cone allow: (c - eye) . axis >=
// |c - eye| sin + r.
void keep_by_cones(const Surface& surface, const std::vector<Cluster>& clusters, Keep& keep) {
  for (const Cluster& cluster : clusters) {
    const auto sight = cluster.centre + -surface.viewer.eye_or_gaze;
    const bool back = cluster.sine < 1 &&
                      dot(sight, cluster.axis) >= length(sight) * cluster.sine + cluster.radius;
    std::fill_n(keep.begin() + std::ptrdiff_t(cluster.first), cluster.count, std::uint8_t(!back));
  }
}

using Test = std::function<void(const Surface&, Keep&)>;

// ---- measures ----

double wrongly_culled(const Surface& surface, const Test& test) {
  Keep keep(surface.modelled.size());
  test(surface, keep);
  double count = 0;
  for (std::size_t i = 0; i < keep.size(); ++i) count += !keep[i] && shows_front(surface.placed[i]);
  return count;
}

// The snap moves each coordinate by an error of variance q^2/12, q = 1/256 px, so that twice the area gets one of variance
// q^2/12 times the sum of the squared edges. A face whose area is -a shows its front then with probability Phi(-a/sigma).
double chance_to_turn(const ScreenTriangle& t) {
  const auto edge = [&](std::size_t k) {
    const auto &a = t[k].position, &b = t[(k + 1) % 3].position;
    return std::array{double(b.x) - a.x, double(b.y) - a.y};
  };
  const auto u = edge(0), v = edge(1), w = edge(2);
  const double area = u[0] * v[1] - u[1] * v[0];  // positive: clockwise
  const double squares =
      u[0] * u[0] + u[1] * u[1] + v[0] * v[0] + v[1] * v[1] + w[0] * w[0] + w[1] * w[1];
  const double sigma = std::sqrt(squares / 12) / kSubpixels;
  return sigma > 0 ? 0.5 * std::erfc(area / sigma / std::sqrt(2.0)) : 0;
}

// The number of faces to expect.
double predicted_wrong(const Surface& surface, const Test& test) {
  Keep keep(surface.modelled.size());
  test(surface, keep);
  double sum = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
    sum += keep[i] ? 0 : chance_to_turn(surface.placed[i]);
  return std::round(sum);  // faces are whole
}

void cull_and_set_up(const Surface& surface, const Test& test, Keep& keep) {
  test(surface, keep);
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) continue;
    const auto setup = setup_triangle(surface.placed[i]);
    keep[i] = setup.has_value() && !setup->clockwise;
  }
}

// ---- scenes ----

Configuration configuration(const std::string& series, const std::string& scene,
                            const std::shared_ptr<const Surface>& surface, const Test& test,
                            double predicted) {
  const auto keep = std::make_shared<Keep>(surface->modelled.size());
  return {.series = series,
          .parameter = double(surface->modelled.size()),
          .scene = scene,
          .error = [=] { return wrongly_culled(*surface, test); },
          .predicted_error = predicted,
          .finding = {},
          .work = [=](int) { cull_and_set_up(*surface, test, *keep); },
          .items = double(surface->modelled.size())};
}

void add_surface(const std::string& scene, const std::shared_ptr<const Surface>& surface,
                 std::vector<Configuration>& all) {
  const auto clusters = std::make_shared<const std::vector<Cluster>>(make_clusters(*surface));
  const Test cones = [clusters](const Surface& s, Keep& keep) {
    keep_by_cones(s, *clusters, keep);
  };
  all.push_back(configuration("none", scene, surface, keep_all, 0));
  all.push_back(configuration("object-space dot product, float", scene, surface, keep_by_dot,
                              predicted_wrong(*surface, keep_by_dot)));
  all.push_back(configuration("snapped area", scene, surface, keep_by_area, 0));
  all.push_back(
      configuration("cluster cones", scene, surface, cones, predicted_wrong(*surface, cones)));
  all.push_back(
      configuration("filter, exact fallback, margin", scene, surface, keep_by_exact_test, 0));
}

std::shared_ptr<const Surface> ellipsoid(const Grid& grid) {
  const BenchScene bench = make_ellipsoid_scene("ellipsoid", grid, kSide, kSide);
  return make_surface(bench.scene, bench.passes.front().view);
}

std::shared_ptr<const Surface> teapot() {
  const Scene scene = make_builtin("teapot").value();
  return make_surface(scene, make_view(frame(scene, 1).value(), kSide, kSide).value());
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  add_surface("teapot", teapot(), all);
  add_surface("ellipsoid of a scan's size", ellipsoid(kScannedGrid), all);
  if (effort == Effort::kFull)
    add_surface("ellipsoid of a million triangles", ellipsoid(kFineGrid), all);
  return all;
}

}  // namespace

Experiment d09_culling() {
  return {
      .id = "D-9",
      .name = "Back faces: where they are found out",
      .question = "What is gained by throwing back faces away early, and is anything lost?",
      .axis = "triangles of the mesh",
      .axis_unit = {},
      .error = "faces thrown away although their snapped triangle shows its front",
      .error_unit = "faces",
      .reference =
          "the sign of the snapped triangle's area, an exact integer, which decides what is drawn",
      .theory =
          "An exact test in object space does not see the snap, which turns a face of twice the "
          "area -a with probability "
          "Phi(-a/sigma), sigma^2 = sum |edge|^2/(12 256^2): the sum over all that are thrown "
          "away. With a margin for the snap: 0. "
          "Half the faces of a closed surface are backs, so at most half of the set-up is saved.",
      .item = "triangle",
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
