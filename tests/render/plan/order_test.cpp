// Draws are sorted front to back where that changes no byte.
#include <algorithm>
#include <cmath>

#include <glassbox/render/plan/draw_order.h>

#include "tests/render/plan/plan_checks.h"

namespace glassbox {
namespace {

using namespace test;

// A square across the view at depth z, turned about y so that its ends are `slant` nearer and
// farther. The farther a square is, the more of the view it fills: none hides another, and one at
// -18 fills the view.
void add_square(Scene& scene, double z, double slant, const Rgba& color) {
  Material material;
  material.base_color = color;
  material.unlit = true;
  material.double_sided = true;
  Mesh mesh;
  const auto size = float(0.63 * z * z / 18);  // 0.62 of its distance fills the view
  for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    mesh.positions.push_back({float(x) * size, float(y) * size, float(z + x * slant)});
  }
  add_face(mesh, {0, 1, 2, 3});
  add_object(scene, std::move(mesh), std::move(material));
}

Rgba color_of(int i) {
  return {float(i % 3) / 2, float(i % 5) / 4, float(i % 7) / 6, 1};
}

Scene squares(const std::vector<double>& depths, double slant) {
  Scene scene;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    add_square(scene, depths[i], slant, color_of(int(i)));
  }
  return scene;
}

Scene back_to_front() {
  std::vector<double> depths;
  for (int i = 0; i < 16; ++i) depths.push_back(-18.0 + i);
  return squares(depths, 0);
}

TEST_CASE(
    "opaque draws with depths of their own are drawn nearest first, and fewer fragments are "
    "written") {
  for (const DepthFormat format : {DepthFormat::kFloat32, DepthFormat::kFloat32Reversed,
                                   DepthFormat::kUnorm24, DepthFormat::kUnorm16}) {
    RenderSettings settings;
    settings.depth = format;
    const bool reversed = format == DepthFormat::kFloat32Reversed;
    const View view = planned_view(PerspectiveLens{kDegrees45, 0.5, 20.0}, 96, 64,
                                   reversed ? DepthRange::kReversed : DepthRange::kStandard);
    const Scene scene = back_to_front();
    const Plan plan = plan_of(scene, view, settings).plan;
    CHECK(plan.moved == 15);
    CHECK(plan.order.front() == 15);
    CHECK(plan.order.back() == 0);
    const Statistics planned = check_planned(scene, view, settings);
    CHECK(planned.written == 96 * 64);
    const Statistics in_file_order = counts_without_plan(scene, view, settings);
    CHECK(in_file_order.written == in_file_order.covered);
    CHECK(in_file_order.written > 3 * planned.written);
  }
}

TEST_CASE("draws that share depth codes keep the order of the file, where the first wins a tie") {
  const View view = planned_view();
  for (const Scene& scene : {squares({-5, -5, -5}, 0), squares({-6, -5.5, -5}, 1)}) {
    CHECK(plan_of(scene, view).plan.moved == 0);
    check_planned(scene, view);
  }
  // Depths that differ, but are equal in 16 bits.
  RenderSettings coarse;
  coarse.depth = DepthFormat::kUnorm16;
  const Scene close = squares({-15.005, -15}, 0);
  CHECK(plan_of(close, view, coarse).plan.moved == 0);
  CHECK(plan_of(close, view).plan.moved == 1);
  check_planned(close, view, coarse);
  check_planned(close, view);
}

TEST_CASE("turning the order of draws with equal depths round is caught") {
  const Planner reversed = [](std::span<const PlannedEye> eyes, bool leave_out) {
    std::vector<Plan> plans = make_plans(eyes, leave_out);
    std::ranges::reverse(plans.front().order);
    return plans;
  };
  CHECK(differs_with_planner(squares({-5, -5, -5}, 0), planned_view(), {}, reversed));
  CHECK_FALSE(differs_with_planner(back_to_front(), planned_view(), {}, reversed));  // no tie there
}

TEST_CASE("nothing is moved past what is blended or drawn without the plan") {
  const View view = planned_view();
  Scene scene = back_to_front();
  scene.materials[8].alpha_mode = AlphaMode::kMask;
  scene.materials[12].alpha_mode = AlphaMode::kBlend;
  scene.materials[12].base_color.a = 0.5f;
  const Plan plan = plan_of(scene, view).plan;
  CHECK(plan.order[6] == 8);       // a masked draw is moved like any other
  CHECK(plan.order.back() == 15);  // the blended draw, which is the last one of the list
  CHECK(plan.order.front() == 14);
  check_planned(scene, view);
  CHECK(plan_of(scene, view, {}, false).plan.moved == 0);
}

TEST_CASE("all depth codes of a draw lie within those that are foreseen for it") {
  Random random(42);
  for (const DepthFormat format : {DepthFormat::kFloat32, DepthFormat::kFloat32Reversed,
                                   DepthFormat::kUnorm24, DepthFormat::kUnorm16}) {
    int narrow = 0;
    for (int i = 0; i < 60; ++i) {
      const bool perspective = random.integer(0, 2) != 0;
      const double near = std::exp(random.between(-6, 0));
      const Lens lens = perspective ? Lens(PerspectiveLens{kDegrees45, near, 20.0})
                                    : Lens(OrthographicLens{4, near, 20});
      const bool reversed = format == DepthFormat::kFloat32Reversed;
      const View view =
          planned_view(lens, 64, 48, reversed ? DepthRange::kReversed : DepthRange::kStandard);
      Scene scene = ball_to_place({}, random.bits());
      const double x = random.between(-1, 1), y = random.between(-1, 1);
      const double z = -random.between(0, 21);
      add_instance_at(scene, 0, {x, y, z}, std::exp(random.between(-5, 1)));
      RenderSettings settings;
      settings.depth = format;
      const PlannedScene planned = plan_of(scene, view, settings);
      const DepthCodes codes = depth_codes(planned.list.draws[0], view, format);
      narrow += codes.farthest != kEmptyDepth;
      for (const std::uint32_t code : render_staged(scene, view, settings).buffers.depth.pixels) {
        if (code == kEmptyDepth) continue;
        REQUIRE(code >= codes.nearest);
        REQUIRE(code <= codes.farthest);
      }
    }
    CHECK(narrow > 30);
  }
}

TEST_CASE("a draw overtakes only those whose codes lie wholly behind its own") {
  const std::vector<DepthCodes> codes{{50, 60}, {40, 55}, {10, 20}, {20, 30}, {0, 5}};
  std::vector<std::uint32_t> order{0, 1, 2, 3, 4};
  CHECK(order_front_to_back(order, codes) == 3);
  CHECK(order == std::vector<std::uint32_t>{4, 2, 3, 0, 1});
}

}  // namespace
}  // namespace glassbox
