// The work per vertex that the plan leaves out.
#include "tests/render/plan/plan_checks.h"

namespace glassbox {
namespace {

using namespace test;

template <auto change>
std::vector<Plan> plans_with_methods(std::span<const PlannedEye> eyes, bool leave_out) {
  std::vector<Plan> plans = make_plans(eyes, leave_out);
  for (Plan& plan : plans) {
    for (DrawMethod& method : plan.methods) change(method);
  }
  return plans;
}

Material shiny() {
  Material material;
  material.specular = {0.5f, 0.5f, 0.5f};
  return material;
}

Scene lit_by(const Light& light, Material material = {}) {
  Scene scene = ball_at({0, 0, -4}, std::move(material));
  scene.lights = {light};
  return scene;
}

Light point_light() {
  Light light;
  light.kind = LightKind::kPoint;
  light.intensity = 60;
  light.position = {2, 2, 0};
  return light;
}
Light sun() {
  Light light;
  light.intensity = 3;
  light.direction = {0, 0, -1};
  return light;
}

TEST_CASE("no vertex of a draw within all planes is tested against them") {
  const View view = planned_view();
  const Scene inside = ball_at({0, 0, -5});
  CHECK(check_planned(inside, view).plane_tests == 0);
  CHECK_FALSE(decision(inside, view, "clip test of vertices").needed);
  const std::uint64_t positions = inside.meshes[0].positions.size();
  CHECK(counts_without_plan(inside, view).plane_tests == positions);
}

TEST_CASE("vertices of a draw that reaches a plane are tested, and leaving that out is caught") {
  // A ball through the near plane, then one through the far plane. Their triangles are small, since
  // large ones are always tested by the staged primitives.
  for (const auto& [z, size] : {std::pair{-0.58, 0.1}, std::pair{-21.15, 1.0}}) {
    INFO("at z = " << z);
    Scene scene = ball_to_place();
    add_instance_at(scene, 0, {0, 0, z}, size);
    CHECK(check_planned(scene, planned_view()).plane_tests == scene.meshes[0].positions.size());
    CHECK(differs_with_planner(scene, planned_view(), {},
                               plans_with_methods<[](DrawMethod& m) { m.test_planes = false; }>));
  }
  // A ball that reaches beyond the guard band.
  Scene giant = ball_to_place();
  add_instance_at(giant, 0, {0, 0, -30000}, 29995);
  const View deep = planned_view(PerspectiveLens{kDegrees45, 0.001, std::nullopt});
  CHECK(check_planned(giant, deep).plane_tests > 0);
  CHECK(decision(giant, deep, "clipping in x and y").needed);
}

TEST_CASE("nothing is divided by w in a parallel view, where w is 1") {
  const View parallel = planned_view(OrthographicLens{2, 0.5, 20});
  const Scene scene = ball_at({0.3, 0, -5});
  check_planned(scene, parallel);
  CHECK_FALSE(plan_of(scene, parallel).plan.methods[0].divide);
  check_planned(ball_at({0.3, 0, -0.9}), parallel);  // with the plane tests
  CHECK(plan_of(scene, planned_view()).plan.methods[0].divide);
  CHECK(differs_with_planner(scene, planned_view(), {},
                             plans_with_methods<[](DrawMethod& m) { m.divide = false; }>));
}

TEST_CASE("normals are carried to eye space where light asks for them, and nowhere else") {
  Material unlit;
  unlit.unlit = true;
  const View view = planned_view();
  const Scene scene = ball_at({0, 0, -4}, unlit);
  CHECK(check_planned(scene, view).normals == 0);
  CHECK(counts_without_plan(scene, view).normals > 0);
  RenderSettings settings;
  settings.shading = Shading::kUnlit;
  CHECK(check_planned(ball_at({0, 0, -4}), view, settings).normals == 0);

  const Scene lit = ball_at({0, 0, -4});
  CHECK(check_planned(lit, view).normals == lit.meshes[0].faces.size());
  CHECK(differs_with_planner(
      lit, view, {}, plans_with_methods<[](DrawMethod& m) { m.light = LightAt::kNowhere; }>));
}

TEST_CASE("positions are carried to eye space where light depends on them, and nowhere else") {
  const View view = planned_view();
  CHECK(check_planned(lit_by(sun()), view).eye_positions == 0);
  CHECK(counts_without_plan(lit_by(sun()), view).eye_positions > 0);
  CHECK(check_planned(lit_by(sun(), shiny()), view).eye_positions > 0);
  const Scene near = lit_by(point_light());
  CHECK(check_planned(near, view).eye_positions == near.meshes[0].positions.size());
  CHECK(differs_with_planner(near, view, {},
                             plans_with_methods<[](DrawMethod& m) { m.eye_positions = false; }>));
}

TEST_CASE("each position is carried over once, however many corners name it") {
  const Scene scene = ball_at({0, 0, -4});
  const Mesh& mesh = scene.meshes[0];
  CHECK(check_planned(scene, planned_view()).vertices == mesh.positions.size());
  CHECK(mesh.corners.size() > 3 * mesh.positions.size());
  CHECK_FALSE(decision(scene, planned_view(), "repeated vertices").needed);

  Mesh apart;  // every corner has its own position
  for (const Face& face : mesh.faces) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      apart.positions.push_back(mesh.positions[mesh.corners[face.first + k].position]);
    }
    const auto n = std::uint32_t(apart.positions.size());
    add_face(apart, {n - 3, n - 2, n - 1});
  }
  CHECK(decision(scene_of(apart), planned_view(PerspectiveLens{kDegrees45, 0.01, 20.0}),
                 "repeated vertices")
            .needed);
}

}  // namespace
}  // namespace glassbox
