// The bounds of lines, points and edges of triangles against arithmetic of 320 bits, from the matrices on; cut by planes, too.
#include <glassbox/render/trace/line_bounds.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/raster/line.h>
#include <glassbox/render/staged/vertex_stage.h>
#include <glassbox/render/trace/picture_bounds.h>
#include <glassbox/render/trace/tracer.h>

#include "tests/render/exact_polygon.h"
#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

using test::Big;
using test::BigMatrix;
using test::BigVector;
using test::exactly;
using test::ExactVertex;
using test::operator*;

// The largest share of a bound that an error takes.
struct KeptBound {
  const char* name;
  double ratio = 0;
  int count = 0;

  void see(double value, const Big& exact, double bound) {
    if (!std::isfinite(bound)) return;
    ++count;
    const double error = double(abs(Big(value) - exact));
    CAPTURE(name, value, double(exact), bound);
    REQUIRE(error <= bound + 0x1p-250);  // what the oracle rounds
    if (bound > 0) ratio = std::max(ratio, error / bound);
  }
  void check(double least_ratio) const {
    CAPTURE(name, count, ratio);
    CHECK(count > 1000);
    CHECK(ratio > least_ratio);
  }
};

// Triangles, lines and points, with colours, and normals at some of their corners.
Scene scene_of_lines(Random& random) {
  Mesh mesh;
  const auto corner = [&] {
    const auto number = std::uint32_t(mesh.positions.size());
    const double x = random.between(-1.5, 1.5), y = random.between(-1, 1);
    mesh.positions.push_back({float(x), float(y), float(random.between(-1.5, 1.5))});
    const double red = random.unit(), green = random.unit();
    mesh.colors.push_back({float(red), float(green), float(random.unit()), 1});
    mesh.normals.push_back({float(random.between(-1, 1)), 0.5f, 0.7f});
    return Corner{number, random.unit() < 0.5 ? number : kNone, kNone, number};
  };
  for (int i = 0; i < 8; ++i) {
    for (int k = 0; k < 3; ++k) mesh.corners.push_back(corner());
    mesh.faces.push_back({std::uint32_t(3 * i), 3});
    const Corner begin = corner();
    mesh.lines.push_back({begin, corner()});
    for (int k = 0; k < 4; ++k) mesh.points.push_back(corner());
  }
  Material material;
  material.double_sided = true;
  Scene scene = test::scene_of(std::move(mesh), material);
  const auto turn = rotate_degrees<World>(Vector<Object, double>{1, random.between(-1, 1), 0.5},
                                          random.between(-180, 180));
  REQUIRE(turn);
  scene.nodes[0].world_from_node = *turn * scale<Object, Object>(1, random.between(0.5, 2), 1);
  return scene;
}

// What is left of a line between two corners, cut where the run has cut it.
std::array<ExactVertex, 2> exact_ends(const Trace& trace, std::array<ClipVertex, 2> run,
                                      std::array<ExactVertex, 2> exact) {
  for (const ClipPlane& plane : trace.planes) {
    const double d0 = signed_distance(plane, run[0].position);
    const double d1 = signed_distance(plane, run[1].position);
    if ((d0 >= 0) == (d1 >= 0)) continue;
    const auto cut = clip_segment(run, {&plane, 1});
    if (!cut) continue;
    const std::size_t outside = d0 < 0 ? 0 : 1;
    exact[outside] = test::exact_crossing(plane, exact[0], exact[1]);
    run[outside] = (*cut)[outside];
  }
  return exact;
}

struct AllKept {
  KeptBound depth{"depth"}, inverse_w{"1/w"}, color{"colours"}, screen{"ends on the screen"};
  std::map<LineKind, int> kinds;
  int cut = 0;
};

class LineOracle {
public:
  LineOracle(const Scene& scene, const View& view, const Draw& draw)
      : mesh_(scene.meshes[0]),
        view_(view),
        draw_(draw),
        clip_(exactly(view.clip_from_eye.columns) *
              (exactly(view.eye_from_world.columns) *
               exactly(scene.nodes[0].world_from_node.columns))) {}

