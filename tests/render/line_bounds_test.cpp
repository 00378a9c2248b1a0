// The bounds of lines, points and edges of triangles, compared with arithmetic of 320 bits that
// starts from the matrices: positions, normals, textures, light and bytes; planes cut some of them.
#include <glassbox/render/trace/line_bounds.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/raster/color_bounds.h>
#include <glassbox/raster/line.h>
#include <glassbox/render/staged/vertex_stage.h>
#include <glassbox/render/trace/picture_bounds.h>
#include <glassbox/render/trace/tracer.h>

#include "tests/render/exact_attributes.h"
#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

using test::Big;
using test::Big3;
using test::BigMatrix;
using test::BigVector;
using test::exactly;
using test::ExactVertex;
using test::operator*;

// The largest error in units of its bound.
struct LineErrorRatio {
  // Rounding errors of the oracle: in 320 bits, and in double for its textures and bytes.
  static constexpr double kInFull = 0x1p-250, kInDouble = 1e-12;

  const char* name;
  double oracle = kInFull;
  double ratio = 0;
  int count = 0;
  std::vector<double> bounds = {};

  void add(double value, const Big& exact, double bound) {
    if (!std::isfinite(bound)) return;
    ++count;
    bounds.push_back(bound);
    const double error = double(abs(Big(value) - exact));
    CAPTURE(name, value, double(exact), bound);
    REQUIRE(error <= bound + oracle);
    if (bound > 0) ratio = std::max(ratio, error / bound);
  }
  void check(double least_ratio) const {
    CAPTURE(name, count, ratio);
    CHECK(count > 1000);
    CHECK(ratio > least_ratio);
  }
  // Fails if the median bound is not below the limit. A bound derived for a slightly different
  // number would be valid, but larger by their difference.
  void check_half_below(double limit) {
    const auto middle = bounds.begin() + std::ptrdiff_t(bounds.size() / 2);
    std::nth_element(bounds.begin(), middle, bounds.end());
    CAPTURE(name, *middle);
    CHECK(*middle < limit);
  }
};

// Triangles, lines and points with colours; some of their corners have normals. `textured`: with a
// texture of a few texels and all its levels.
Scene scene_of_lines(Random& random, bool textured) {
  Mesh mesh;
  const auto corner = [&] {
    const auto number = std::uint32_t(mesh.positions.size());
    const double x = random.between(-1.5, 1.5), y = random.between(-1, 1);
    mesh.positions.push_back({float(x), float(y), float(random.between(-1.5, 1.5))});
    const double red = random.unit(), green = random.unit();
    mesh.colors.push_back({float(red), float(green), float(random.unit()), 1});
    mesh.normals.push_back({float(random.between(-1, 1)), 0.5f, 0.7f});
    mesh.texcoords.push_back({float(random.between(-2, 2)), float(random.unit())});
    return Corner{number, random.unit() < 0.5 ? number : kNone, number, number};
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
  material.specular = {0.3f, 0.2f, 0.1f};
  material.shininess = 7;
  if (textured) material.texture = 0;
  Scene scene = test::scene_of(std::move(mesh), material);
  if (textured) {
    scene.textures.push_back({0, Sampler{Wrap::kRepeat, Wrap::kMirroredRepeat, Filter::kLinear,
                                         Filter::kNearest, MipFilter::kLinear}});
    for (Rgba8& c : scene.images.emplace_back(16, 8).pixels) {
      const auto byte = [&] { return std::uint8_t(random.integer(0, 255)); };
      c = {byte(), byte(), byte(), 255};
    }
  }
  Light light;
  light.kind = LightKind::kPoint;
  light.intensity = 12;
  light.position = {2, 3, 4};
  scene.lights = {light};
  const Vector<Object, double> axis{1, random.between(-1, 1), 0.5};
  const auto turn = rotate_degrees<World>(axis, random.between(-180, 180));
  REQUIRE(turn);
  scene.nodes[0].world_from_node = *turn * scale<Object, Object>(1, random.between(0.5, 2), 1);
  return scene;
}

// The ends of a line after clipping, cut exactly where the run has cut it.
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
  LineErrorRatio depth{"depth"}, inverse_w{"1/w"}, screen{"ends on the screen"}, normal{"normals"},
      texcoord{"texture coordinates"};
  LineErrorRatio surface{"surface", LineErrorRatio::kInDouble},
      light{"light", LineErrorRatio::kInDouble}, stored{"stored bytes", LineErrorRatio::kInDouble};
  std::map<LineKind, int> kinds;
  int cut = 0, without_normal = 0;
};

// The attributes of a corner, or of a point of a line.
struct ExactAttributes {
  Big3 position, normal, color;
  std::array<Big, 2> texcoord;

