// Measures what is saved by leaving out work that a scene does not need, one decision of the plan
// at a time (D-28).
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/render/renderer.h>

#include "study/experiment/experiment.h"
#include "study/experiments/d28_plans.h"
#include "study/scenes/real_scenes.h"
#include "study/scenes/scenes.h"

namespace glassbox::study {

namespace d28 {

// ---- scenes ----

struct PlannedScene {
  std::string name;
  Scene scene;
  View view;
  RenderSettings settings;
  PreparedScene prepared = {};
  std::optional<Rendering> staged = {};

  // Drawn on the first request.
  const Framebuffer& reference() {
    if (!staged) staged = render_staged(scene, view, settings);
    return staged->buffers;
  }
};

constexpr int kWidth = 320, kHeight = 240;

std::shared_ptr<PlannedScene> make_planned_scene(std::string name, Scene scene, const View& view,
                                                 const RenderSettings& settings) {
  auto made = std::make_shared<PlannedScene>(
      PlannedScene{std::move(name), std::move(scene), view, settings});
  made->prepared = prepare_scene(made->scene, settings.transfer);
  return made;
}

View first_view(const Scene& scene) {
  const Camera camera = scene.cameras.empty()
                            ? framing_camera(scene, double(kWidth) / kHeight).value()
                            : scene.cameras.front();
  return make_view(camera, kWidth, kHeight).value();
}

std::shared_ptr<PlannedScene> builtin(const std::string& name, const char* scene_name,
                                      const RenderSettings& settings) {
  Scene scene = make_builtin(name).value();
  const View view = first_view(scene);
  return make_planned_scene(scene_name, std::move(scene), view, settings);
}

// The camera is turned by a right angle, so most trees are outside the picture.
std::shared_ptr<PlannedScene> forest_aside() {
  Scene scene = make_builtin("forest").value();
  Camera camera = scene.cameras.front();
  const SinCos turn = sin_cos_degrees(60);
  Transform<Eye, Eye> yaw;
  yaw.at(0, 0) = turn.cos, yaw.at(0, 2) = turn.sin;
  yaw.at(2, 0) = -turn.sin, yaw.at(2, 2) = turn.cos;
  camera.world_from_eye = camera.world_from_eye * yaw;
  const View view = make_view(camera, kWidth, kHeight).value();
  return make_planned_scene("forest, looked past", std::move(scene), view, {});
}

// The near plane cuts the teapot in the middle.
std::shared_ptr<PlannedScene> cut_teapot() {
  Scene scene = make_builtin("teapot").value();
  Camera camera = framing_camera(scene, double(kWidth) / kHeight).value();
  auto& lens = std::get<PerspectiveLens>(camera.lens);
  lens.near = (lens.near + *lens.far) / 2;
  const View view = make_view(camera, kWidth, kHeight).value();
  return make_planned_scene("teapot, cut by the near plane", std::move(scene), view, {});
}

// A smaller version of the benchmark scene R11: a hundred spheres, none of which is visible.
std::shared_ptr<PlannedScene> behind_a_wall() {
  BenchScene bench = make_real_scene("R11", kWidth, kHeight).value();
  return make_planned_scene("100 spheres behind a wall", std::move(bench.scene),
                            bench.passes.front().view, {});
}

// A smaller version of the benchmark scene R10: cubes beside and behind each other.
std::shared_ptr<PlannedScene> many_cubes(int cubes) {
  BenchScene bench = make_real_scene("R10", kWidth, kHeight).value();
  bench.scene.instances.resize(std::size_t(cubes));
  return make_planned_scene(std::to_string(cubes) + " cubes", std::move(bench.scene),
                            bench.passes.front().view, {});
}

// 64 parallel quads with one colour each, from back to front; each is an object of its own.
std::shared_ptr<PlannedScene> parallel_quads() {
  BenchScene bench = make_bench_scene("S4bf", kWidth, kHeight).value();
  const Mesh quads = bench.scene.meshes.front();
  Scene scene = bench.scene;
  scene.meshes.clear();
  scene.instances.clear();
  for (std::size_t i = 0; i < quads.faces.size(); i += 2) {
    Mesh one = quads;
    one.faces = {quads.faces[i], quads.faces[i + 1]};
    one.corners.clear();
    one.positions.clear();
    one.colors.clear();
    for (Face& face : one.faces) {
      const auto first = std::uint32_t(one.corners.size());
      for (std::uint32_t k = 0; k < face.count; ++k) {
        const Corner& corner = quads.corners[face.first + k];
        const auto index = std::uint32_t(one.positions.size());
        one.positions.push_back(quads.positions[corner.position]);
        one.colors.push_back(quads.colors[corner.color]);
        one.corners.push_back({index, kNone, kNone, index});
      }
      face.first = first;
    }
    scene.instances.push_back({std::uint32_t(scene.meshes.size()), 0});
    scene.meshes.push_back(std::move(one));
  }
  return make_planned_scene("64 parallel quads, back to front", std::move(scene),
                            bench.passes.front().view, {});
}

RenderSettings depth_only() {
  RenderSettings settings;
  settings.mask = {false, false, false, false};
  settings.want_depth = true;
  return settings;
}
RenderSettings red_only() {
  RenderSettings settings;
  settings.mask = {true, false, false, false};
  return settings;
}

// ---- measuring ----

void draw(const PlannedScene& planned, TileEngine& engine, Rendering& into) {
  engine.render(planned.scene, planned.prepared, planned.view, planned.settings, into);
}

double differing_pixels(const Framebuffer& one, const Framebuffer& other, bool depth) {
  double count = 0;
  for (std::size_t i = 0; i < one.color.pixels.size(); ++i)
    count += one.color.pixels[i] != other.color.pixels[i] ||
             (depth && one.depth.pixels[i] != other.depth.pixels[i]);
  return count;
}

Configuration configuration(const std::string& series, bool on, Planner planner,
                            const std::shared_ptr<PlannedScene>& planned) {
  const auto engine = [planner](int threads) {
    TileOptions options;
    options.threads = threads;
    options.planner = planner;
    return std::make_shared<TileEngine>(options);
  };
  const auto engines = std::make_shared<std::pair<int, std::shared_ptr<TileEngine>>>(0, nullptr);
  const auto picture = std::make_shared<Rendering>();
  return {.series = series,
          .parameter = on ? 1.0 : 0.0,
          .scene = planned->name,
          .error =
              [=] {
                Rendering drawn;
                draw(*planned, *engine(1), drawn);
                return differing_pixels(drawn.buffers, planned->reference(),
                                        planned->settings.want_depth);
              },
          .predicted_error = 0,
          .work =
              [=](int threads) {
                if (engines->first != threads) *engines = {threads, engine(threads)};
                draw(*planned, *engines->second, *picture);
              }};
}

struct OneDecision {
  const char* series;
  Planner planner;
  // first the scenes where the decision helps, then those where it does not
  std::vector<std::shared_ptr<PlannedScene>> scenes;
};

std::vector<OneDecision> decisions_on_scenes(Effort effort) {
  // The teapot has so many triangles that they are small: the stages of the staged engine would set
  // up large triangles with every plan.
  const char* teapot_name = effort == Effort::kQuick ? "teapot" : "teapot:24";
  const auto teapot = builtin(teapot_name, "teapot", {});
  const auto depth = builtin(teapot_name, "teapot, depth only", depth_only());
  const auto red = builtin(teapot_name, "teapot, red only", red_only());
  const auto forest = builtin("forest", "forest", {});
  const auto aside = forest_aside();
  const auto room = builtin("room", "room", {});
  const auto quads = parallel_quads();
  const auto cubes = many_cubes(effort == Effort::kQuick ? 2000 : 20000);
  return {{"objects outside the picture", plan_only<take_outside>, {aside, teapot}},
          {"hidden objects", plan_only<take_hidden>, {behind_a_wall(), teapot}},
          {"clusters out of sight", plan_only<take_clusters>, {teapot, quads}},
          {"draws by themselves", plan_only<take_runs>, {cubes, teapot}},
          {"plane tests", plan_only<take_plane_tests>, {teapot, cut_teapot()}},
          {"divide by w", plan_only<take_divide>, {quads, teapot}},
          {"normals", plan_only<take_normals>, {quads, teapot}},
          {"highlights", plan_only<take_highlights>, {forest, room}},
          {"front to back", plan_only<take_order>, {quads, teapot}},
          {"colours", plan_only<take_colors>, {depth, teapot}},
          {"channels", plan_only<take_channels>, {red, teapot}},
          {"read back", plan_only<take_read_back>, {teapot, red}},
          {"depth plane", plan_only<take_depth>, {teapot, depth}},
          {"all of them", make_plans, {teapot, depth, red, aside, forest, room, quads, cubes}}};
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  for (const OneDecision& one : decisions_on_scenes(effort)) {
    for (const auto& scene : one.scenes) {
      const bool whole_plan = one.planner == make_plans;
      const Planner off = whole_plan ? plan_nothing : plan_only<take_none>;
      all.push_back(configuration(one.series, false, off, scene));
      all.push_back(configuration(one.series, true, one.planner, scene));
    }
  }
  return all;
}

}  // namespace d28

Experiment d28_elision() {
  using namespace d28;
  return {
      .id = "D-28",
      .name = "Stage elision: leaving out the work that a scene does not need",
      .question =
          "How much time does each decision of the plan save in a scene where it applies, and how "
          "much does it cost in one where it does not?",
      .axis = "1: the plan leaves out what it can prove to be unneeded; 0: everything runs",
      .logarithmic_axis = false,
      .error = "pixels whose colour (or depth, if it is wanted) differs",
      .error_unit = "pixels",
      .reference = "the staged reference",
      .theory =
          "The plan leaves something out only if it is proved that no byte changes, so the number "
          "is 0.",
      .item = "picture",
      .threaded = true,
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