  void compare(const Trace& trace, const TracedFragment& traced, const TracedTriangle* triangle,
               const LineBounds& line, AllKept& all) const {
    const std::array<Corner, 2> corners = corners_of(traced.source, triangle);
    std::array<ClipVertex, 2> run;
    std::array<ExactVertex, 2> ends;
    for (std::size_t k = 0; k < 2; ++k) {
      run[k].position = project_vertex(draw_, corners[k].position);
      ends[k].clip = clip_ * mesh_.positions[corners[k].position];
      ends[k].weights[k] = 1;
    }
    const bool is_point = line_kind(traced.source) == LineKind::kPoint;
    if (!is_point) ends = exact_ends(trace, run, ends);
    all.cut += ends[0].weights[0] != 1 || ends[1].weights[1] != 1;
    see_ends(line, ends, all);
    const Big share = is_point ? Big(0) : share_of_way(line, traced.fragment);
    const std::array<Big, 2> q{1 / ends[0].clip[3], 1 / ends[1].clip[3]};
    const FragmentBounds bounds = line.of(traced.fragment);
    const auto between = [&](const Big& a, const Big& b) { return a + share * (b - a); };
    all.depth.see(double(traced.fragment.depth),
                  between(ends[0].clip[2] * q[0], ends[1].clip[2] * q[1]), bounds.depth);
    const Big inverse_w = between(q[0], q[1]);
    all.inverse_w.see(double(traced.fragment.inverse_w), inverse_w, bounds.inverse_w);
    ++all.kinds[line_kind(traced.source)];
    if (traced.fate != Fate::kWritten) return;
    const ColorBounds colors = line.colors(traced, bounds);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = [&](std::size_t end) {
        Big sum = 0;
        for (std::size_t k = 0; k < 2; ++k) {
          const Rgba& c = mesh_.colors[corners[k].color];
          sum += ends[end].weights[k] * Big(std::array{c.r, c.g, c.b}[i]);
        }
        return sum;
      };
      const Big exact = between(value(0) * q[0], value(1) * q[1]) / inverse_w;
      all.color.see(double(colors.surface[i].value), exact, colors.surface[i].bound);
    }
  }

private:
  std::array<Corner, 2> corners_of(const FragmentSource& source,
                                   const TracedTriangle* triangle) const {
    if (line_kind(source) == LineKind::kLine) return mesh_.lines[source.number];
    if (line_kind(source) == LineKind::kPoint) {
      return {mesh_.points[source.number], mesh_.points[source.number]};
    }
    REQUIRE(triangle != nullptr);
    const auto corner = [&](std::size_t k) {
      return mesh_.corners[triangle->corners[k % 3].corner];
    };
    return {corner(edge_of(source)), corner(edge_of(source) + std::size_t(1))};
  }

  void see_ends(const LineBounds& line, const std::array<ExactVertex, 2>& exact,
                AllKept& all) const {
    const Viewport& v = view_.viewport;
    for (std::size_t k = 0; k < line.ends().size(); ++k) {
      const auto& [vertex, bounds] = line.ends()[k];
      const Big x = exact[k].clip[0] / exact[k].clip[3], y = exact[k].clip[1] / exact[k].clip[3];
      all.screen.see(double(vertex.screen.position.x),
                     Big(v.left) + (x + 1) / 2 * (Big(v.right) - Big(v.left)), bounds.screen.x);
      all.screen.see(double(vertex.screen.position.y),
                     Big(v.bottom) + (y + 1) / 2 * (Big(v.top) - Big(v.bottom)), bounds.screen.y);
    }
  }

  // Of the snapped line, where its longer axis passes the pixel's centre.
  static Big share_of_way(const LineBounds& line, const Fragment& fragment) {
    const LineSetup setup =
        setup_line(line.ends()[0].vertex.snapped, line.ends()[1].vertex.snapped);
    const int major = setup.x_major ? fragment.x : fragment.y;
    return Big(setup.step_at(major)) / Big(setup.steps());
  }

  const Mesh& mesh_;
  const View& view_;
  const Draw& draw_;
  BigMatrix clip_;
};