  template <class Weigh>
  static ExactAttributes mixed(const Weigh& weigh) {
    ExactAttributes sum;
    const auto each = [&](auto member) {
      for (std::size_t i = 0; i < (sum.*member).size(); ++i) {
        (sum.*member)[i] = weigh([&](const ExactAttributes& a) { return (a.*member)[i]; });
      }
    };
    each(&ExactAttributes::position);
    each(&ExactAttributes::normal);
    each(&ExactAttributes::color);
    each(&ExactAttributes::texcoord);
    return sum;
  }
};

class LineOracle {
public:
  LineOracle(const Scene& scene, const View& view, const RenderSettings& settings, const Draw& draw,
             const Lighting& lighting)
      : scene_(scene),
        mesh_(scene.meshes[0]),
        view_(view),
        settings_(settings),
        draw_(draw),
        lighting_(lighting),
        eye_(exactly(view.eye_from_world.columns) *
             exactly(scene.nodes[0].world_from_node.columns)),
        clip_(exactly(view.clip_from_eye.columns) * eye_) {
    if (!scene.images.empty()) levels_ = in_full::levels_of(scene.images[0], settings.transfer);
  }

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
    const bool is_point = traced.source.line == LineKind::kPoint;
    if (!is_point) ends = exact_ends(trace, run, ends);
    all.cut += ends[0].weights[0] != 1 || ends[1].weights[1] != 1;
    check_ends(line, ends, all);
    const Big share = is_point ? Big(0) : share_of_way(line, traced.fragment);
    const std::array<Big, 2> q{1 / ends[0].clip[3], 1 / ends[1].clip[3]};
    const FragmentBounds bounds = line.of_fragment(traced.fragment);
    const auto between = [&](const Big& a, const Big& b) { return a + share * (b - a); };
    all.depth.add(double(traced.fragment.depth),
                  between(ends[0].clip[2] * q[0], ends[1].clip[2] * q[1]), bounds.depth);
    const Big inverse_w = between(q[0], q[1]);
    all.inverse_w.add(double(traced.fragment.inverse_w), inverse_w, bounds.inverse_w);
    ++all.kinds[traced.source.line];
    if (traced.result != FragmentResult::kWritten) return;
    const std::array<ExactAttributes, 2> own{attributes_of(corners[0], triangle),
                                             attributes_of(corners[1], triangle)};
    const ExactAttributes at = ExactAttributes::mixed([&](const auto& of) {
      const auto at_end = [&](std::size_t end) {
        return q[end] * (ends[end].weights[0] * of(own[0]) + ends[end].weights[1] * of(own[1]));
      };
      return between(at_end(0), at_end(1)) / inverse_w;
    });
    check_colors(traced, at, line.colors(traced, bounds), all);
  }

