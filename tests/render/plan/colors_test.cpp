// The planes of the framebuffer and the parts of colour computation that the plan leaves out.
#include <glassbox/mesh/builtin/scenes.h>

#include "tests/render/plan/plan_checks.h"

namespace glassbox {
namespace {

using namespace test;

template <auto change>
std::vector<Plan> plans_with(std::span<const PlannedEye> eyes, bool leave_out) {
  std::vector<Plan> plans = make_plans(eyes, leave_out);
  for (Plan& plan : plans) change(plan);
  return plans;
}

View small_view_of(const Scene& scene) {
  const auto view = make_view(camera_for(scene, 1.5), 96, 64);
  REQUIRE(view);
  return *view;
}

RenderSettings depth_only() {
  RenderSettings settings;
  settings.mask = {false, false, false, false};
  settings.want_depth = true;
  return settings;
}

TEST_CASE("a picture without colours needs no light, no normals and no texture") {
  const Scene room = test::built_in("room");
  const View view = small_view_of(room);
  CHECK(counts_without_plan(room, view).normals > 0);
  RenderSettings numbers, depths;
  numbers.show = Show::kId;
  depths.show = Show::kDepth;
  for (const RenderSettings& settings : {depth_only(), numbers, depths}) {
    const Statistics counts = check_planned(room, view, settings);
    CHECK(counts.normals == 0);
    CHECK(counts.eye_positions == 0);
    const PlannedScene planned = plan_of(room, view, settings);
    CHECK_FALSE(planned.plan.colors);
    for (const DrawMethod& method : planned.plan.methods) CHECK_FALSE(method.texture);
  }
  CHECK(plan_of(room, view).plan.colors);
  CHECK(differs_with_planner(room, view, {}, plans_with<[](Plan& plan) { plan.colors = false; }>));
}

TEST_CASE(
    "a picture of numbers has the colours behind blended lines and points, with a plan or not") {
  Material wall, glass;
  wall.base_color = {0.2f, 0.9f, 0.4f, 1};
  glass.base_color = {1, 0, 0, 0.5f};
  glass.alpha_mode = AlphaMode::kBlend;
  Mesh quad, marks;
  quad.positions = {{-1, -1, -3}, {1, -1, -3}, {1, 1, -3}, {-1, 1, -3}};
  add_face(quad, {0, 1, 2, 3});
  marks.positions = {{-0.5f, 0, -2}, {0.5f, 0.1f, -2}, {0, 0.5f, -2}};
  marks.lines = {{Corner{0}, Corner{1}}};
  marks.points = {Corner{2}};
  Scene scene;
  add_object(scene, quad, wall);
  add_object(scene, quad, wall);  // a tie, so that one draw is hidden
  RenderSettings settings;
  settings.show = Show::kId;
  const View view = planned_view();
  CHECK_FALSE(plan_of(scene, view, settings).plan.colors);
  add_object(scene, marks, glass);
  check_planned(scene, view, settings);
  CHECK(plan_of(scene, view, settings).plan.colors);
  CHECK(differs_with_planner(scene, view, settings,
                             plans_with<[](Plan& plan) { plan.colors = false; }>));
  // An opaque surface is behind the other draws anyway, and its colour has no effect.
  scene.materials.back().alpha_mode = AlphaMode::kOpaque;
  check_planned(scene, view, settings);
  CHECK_FALSE(plan_of(scene, view, settings).plan.colors);
}

TEST_CASE("highlights are left out where the material has none") {
  Material shiny;
  shiny.specular = {0, 0.5f, 0};
  const View view = planned_view();
  CHECK_FALSE(plan_of(ball_at({0, 0, -4}), view).plan.methods[0].highlights);
  CHECK(plan_of(ball_at({0, 0, -4}), view, {}, false).plan.methods[0].highlights);
  check_planned(ball_at({0, 0, -4}), view);
  check_planned(ball_at({0, 0, -4}, shiny), view);
  CHECK(differs_with_planner(ball_at({0, 0, -4}, shiny), view, {},
                             plans_with<[](Plan& plan) { plan.methods[0].highlights = false; }>));
}

TEST_CASE(
    "texture coordinates and the choice of a level are left out where no texture is sampled, or "
    "one level") {
  Scene checker = test::built_in("checker");
  const View view = small_view_of(checker);
  check_planned(checker, view);
  CHECK(decision(checker, view, "texture coordinates").needed);
  CHECK(decision(checker, view, "choice of a mip level").needed);
  CHECK(differs_with_planner(checker, view, {}, plans_with<[](Plan& plan) {
                               for (DrawMethod& method : plan.methods) method.texture = false;
                             }>));
  for (Texture& texture : checker.textures) {
    texture.sampler.mip = MipFilter::kNone;
    texture.sampler.magnify = texture.sampler.minify;
  }
  check_planned(checker, view);
  CHECK_FALSE(decision(checker, view, "choice of a mip level").needed);
  const Scene plain = ball_at({0, 0, -4});
  CHECK_FALSE(decision(plain, planned_view(), "texture coordinates").needed);
  CHECK_FALSE(decision(plain, planned_view(), "choice of a mip level").needed);
}

TEST_CASE("channels that the mask keeps are not encoded, and those that it writes are") {
  const Scene room = test::built_in("room");
  const View view = small_view_of(room);
  RenderSettings settings;
  settings.mask = {true, false, false, false};
  const ColorMask channels = plan_of(room, view, settings).plan.channels;
  CHECK(channels.r);
  CHECK_FALSE((channels.g || channels.b));
  CHECK(plan_of(room, view, settings, false).plan.channels.g);
  check_planned(room, view, settings);
  settings.mask = {false, true, true, true};
  check_planned(room, view, settings);
  CHECK(differs_with_planner(room, view, settings,
                             plans_with<[](Plan& plan) { plan.channels.b = false; }>));
}

TEST_CASE("depths are kept in a plane for somebody who asks") {
  const View view = planned_view();
  const Scene scene = ball_at({0, 0, -4});
  CHECK(render_tiled(scene, view, {}).buffers.depth.pixels.empty());
  CHECK_FALSE(render_tiled(scene, view, {}, without_plan()).buffers.depth.pixels.empty());
  RenderSettings settings;
  settings.want_depth = true;
  CHECK(render_tiled(scene, view, settings).buffers.depth.pixels.size() == 96 * 64);
  check_planned(scene, view, settings);
  CHECK(differs_with_planner(scene, view, settings,
                             plans_with<[](Plan& plan) { plan.keep_depth = false; }>));
}

TEST_CASE("what is blended reads what lies behind it, and nothing else does") {
  Material glass;
  glass.alpha_mode = AlphaMode::kBlend;
  glass.base_color = {1, 1, 1, 0.5f};
  glass.double_sided = true;
  const View view = planned_view();
  const Scene scene = ball_at({0, 0, -4}, glass);
  check_planned(scene, view);
  CHECK(decision(scene, view, "colour read-back").needed);
  CHECK_FALSE(decision(ball_at({0, 0, -4}), view, "colour read-back").needed);
}

TEST_CASE("turning the order of what is blended round is caught") {
  Material glass;
  glass.alpha_mode = AlphaMode::kBlend;
  glass.base_color = {1, 0, 0, 0.5f};
  const View view = planned_view();
  Scene scene = ball_at({0, 0, -4}, glass);
  glass.base_color = {0, 0, 1, 0.5f};
  scene.materials.push_back(glass);
  scene.meshes.push_back(scene.meshes.front());
  scene.meshes.back().material = std::uint32_t(scene.materials.size() - 1);
  scene.instances.push_back(scene.instances.front());
  scene.instances.back().mesh = std::uint32_t(scene.meshes.size() - 1);
  check_planned(scene, view);
  CHECK(differs_with_planner(scene, view, {},
                             plans_with<[](Plan& plan) { std::ranges::reverse(plan.order); }>));
}

TEST_CASE("with the plan off every built-in scene has the same bytes, whatever is asked for") {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    INFO(builtin.name);
    const Scene scene = test::built_in(std::string(builtin.name));
    const View view = small_view_of(scene);
    RenderSettings all;
    all.want_depth = all.want_distance = all.want_id = true;
    check_same(scene, view, all, without_plan());
    for (const Show show : {Show::kDepth, Show::kNormal, Show::kUv, Show::kId, Show::kOverdraw}) {
      RenderSettings settings;
      settings.show = show;
      check_same(scene, view, settings, without_plan());
    }
    RenderSettings red;
    red.mask = {true, false, false, false};
    check_same(scene, view, red, without_plan());
    check_same(scene, view, depth_only(), without_plan());
  }
}

}  // namespace
}  // namespace glassbox
