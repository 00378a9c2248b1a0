// Whole draws that are left out because their box is outside of a plane.
#include "tests/render/plan/plan_checks.h"

namespace glassbox {
namespace {

using namespace test;

TEST_CASE("draws beyond any plane of the view are left out, and no stage sees them") {
  const View view = planned_view();
  Scene scene = ball_to_place();
  add_instance_at(scene, 0, {0, 0, -5});
  const std::uint64_t positions = scene.meshes[0].positions.size();
  const std::uint64_t faces = 2 * scene.meshes[0].faces.size();
  const std::array<Vector<World, double>, 6> beyond{
      {{-9, 0, -5}, {9, 0, -5}, {0, 9, -5}, {0, -9, -5}, {0, 0, 5}, {0, 0, -30}}};
  for (const auto& at : beyond) add_instance_at(scene, 0, at);

  const Statistics planned = check_planned(scene, view, test::with_ids());
  CHECK(planned.vertices == positions);
  CHECK(planned.left_out == 6 * faces);
  const Statistics all = counts_without_plan(scene, view);
  CHECK(all.vertices == 7 * positions);
  CHECK(all.left_out == 0);

  const PlannedScene plan = plan_of(scene, view);
  const std::array<const char*, 6> names{"left edge",   "right edge", "top edge",
                                         "bottom edge", "near",       "far"};
  for (std::size_t i = 0; i < 6; ++i) {
    REQUIRE(plan.plan.methods[i + 1].classification.outside_of != nullptr);
    CHECK(std::string(plan.plan.methods[i + 1].classification.outside_of) == names[i]);
  }
}

TEST_CASE("a picture of nothing but draws that are left out is its background") {
  const View view = planned_view();
  const Statistics counts = check_planned(ball_at({50, 0, -5}), view, test::with_ids());
  CHECK(counts.vertices == 0);
}

TEST_CASE("a draw that reaches into the view is not left out") {
  const View view = planned_view();
  for (const auto& at : std::array<Vector<World, double>, 5>{
           {{-4, 0, -5}, {4, 0, -5}, {0, 2.9, -5}, {0, 0, 0}, {0, 0, -20.5}}}) {
    const Scene scene = ball_at(at);
    CHECK(plan_of(scene, view).plan.methods[0].drawn);
    CHECK(decision(scene, view, "the whole draw").needed);
    check_planned(scene, view, test::with_ids());
  }
}

// A random draw close to an edge of the picture, and the view that shows it.
struct AtTheEdge {
  Scene scene;
  View view;
};
AtTheEdge at_the_edge(Random& random) {
  const bool perspective = random.integer(0, 1) == 0;
  const int width = int(random.integer(17, 130)), height = int(random.integer(17, 130));
  const Lens lens = perspective ? Lens(PerspectiveLens{kDegrees45, 0.5, 20.0})
                                : Lens(OrthographicLens{2, 0.5, 20});
  const double aspect = double(width) / height;
  const double z = -random.between(1, 12);
  const double half = perspective ? -z * 0.41421356237309503 : 2;
  // Small; its centre is about as far from the edge as it is large.
  const double size = random.between(0.01, 0.6);
  const double beside = half * aspect + random.between(-0.5, 2) * size;
  const double x = random.integer(0, 1) == 0 ? beside : -beside;
  const double y = random.between(-half, half);
  const bool upright = random.integer(0, 1) == 0;
  Scene scene = ball_to_place({}, random.bits());
  add_instance_at(scene, 0, {upright ? x : y * aspect, upright ? y : x / aspect, z}, size);
  return {std::move(scene), planned_view(lens, width, height)};
}

// How many draws a given margin leaves out, and how many of those are visible in some pixel.
struct OutsideDraws {
  int outside = 0, visible = 0;
};
OutsideDraws count_outside(double margin_px, int tries) {
  OutsideDraws found;
  Random random(20260611);
  for (int i = 0; i < tries; ++i) {
    const AtTheEdge at = at_the_edge(random);
    const PlannedScene planned = plan_of(at.scene, at.view);
    if (classify_draw_box(planned.list.draws[0], at.view, margin_px).outside_of == nullptr)
      continue;
    ++found.outside;
    const Rendering staged = render_staged(at.scene, at.view, test::with_ids());
    found.visible +=
        std::ranges::any_of(staged.buffers.id.pixels, [](std::uint32_t id) { return id != 0; });
  }
  return found;
}

TEST_CASE("what lies outside by its box shows in no pixel, however close to the edge it is") {
  const OutsideDraws found = count_outside(kOutsideMarginPx, 1000);
  CHECK(found.outside > 50);
  CHECK(found.visible == 0);
}

TEST_CASE("a margin of the wrong sign is caught") {
  CHECK(count_outside(-kOutsideMarginPx, 1000).visible > 0);
  const Planner wrong = [](std::span<const PlannedEye> eyes, bool leave_out) {
    std::vector<Plan> plans = make_plans(eyes, leave_out);
    const Draw& draw = eyes.front().list.draws.front();
    if (classify_draw_box(draw, eyes.front().view, -30).outside_of != nullptr) {
      plans.front().methods.front().drawn = false;
      plans.front().order.clear();
    }
    return plans;
  };
  const Scene scene = ball_at({-3.6, 0, -5});
  check_same(scene, planned_view(), test::with_ids());
  CHECK(differs_with_planner(scene, planned_view(), test::with_ids(), wrong));
}

TEST_CASE(
    "lines and points beyond an edge are left out with their draw, and not when they touch it") {
  const View view = planned_view(OrthographicLens{1, 0.5, 20});
  Random random(7);
  int left_out = 0, drawn = 0;
  for (int i = 0; i < 200; ++i) {
    Mesh mesh;
    // Pixels are 1/32 wide, and the right edge is at 1.5.
    const double x = 1.5 + random.between(-4, 8) / 32;
    for (int k = 0; k < 2; ++k) {
      mesh.positions.push_back(
          {float(x + random.between(0, 0.1)), float(random.between(-1.2, 1.2)), -3.0f});
    }
    mesh.lines.push_back({Corner{0}, Corner{1}});
    mesh.points.push_back(Corner{0});
    const Scene scene = scene_of(mesh);
    const bool is_drawn = plan_of(scene, view).plan.methods[0].drawn;
    ++(is_drawn ? drawn : left_out);
    check_same(scene, view, {});
  }
  CHECK(left_out > 20);
  CHECK(drawn > 20);
}

TEST_CASE(
    "a mesh with a position that is not finite lies nowhere, and is drawn as the staged reference "
    "does") {
  Scene scene = ball_at({50, 0, -5});
  scene.meshes[0].positions[3].y = std::numeric_limits<float>::quiet_NaN();
  CHECK(plan_of(scene, planned_view()).plan.methods[0].drawn);
  scene = ball_at({0, 0, -5});
  scene.meshes[0].positions[3].y = std::numeric_limits<float>::quiet_NaN();
  CHECK(plan_of(scene, planned_view()).plan.methods[0].test_planes);
  check_same(scene, planned_view(), test::with_ids());
}

}  // namespace
}  // namespace glassbox