private:
  std::array<Corner, 2> corners_of(const FragmentSource& source,
                                   const TracedTriangle* triangle) const {
    if (source.line == LineKind::kLine) return mesh_.lines[source.number];
    if (source.line == LineKind::kPoint) {
      return {mesh_.points[source.number], mesh_.points[source.number]};
    }
    REQUIRE(triangle != nullptr);
    const auto corner = [&](std::size_t k) {
      return mesh_.corners[triangle->corners[k % 3].corner];
    };
    return {corner(source.edge), corner(source.edge + std::size_t(1))};
  }

  // The corner's attributes. For an edge whose corner has no normal, the normal is that of the
  // triangle's face; normals point to the visible side.
  ExactAttributes attributes_of(const Corner& corner, const TracedTriangle* triangle) const {
    ExactAttributes at;
    at.position = test::affine(eye_, mesh_.positions[corner.position]);
    const Rgba& c = mesh_.colors[corner.color];
    at.color = {Big(c.r), Big(c.g), Big(c.b)};
    const TexCoord& uv = mesh_.texcoords[corner.texcoord];
    at.texcoord = {Big(uv.u), Big(uv.v)};
    if (corner.normal != kNone) {
      const Normal<Object>& n = mesh_.normals[corner.normal];
      at.normal = test::eye_normal(eye_, {Big(n.x), Big(n.y), Big(n.z)});
    } else if (triangle != nullptr) {
      at.normal = test::eye_normal(eye_, test::face_normal_of(*triangle));
    }
    if (triangle != nullptr && shows_back(*triangle)) at.normal = test::negated(at.normal);
    return at;
  }
  static bool shows_back(const TracedTriangle& triangle) {
    for (const TracedPiece& piece : triangle.pieces) {
      if (piece.setup && !piece.culled) return !piece.front;
    }
    return false;
  }

  void check_colors(const TracedFragment& traced, const ExactAttributes& at,
                    const ColorBounds& found, AllKept& all) const {
    const Material& material = *draw_.material;
    in_full::Light texel{1, 1, 1, 1};
    if (!levels_.empty()) {
      constexpr double kLevel = 0;  // along a line there is no second direction, so level 0 is used
      texel = in_full::sample(levels_, scene_.textures[0].sampler, double(at.texcoord[0]),
                              double(at.texcoord[1]), kLevel);
      for (std::size_t i = 0; i < 2; ++i) {
        const auto& [value, bound] = found.at.texcoord[i];
        all.texcoord.add(double(value), at.texcoord[i], bound);
      }
    }
    Big3 light;
    for (std::size_t i = 0; i < 3; ++i) {
      light[i] = at.color[i] * Big(texel[i]);
      all.surface.add(double(found.surface[i].value), light[i], found.surface[i].bound);
    }
    if (settings_.shading == Shading::kPhong) {
      for (std::size_t i = 0; i < 3; ++i) {
        all.normal.add(double(found.at.normal[i].value), at.normal[i], found.at.normal[i].bound);
      }
      all.without_normal += at.normal == Big3{};
      const auto reflection =
          in_full::reflected_light(lighting_, at.position, at.normal, material.shininess, true);
      light = in_full::reflected_color(light, at.normal, reflection, material.specular, true);
    }
    const std::uint8_t bytes[] = {traced.after.r, traced.after.g, traced.after.b};
    for (std::size_t i = 0; i < 3; ++i) {
      all.light.add(double(found.light[i].value), light[i], found.light[i].bound);
      all.stored.add(double(bytes[i]),
                     Big(255 * in_full::encoded(settings_.transfer, double(light[i]))),
                     stored_bound(settings_.transfer, bytes[i], found.light[i]));
    }
  }

  void check_ends(const LineBounds& line, const std::array<ExactVertex, 2>& exact,
                  AllKept& all) const {
    const Viewport& v = view_.viewport;
    for (std::size_t k = 0; k < line.ends().size(); ++k) {
      const auto& [vertex, bounds] = line.ends()[k];
      const Big x = exact[k].clip[0] / exact[k].clip[3], y = exact[k].clip[1] / exact[k].clip[3];
      all.screen.add(double(vertex.screen.position.x),
                     Big(v.left) + (x + 1) / 2 * (Big(v.right) - Big(v.left)), bounds.screen.x);
      all.screen.add(double(vertex.screen.position.y),
                     Big(v.bottom) + (y + 1) / 2 * (Big(v.top) - Big(v.bottom)), bounds.screen.y);
    }
  }

  // The share of the snapped line up to where its major axis passes the pixel's centre.
  static Big share_of_way(const LineBounds& line, const Fragment& fragment) {
    const LineSetup setup =
        setup_line(line.ends()[0].vertex.snapped, line.ends()[1].vertex.snapped);
    const int major = setup.x_major ? fragment.x : fragment.y;
    return Big(setup.step_at(major)) / Big(setup.steps());
  }

  const Scene& scene_;
  const Mesh& mesh_;
  const View& view_;
  const RenderSettings& settings_;
  const Draw& draw_;
  const Lighting& lighting_;
  BigMatrix eye_, clip_;
  std::vector<in_full::Level> levels_;  // of the texture, if there is one
};

