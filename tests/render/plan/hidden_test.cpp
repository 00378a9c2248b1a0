// Whole draws that are left out because others hide them.
#include <glassbox/raster/coverage.h>
#include <glassbox/render/plan/hidden_draws.h>
#include <glassbox/render/plan/occlusion_buffer.h>
#include <glassbox/render/renderer.h>
#include <glassbox/render/stereo/render_pair.h>

#include "tests/render/plan/plan_checks.h"

namespace glassbox {
namespace {

using namespace test;

Material wall_material() {
  Material material;
  material.base_color = {0.8f, 0.7f, 0.5f, 1};
  material.unlit = true;
  material.double_sided = true;
  return material;
}

// A mesh of `across` x `across` quads from corner to corner at depth z, with its own material.
void add_wall(Scene& scene, const std::array<double, 4>& x0_y0_x1_y1, double z,
              Material material = wall_material(), int across = 1) {
  const auto& [x0, y0, x1, y1] = x0_y0_x1_y1;
  Mesh mesh;
  for (int j = 0; j <= across; ++j) {
    for (int i = 0; i <= across; ++i) {
      mesh.positions.push_back(
          {float(x0 + (x1 - x0) * i / across), float(y0 + (y1 - y0) * j / across), float(z)});
    }
  }
  const auto index = [&](int i, int j) { return std::uint32_t(j * (across + 1) + i); };
  for (int j = 0; j < across; ++j) {
    for (int i = 0; i < across; ++i) {
      add_face(mesh, {index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  add_object(scene, std::move(mesh), std::move(material));
}

constexpr std::array<double, 4> kWholeView{-4, -3, 4, 3};

// Balls of mesh 0, which precede all walls in the scene.
Scene balls_at(const std::vector<Vector<World, double>>& places, double size = 1) {
  Scene scene = ball_to_place();
  for (const auto& at : places) add_instance_at(scene, 0, at, size);
  return scene;
}

RenderSettings with_planes() {
  RenderSettings settings;
  settings.want_depth = settings.want_distance = settings.want_id = true;
  return settings;
}

std::size_t hidden_in(const Scene& scene, const View& view, const RenderSettings& settings = {}) {
  const Plan plan = plan_of(scene, view, settings).plan;
  return std::size_t(
      std::ranges::count_if(plan.methods, [](const DrawMethod& m) { return m.hidden; }));
}

TEST_CASE("draws behind a wall are left out, and no stage sees them") {
  for (const DepthFormat format : {DepthFormat::kFloat32, DepthFormat::kFloat32Reversed,
                                   DepthFormat::kUnorm24, DepthFormat::kUnorm16}) {
    for (const int samples : {1, 4}) {
      RenderSettings settings = with_planes();
      settings.depth = format;
      settings.samples = samples;
      const bool reversed = format == DepthFormat::kFloat32Reversed;
      const View view = planned_view(PerspectiveLens{kDegrees45, 0.5, 20.0}, 101, 67,
                                     reversed ? DepthRange::kReversed : DepthRange::kStandard);
      Scene scene = balls_at({{0, 0, -7}, {2, 1, -8}, {-2, 0.5, -12}, {0, -1, -16}});
      const std::uint64_t faces = 2 * scene.meshes[0].faces.size();
      add_wall(scene, kWholeView, -4);
      const Statistics planned = check_planned(scene, view, settings);
      CHECK(planned.vertices == 4);
      CHECK(planned.left_out == 4 * faces);
      CHECK(counts_without_plan(scene, view, settings).left_out == 0);
    }
  }
}

TEST_CASE("explain says what is hidden, and where another eye sees it") {
  const View view = planned_view();
  Scene scene = balls_at({{0, 0, -7}});
  add_wall(scene, kWholeView, -4);
  const Decision hidden = decision(scene, view, "the whole draw");
  CHECK_FALSE(hidden.needed);
  const RenderSettings settings;
  const PlannedScene planned = plan_of(scene, view, settings);
  const std::vector<Decision> picture =
      decisions(planned.plan, PlannedEye{planned.list, view, settings});
  REQUIRE(picture.front().stage == std::string("file order"));
  CHECK_FALSE(picture.front().needed);  // the scene has two draws to compare
  CHECK(hidden.because.find("at least as near as its own") != std::string::npos);
}

TEST_CASE("what a wall does not hide is drawn") {
  const View view = planned_view();
  const auto is_drawn = [&](const Scene& scene) {
    check_planned(scene, view, with_planes());
    return hidden_in(scene, view) == 0;
  };
  const auto behind = [&](const Material& material) {
    Scene scene = balls_at({{0, 0, -7}});
    add_wall(scene, kWholeView, -4, material);
    return scene;
  };
  Material cut = wall_material(), glass = wall_material(), one_sided = wall_material();
  cut.alpha_mode = AlphaMode::kMask;
  glass.alpha_mode = AlphaMode::kBlend;
  glass.base_color.a = 0.5f;
  one_sided.double_sided = false;
  CHECK_FALSE(is_drawn(behind(wall_material())));
  CHECK_FALSE(is_drawn(behind(one_sided)));
  CHECK(is_drawn(behind(cut)));
  CHECK(is_drawn(behind(glass)));
  Scene from_behind = balls_at({{0, 0, -7}});
  add_wall(from_behind, {4, -3, -4, 3}, -4, one_sided);
  CHECK(is_drawn(from_behind));

  Scene in_front = balls_at({{0, 0, -3}}, 0.3);
  add_wall(in_front, kWholeView, -4);
  CHECK(is_drawn(in_front));
  Scene through = balls_at({{0, 0, -4}});
  add_wall(through, kWholeView, -4);
  CHECK(is_drawn(through));
  // A wall that recedes: nearer than the ball at one end, farther where the ball is.
  Scene slanted = balls_at({{4, 0, -9}}, 0.5);
  add_wall(slanted, {-4, -9, 12, 9}, 0);
  for (auto& p : slanted.meshes.back().positions) p.z = p.x < 0 ? -3.0f : -19.0f;
  std::ranges::reverse(slanted.instances);  // the wall first
  CHECK(is_drawn(slanted));
  Scene beside = balls_at({{0.5, 0, -7}});
  add_wall(beside, {-4, -3, 0.3, 3}, -4);
  CHECK(is_drawn(beside));
  Scene slit = balls_at({{0, 0, -7}});
  add_wall(slit, {-4, -3, -0.05, 3}, -4);
  add_wall(slit, {0.05, -3, 4, 3}, -4);
  CHECK(is_drawn(slit));
  Scene joined = balls_at({{0, 0, -7}});
  add_wall(joined, {-4, -3, 0, 3}, -4);
  add_wall(joined, {0, -3, 4, 3}, -4);
  CHECK_FALSE(is_drawn(joined));
}

TEST_CASE("blended and masked draws behind a wall are left out like others") {
  const View view = planned_view();
  for (const AlphaMode mode : {AlphaMode::kBlend, AlphaMode::kMask}) {
    Material material;
    material.alpha_mode = mode;
    material.base_color.a = 0.6f;
    Scene scene = ball_at({0, 0, -7}, material);
    add_wall(scene, kWholeView, -4);
    CHECK(hidden_in(scene, view) == 1);
    check_planned(scene, view, with_planes());
  }
}

TEST_CASE("a wall of more triangles than looking is worth hides nothing beforehand") {
  const View view = planned_view();
  Scene scene = balls_at({{0, 0, -7}});
  add_wall(scene, kWholeView, -4, wall_material(), 30);
  CHECK(hidden_in(scene, view) == 0);
  check_planned(scene, view);
}

// ---- random walls ----

// A wall, and a ball behind it near one of its edges.
Scene near_the_edge(Random& random) {
  const double z = -random.between(1, 6);
  const double edge = random.between(-0.3, 0.3) * z;
  const double behind = z - random.between(1.2, 8);
  const double size = random.between(0.05, 1);
  // Near where the ball would just touch the line of sight past the edge.
  const double at = edge / z * behind + random.between(-6, 1) * size;
  const bool upright = random.integer(0, 1) == 0;
  Scene scene = ball_to_place({}, random.bits());
  add_instance_at(scene, 0, {upright ? at : 0, upright ? 0 : at, behind}, size);
  add_wall(scene,
           {upright ? edge - 20 : -20, upright ? -20 : edge - 20, upright ? edge : 20,
            upright ? 20 : edge},
           z);
  return scene;
}

struct HiddenBalls {
  int hidden = 0, visible = 0;
};
HiddenBalls count_hidden_balls(double margin_px, int tries) {
  HiddenBalls counts;
  Random random(20261123);
  for (int i = 0; i < tries; ++i) {
    const Scene scene = near_the_edge(random);
    const int width = int(random.integer(60, 200)), height = int(random.integer(40, 150));
    const View view = planned_view(PerspectiveLens{kDegrees45, 0.5, 20.0}, width, height);
    RenderSettings settings = with_planes();
    settings.samples = random.integer(0, 3) == 0 ? 4 : 1;
    PlannedScene planned = plan_of(scene, view, settings, false);
    std::ranges::reverse(planned.plan.order);  // the wall first
    planned.plan.codes = plan_of(scene, view, settings).plan.codes;
    const PlannedEye eye{planned.list, view, settings};
    if (!find_hidden_draws(eye, planned.plan, margin_px)[0]) continue;
    ++counts.hidden;
    const Rendering staged = render_staged(scene, view, settings);
    const std::uint32_t ball = planned.list.draws[0].triangulation->numbered;
    counts.visible += std::ranges::any_of(staged.buffers.id.pixels,
                                          [&](std::uint32_t id) { return id >= 1 && id <= ball; });
  }
  return counts;
}

TEST_CASE("what is hidden by its box shows in no pixel, however close to the wall's edge it is") {
  const HiddenBalls counts = count_hidden_balls(kOutsideMarginPx, 1000);
  CHECK(counts.hidden > 100);
  CHECK(counts.visible == 0);
}

TEST_CASE("a box that is taken for smaller than it is, is caught") {
  CHECK(count_hidden_balls(-20, 1000).visible > 0);
  const Planner wrong = [](std::span<const PlannedEye> eyes, bool leave_out) {
    std::vector<Plan> plans = make_plans(eyes, leave_out);
    std::erase(plans.front().order, 0u);
    return plans;
  };
  Scene scene = balls_at({{0.5, 0, -7}});
  add_wall(scene, {-4, -3, 0.3, 3}, -4);
  CHECK(differs_with_planner(scene, planned_view(), {}, wrong));
}

TEST_CASE("random balls and walls: the same bytes, hidden or not") {
  Random random(77);
  std::size_t hidden = 0;
  for (int i = 0; i < 400 / kCaseDivisor; ++i) {
    Scene scene = ball_to_place({}, random.bits());
    const auto coordinate = [&](double z) { return random.between(-0.6, 0.6) * z; };
    for (int ball = 0; ball < 4; ++ball) {
      const double z = -random.between(2, 18);
      const double x = coordinate(z), y = coordinate(z);
      add_instance_at(scene, 0, {x, y, z}, random.between(0.05, 1));
    }
    for (int wall = 0; wall < 3; ++wall) {
      const double z = -random.between(1, 12);
      Material material = wall_material();
      material.double_sided = random.integer(0, 2) != 0;
      const double a = coordinate(z), b = coordinate(z), c = coordinate(z), d = coordinate(z);
      add_wall(scene, {a, b, c, d}, z, material, int(random.integer(1, 3)));
      // Every other time another wall as large as the view.
      if (random.integer(0, 1) == 0) add_wall(scene, {5 * z, 5 * z, -5 * z, -5 * z}, z - 3);
    }
    RenderSettings settings = with_planes();
    settings.samples = random.integer(0, 2) == 0 ? 4 : 1;
    const int width = int(random.integer(17, 120)), height = int(random.integer(17, 90));
    const View view = planned_view(PerspectiveLens{kDegrees45, 0.5, 20.0}, width, height);
    hidden += hidden_in(scene, view, settings);
    check_same(scene, view, settings);
  }
  CHECK(hidden > 200 / kCaseDivisor);
}

// ---- two eyes ----

TEST_CASE("what one eye sees past a wall's edge is drawn for both") {
  int one_eye = 0, no_eye = 0;
  for (int i = 0; i < 40; ++i) {
    Scene scene = balls_at({{-2 + i * 0.08, 0, -7}}, 0.5);
    add_wall(scene, {-4, -3, 0.2, 3}, -3);
    const View centre = planned_view();
    const StereoPair pair{.half_separation = 0.2, .window = 4};
    const StereoSettings settings{with_planes()};
    Renderer staged(scene, Transfer::kSrgb, EngineKind::kStaged);
    Renderer tile(scene, Transfer::kSrgb, EngineKind::kTile, TileOptions{});
    const StereoRendering expected = staged.render_pair(centre, pair, settings);
    const StereoRendering both = tile.render_pair(centre, pair, settings);
    CHECK(planes_differ(expected.left, both.left, true) == "");
    CHECK(planes_differ(expected.right, both.right, true) == "");
    const auto hides = [&](Side side) {
      return hidden_in(scene, eye_view(centre, pair, side), settings.render) > 0;
    };
    const bool left = hides(Side::kLeft), right = hides(Side::kRight);
    one_eye += left != right;
    no_eye += left && right;
    CHECK((both.left_statistics.left_out > 0) == (left && right));
  }
  CHECK(one_eye > 3);
  CHECK(no_eye > 3);
}

// ---- the parts of the picture that are covered ----

ScreenVertex random_vertex(Random& random) {
  return {{float(random.between(-30, 90)), float(random.between(-30, 70)), 0.5f}, 1.0f};
}

TEST_CASE("a part that is said to be covered is covered at each of its points, and as near") {
  constexpr PixelRect kWindow{0, 0, 53, 37};  // some cells reach beyond the window
  Random random(5);
  int covered = 0, asked = 0;
  for (int i = 0; i < 300 / kCaseDivisor; ++i) {
    const std::span<const SampleOffset> points = sample_offsets(i % 2 == 0 ? 1 : 4);
    OcclusionBuffer cover(kWindow, points);
    // The nearest code for each sample point and pixel.
    std::vector<std::uint32_t> nearest(points.size() * 53 * 37, kEmptyDepth);
    for (int t = 0; t < 12; ++t) {
      const auto setup =
          setup_triangle({random_vertex(random), random_vertex(random), random_vertex(random)});
      if (!setup) continue;
      const auto code = std::uint32_t(random.integer(1, 1000));
      cover.add(*setup, code);
      for (std::size_t p = 0; p < points.size(); ++p) {
        for (int at = 0; at < 53 * 37; ++at) {
          const std::int64_t x = (at % 53) * kSubpixels + kPixelCentre + points[p].x;
          const std::int64_t y = (at / 53) * kSubpixels + kPixelCentre + points[p].y;
          const bool inside = std::ranges::all_of(
              setup->edges, [&](const EdgeFunction& e) { return e.covers(e.at(x, y)); });
          std::uint32_t& there = nearest[p * 53 * 37 + std::size_t(at)];
          if (inside) there = std::min(there, code);
        }
      }
    }
    for (int q = 0; q < 20; ++q) {
      const int x = int(random.integer(-5, 52)), y = int(random.integer(-5, 36));
      const PixelRect part{x, y, x + int(random.integer(1, 30)), y + int(random.integer(1, 30))};
      const auto code = std::uint32_t(random.integer(1, 1000));
      ++asked;
      if (!cover.occludes(part, code)) continue;
      ++covered;
      const PixelRect seen = intersect(part, kWindow);
      for (std::size_t p = 0; p < points.size(); ++p) {
        for (int row = seen.y0; row < seen.y1; ++row) {
          for (int column = seen.x0; column < seen.x1; ++column) {
            REQUIRE(nearest[p * 53 * 37 + std::size_t(row * 53 + column)] <= code);
          }
        }
      }
    }
  }
  CHECK(covered * 20 > asked);
}

TEST_CASE("a triangle alone covers the cells that lie within it, with its own code") {
  OcclusionBuffer cover({0, 0, 64, 64}, sample_offsets(1));
  const auto corner = [](float x, float y) { return ScreenVertex{{x, y, 0.5f}, 1.0f}; };
  const auto far = setup_triangle({corner(0, 0), corner(40, 0), corner(0, 40)});
  const auto near = setup_triangle({corner(-100, -100), corner(300, -100), corner(-100, 300)});
  REQUIRE(far);
  REQUIRE(near);
  cover.add(*far, 900);  // covers some cells only in part
  CHECK(cover.occludes({0, 0, 16, 16}, 900));
  CHECK_FALSE(cover.occludes({0, 0, 16, 16}, 899));
  // A cell is judged as a whole, and the next one is not covered.
  CHECK_FALSE(cover.occludes({0, 0, 17, 16}, 1000));
  cover.add(*near, 500);
  CHECK(cover.occludes({0, 0, 64, 64}, 500));
  CHECK_FALSE(cover.occludes({0, 0, 64, 64}, 499));
  CHECK_FALSE(cover.occludes({64, 0, 80, 16}, 1000));  // nothing is known outside the window
}

}  // namespace
}  // namespace glassbox