TEST_CASE("every fragment of lines, points and edges is within its bound") {
  Random random(46);
  AllKept all;
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    const Scene scene = scene_of_lines(random);
    const PerspectiveLens lens{random.between(0.7, 1.5), std::pow(10, random.between(-3, -0.5)),
                               8.0};
    const auto eye_from_world =
        look_at(Point<World, double>{random.between(-1, 1), 0.5, random.between(0, 3)},
                {0, random.between(-1, 1), 0}, {random.between(-0.5, 0.5), 1, 0});
    REQUIRE(eye_from_world);
    const auto view = make_view({"random", lens, inverse_rigid(*eye_from_world)}, 80, 60);
    REQUIRE(view);
    RenderSettings settings;
    settings.shading = random.unit() < 0.5 ? Shading::kUnlit : Shading::kPhong;
    settings.wireframe = i % 2 == 0;
    const PreparedScene prepared = prepare(scene, settings.transfer);
    const DrawList list = make_draw_list(scene, prepared, *view);
    const TracedRun run = trace(scene, *view, settings, {});
    const DrawBounds draw_bounds = bounds_of(run.trace.draws[0], *view);
    const auto known = bounds_of_all(run.trace);
    const LineOracle oracle(scene, *view, list.draws[0]);
    const CornerStage stage{list.draws[0], draw_bounds, list.lighting, settings};
    int taken = 0;
    for (const TracedFragment& fragment : run.trace.fragments) {
      const FragmentSource& source = fragment.source;
      const bool is_point = line_kind(source) == LineKind::kPoint;
      if (source.is_triangle || (!is_point && ++taken % 3 != 0)) continue;
      const bool is_edge = line_kind(source) == LineKind::kEdge;
      const BoundsOfRun::Known* const triangle = is_edge ? &known.at(source.number) : nullptr;
      const LineBounds line(stage, run.trace, run.trace.draws[0], source, triangle);
      oracle.compare(run.trace, fragment, is_edge ? triangle->triangle : nullptr, line, all);
    }
  }
  all.depth.check(0.05);
  all.inverse_w.check(0.05);
  all.color.check(0.02);
  all.screen.check(0.05);
  CHECK(all.cut > 500);
  for (const LineKind kind : {LineKind::kEdge, LineKind::kLine, LineKind::kPoint}) {
    CHECK(all.kinds[kind] > 100);
  }
}

TEST_CASE("a line that may miss a pixel is one that does when its ends are moved so far") {
  Random random(47);
  int doubtful = 0, certain = 0;
  constexpr double kMoved = 0.02;  // px
  for (int i = 0; i < 200; ++i) {
    const auto place = [&] {
      return SnappedVertex{std::int32_t(random.integer(0, 32 * 256)),
                           std::int32_t(random.integer(0, 24 * 256))};
    };
    const std::array<SnappedVertex, 2> ends{place(), place()};
    const PixelRect window{0, 0, 32, 24};
    for_each_line_pixel(ends[0], ends[1], window, [&](const LinePixel& pixel) {
      bool misses = false;
      for (int k = 0; k < 40; ++k) {
        std::array<SnappedVertex, 2> moved = ends;
        for (SnappedVertex& end : moved) {
          const auto by = [&] { return std::int32_t(random.integer(-5, 5)); };
          end.x += by();
          end.y += by();
        }
        bool found = false;
        for_each_line_pixel(moved[0], moved[1], window, [&](const LinePixel& other) {
          found = found || (other.x == pixel.x && other.y == pixel.y);
        });
        misses = misses || !found;
      }
      Fragment fragment;
      fragment.x = pixel.x;
      fragment.y = pixel.y;
      const bool may_miss = line_may_miss(ends, fragment, kMoved);
      CAPTURE(i, pixel.x, pixel.y);
      if (misses) CHECK(may_miss);
      (may_miss ? doubtful : certain) += 1;
    });
  }
  CHECK(doubtful > 50);
  CHECK(certain > 5 * doubtful);
}

TEST_CASE("a report's bounds name lines and points where these are worst") {
  Mesh mesh;
  mesh.positions = {{-9, -9, 0},      {9, -9, 0},      {0, 9, 0},
                    {-1, 0.1f, 0.5f}, {1, 0.2f, 0.5f}, {0, 0.5f, 0.6f}};
  test::add_face(mesh, {0, 1, 2});
  mesh.lines.push_back({Corner{3}, Corner{4}});
  mesh.points.push_back(Corner{5});
  const Scene scene = test::scene_of(mesh);
  const auto view = make_view(test::camera_for(scene, 4.0 / 3), 80, 60);
  REQUIRE(view);
  const PictureErrors errors = picture_errors(scene, *view, {});
  CHECK(errors.fragments_of_lines_and_points > 3);
  CHECK(errors.pixels_unbounded == 0);
  CHECK(errors.picture.unbounded() == 0);
  CHECK(errors.snapped.count() == 6);  // corners, ends and a point
  CHECK(errors.cut.count() == 0);
  RenderSettings edges;
  edges.wireframe = true;
  const PictureErrors of_edges = picture_errors(scene, *view, edges);
  CHECK(of_edges.pixels_unbounded == 0);
  CHECK(of_edges.fragments_of_lines_and_points > errors.fragments_of_lines_and_points);
  CHECK(of_edges.snapped.count() == 6);  // no corner twice
}

}  // namespace
}  // namespace glassbox