TEST_CASE("every fragment of lines, points and edges is within its bound") {
  Random random(46);
  AllKept all;
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    const Scene scene = scene_of_lines(random, i % 3 == 0);
    const PerspectiveLens lens{random.between(0.7, 1.5), std::pow(10, random.between(-3, -0.5)),
                               8.0};
    const Point<World, double> eye{random.between(-1, 1), 0.5, random.between(0, 3)};
    const Point<World, double> target{0, random.between(-1, 1), 0};
    const auto eye_from_world = look_at(eye, target, {random.between(-0.5, 0.5), 1, 0});
    REQUIRE(eye_from_world);
    const auto view = make_view({"random", lens, inverse_rigid(*eye_from_world)}, 80, 60);
    REQUIRE(view);
    RenderSettings settings;
    settings.shading = random.unit() < 0.5 ? Shading::kUnlit : Shading::kPhong;
    settings.wireframe = i % 2 == 0;
    const PreparedScene prepared = prepare_scene(scene, settings.transfer);
    const DrawList list = make_draw_list(scene, prepared, *view);
    const TracedRun run = trace(scene, *view, settings, {});
    const DrawBounds draw_bounds = bounds_of(run.trace.draws[0], *view);
    const auto known = bounds_of_all(run.trace);
    const LineOracle oracle(scene, *view, settings, list.draws[0], list.lighting);
    const CornerStage stage{list.draws[0], draw_bounds, list.lighting, settings};
    int taken = 0;
    for (const TracedFragment& fragment : run.trace.fragments) {
      const FragmentSource& source = fragment.source;
      const bool is_point = source.line == LineKind::kPoint;
      if (source.is_triangle || (!is_point && ++taken % 3 != 0)) continue;
      const bool is_edge = source.line == LineKind::kEdge;
      const BoundsOfRun::KnownTriangle* const triangle =
          is_edge ? &known.at(source.number) : nullptr;
      const LineBounds line(stage, run.trace, run.trace.draws[0], source, triangle);
      oracle.compare(run.trace, fragment, is_edge ? triangle->triangle : nullptr, line, all);
    }
  }
  all.depth.check(0.05);
  all.inverse_w.check(0.05);
  all.screen.check(0.05);
  for (const LineErrorRatio* kept :
       {&all.surface, &all.texcoord, &all.normal, &all.light, &all.stored}) {
    kept->check(0.02);
  }
  // Bounds of some dozens of roundings of 2^-24, of numbers up to 1, and of light up to 12 times as
  // much.
  all.normal.check_half_below(32 * 0x1p-24);
  all.texcoord.check_half_below(64 * 0x1p-24);
  all.light.check_half_below(12 * 64 * 0x1p-24);
  CHECK(all.without_normal > 100);
  CHECK(all.cut > 500);
  for (const LineKind kind : {LineKind::kEdge, LineKind::kLine, LineKind::kPoint}) {
    CHECK(all.kinds[kind] > 100);
  }
}

TEST_CASE("a line that may miss a pixel is one that does when its ends are moved so far") {
  Random random(47);
  int doubtful = 0, certain = 0, missed = 0;
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
      missed += misses;
      (may_miss ? doubtful : certain) += 1;
    });
  }
  CHECK(missed > 50);
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
  CHECK(of_edges.snapped.count() == 6);  // each corner once
}

TEST_CASE("a line without normals that a plane cuts is as exact as one that none cuts") {
  Mesh mesh;
  mesh.positions = {{-1, 0.1f, 0.9f}, {1, 0.2f, -0.9f}};
  mesh.lines.push_back({Corner{0}, Corner{1}});
  const Scene scene = test::scene_of(mesh);
  Camera camera = test::camera_for(scene, 4.0 / 3);
  const auto whole = make_view(camera, 80, 60);
  REQUIRE(whole);
  // Half of the line is nearer than its middle, and is cut off.
  const Point<Eye, double> middle = whole->eye_from_world * Point<World, double>(0, 0.15, 0);
  std::get<PerspectiveLens>(camera.lens).near = -middle.z;
  const auto cutting = make_view(camera, 80, 60);
  REQUIRE(cutting);
  const PictureErrors uncut = picture_errors(scene, *whole, {});
  const PictureErrors cut = picture_errors(scene, *cutting, {});
  CHECK(uncut.cut.count() == 0);
  CHECK(cut.cut.count() == 1);
  for (const PictureErrors* errors : {&uncut, &cut}) {
    CHECK(errors->picture.count() > 10);
    CHECK(errors->picture.unbounded() == 0);
    CHECK(errors->picture.largest() < 1);
    CHECK(errors->normal.count() == 0);  // it has none
  }
}

TEST_CASE("what planes cut off a triangle is counted once, with its edges and without") {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0.9f}, {1, -1, -0.9f}, {0, 1, -0.9f}};
  test::add_face(mesh, {0, 1, 2});
  const Scene scene = test::scene_of(mesh);
  Camera camera = test::camera_for(scene, 4.0 / 3);
  const auto whole = make_view(camera, 80, 60);
  REQUIRE(whole);
  std::vector<double> distances;
  for (const Point<Object>& p : mesh.positions) {
    distances.push_back(-(whole->eye_from_world * Point<World, double>(p.x, p.y, p.z)).z);
  }
  std::ranges::sort(distances);
  std::get<PerspectiveLens>(camera.lens).near = (distances[0] + distances[1]) / 2;
  const auto view = make_view(camera, 80, 60);
  REQUIRE(view);
  RenderSettings settings;
  settings.cull = Cull::kNone;
  const PictureErrors filled = picture_errors(scene, *view, settings);
  settings.wireframe = true;
  const PictureErrors edges = picture_errors(scene, *view, settings);
  CHECK(filled.cut.count() == 2);
  CHECK(edges.fragments_of_lines_and_points > 0);
  CHECK(edges.cut.count() == filled.cut.count());
  CHECK(edges.vertices_snapped_elsewhere == filled.vertices_snapped_elsewhere);
}

}  // namespace
}  // namespace glassbox
