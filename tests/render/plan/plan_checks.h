// Scenes, and pictures of them with the plan, without a plan, and with a wrong plan.
#pragma once

#include <glassbox/render/plan/decisions.h>

#include "tests/render/tile/same_picture.h"

namespace glassbox::test {

inline constexpr double kDegrees45 = 0.785398163397448309616;

// A view from the origin along -z.
inline View planned_view(const Lens& lens = PerspectiveLens{kDegrees45, 0.5, 20.0}, int width = 96,
                         int height = 64, DepthRange range = DepthRange::kStandard) {
  const auto view = make_view(Camera{"test", lens, {}}, width, height, range);
  REQUIRE(view);
  return *view;
}

inline void add_instance_at(Scene& scene, std::uint32_t mesh, const Vector<World, double>& at,
                            double size = 1) {
  const auto placed = translate<World, World>(at) * scale<World, Object>(size, size, size);
  scene.nodes.push_back(Node{"placed", kNone, placed, placed});
  scene.instances.push_back({mesh, std::uint32_t(scene.nodes.size() - 1)});
}

// Adds one instance of the mesh, not moved, with its own material.
inline void add_object(Scene& scene, Mesh mesh, Material material) {
  mesh.material = std::uint32_t(scene.materials.size());
  scene.materials.push_back(std::move(material));
  scene.nodes.push_back({"object", kNone, {}, {}});
  scene.instances.push_back(
      {std::uint32_t(scene.meshes.size()), std::uint32_t(scene.nodes.size() - 1)});
  scene.meshes.push_back(std::move(mesh));
}

// A rough ball of radius 1 to 1.2 without instances; add_instance_at() adds them.
inline Scene ball_to_place(Material material = {}, std::uint64_t seed = 1) {
  Random random(seed);
  Scene scene = scene_of(star_shaped_surface(4, 0.2, random), std::move(material));
  scene.instances.clear();
  return scene;
}

inline Scene ball_at(const Vector<World, double>& at, Material material = {}) {
  Scene scene = ball_to_place(std::move(material));
  add_instance_at(scene, 0, at);
  return scene;
}

struct PlannedScene {
  PreparedScene prepared;
  DrawList list;
  Plan plan;
};

inline PlannedScene plan_of(const Scene& scene, const View& view,
                            const RenderSettings& settings = {}, bool leave_out = true) {
  PlannedScene planned{prepare_scene(scene, settings.transfer), {}, {}};
  planned.list = make_draw_list(scene, planned.prepared, view);
  const PlannedEye eye{planned.list, view, settings};
  planned.plan = make_plans({&eye, 1}, leave_out).front();
  return planned;
}

inline TileOptions without_plan() {
  TileOptions options;
  options.plan = false;
  return options;
}

// Checks that the bytes are the same with the plan and without. Returns the counts of the tile
// engine with the plan.
inline Statistics check_planned(const Scene& scene, const View& view,
                                const RenderSettings& settings = {}) {
  check_same(scene, view, settings);
  check_same(scene, view, settings, without_plan());
  return render_tiled(scene, view, settings).statistics;
}

inline Statistics counts_without_plan(const Scene& scene, const View& view,
                                      const RenderSettings& settings = {}) {
  return render_tiled(scene, view, settings, without_plan()).statistics;
}

// Whether a picture drawn with the given (wrong) planner differs from the staged one.
inline bool differs_with_planner(const Scene& scene, const View& view,
                                 const RenderSettings& settings, Planner planner) {
  TileOptions options;
  options.planner = planner;
  const Rendering staged = render_staged(scene, view, settings);
  const Rendering tiled = render_tiled(scene, view, settings, options);
  return planes_differ(staged.buffers, tiled.buffers, settings.want_depth) != "";
}

// The plan's decision about a stage of the first draw.
inline Decision decision(const Scene& scene, const View& view, const std::string& stage,
                         const RenderSettings& settings = {}) {
  const PlannedScene planned = plan_of(scene, view, settings);
  const PlannedEye eye{planned.list, view, settings};
  for (const Decision& d : decisions(planned.plan, eye, 0)) {
    if (d.stage == stage) return d;
  }
  FAIL("there is no decision about " << stage);
  return {};
}

}  // namespace glassbox::test
