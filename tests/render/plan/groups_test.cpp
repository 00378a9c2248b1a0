// Scenes of many instances: groups of them are planned together, and runs of one mesh are drawn
// together.
#include <cmath>
#include <utility>

#include <glassbox/base/rounding.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/render/plan/group_classifier.h>
#include <glassbox/render/staged/vertex_stage.h>

#include "tests/render/plan/plan_checks.h"

namespace glassbox {
namespace {

using namespace test;

// Small objects around the view; some are mirrored, squeezed, or modelled far from their origin.
Scene many_objects(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Scene scene = scene_of(star_shaped_surface(2, 0.2, random));
  Mesh far_away = star_shaped_surface(2, 0.2, random);
  for (auto& p : far_away.positions) p.x += 1000;
  far_away.normals.clear();
  for (Corner& corner : far_away.corners) corner.normal = kNone;
  scene.meshes.push_back(std::move(far_away));
  scene.instances.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t mesh = random.integer(0, 7) == 0 ? 1 : 0;
    const double size = random.between(0.02, 0.15);
    const double mirror = random.integer(0, 5) == 0 ? -1 : 1;
    const auto placed = translate<World, World>({random.between(-6, 6), random.between(-4, 4),
                                                 random.between(-21, 1)}) *
                        scale<World, World>(size * mirror, size, size) *
                        translate<World, Object>({mesh == 1 ? -1000.0 : 0.0, 0, 0});
    scene.nodes.push_back(Node{"placed", kNone, placed, placed});
    scene.instances.push_back({mesh, std::uint32_t(scene.nodes.size() - 1)});
  }
  return scene;
}

std::vector<View> views() {
  std::vector<View> all;
  for (const DepthRange range : {DepthRange::kStandard, DepthRange::kReversed}) {
    all.push_back(planned_view(PerspectiveLens{kDegrees45, 0.5, 20.0}, 96, 64, range));
    all.push_back(planned_view(OrthographicLens{2, 0.5, 20}, 96, 64, range));
  }
  return all;
}

// How many computed vertices are not where the plan says that their group is.
struct Misplaced {
  std::size_t left_out = 0, accepted = 0, opened = 0;  // groups
  std::size_t vertices = 0;
};
Misplaced count_misplaced(const Scene& scene, const View& view, double shrink = 1) {
  const PlannedScene planned = plan_of(scene, view);
  const GroupClassifier classifier(view);
  const auto planes = render_planes(view);
  const auto edges = picture_edges(view.viewport, kOutsideMarginPx);
  Misplaced found;
  REQUIRE(planned.prepared.groups != nullptr);
  std::vector<InstanceGroup> groups = planned.prepared.groups->groups;
  for (InstanceGroup& group : groups) {
    const Point<World, double> c = group.box.center();
    const auto nearer = [&](double to, double from) { return from + (to - from) * shrink; };
    for (Point<World, double>* end : {&group.box.low, &group.box.high}) {
      *end = {nearer(end->x, c.x), nearer(end->y, c.y), nearer(end->z, c.z)};
    }
  }
  for (const InstanceGroup& group : groups) {
    const auto classification = classifier.classify(group);
    ++(!classification                         ? found.opened
       : classification->outside_of != nullptr ? found.left_out
                                               : found.accepted);
  }
  for (const Draw& draw : planned.list.draws) {
    const InstanceGroup& group = groups[planned.prepared.groups->of_instance[draw.instance]];
    const auto classification = classifier.classify(group);
    if (!classification) continue;
    const DepthCodes codes = classifier.codes(group, DepthFormat::kFloat32);
    for (const Point<Clip>& p : project_vertices(draw, view).positions) {
      if (classification->outside_of != nullptr) {
        const auto beyond = [&](const ClipPlane& plane) {
          return std::string(plane.name) == classification->outside_of &&
                 signed_distance(plane, p) < 0;
        };
        found.vertices +=
            std::ranges::none_of(planes, beyond) && std::ranges::none_of(edges, beyond);
        continue;
      }
      const std::uint32_t code = depth_code(DepthFormat::kFloat32, p.z / p.w);
      const bool within = outcode(p, planes) == 0 && outcode(p, edges) == 0;
      found.vertices += !within || code < codes.nearest || code > codes.farthest;
    }
  }
  return found;
}

TEST_CASE("what is said of a group holds for every vertex of its instances, as it is computed") {
  for (const View& view : views()) {
    const Misplaced found = count_misplaced(many_objects(30000, 3), view);
    CHECK(found.vertices == 0);
    CHECK(found.left_out > 5);
    CHECK(found.accepted > 0);
    CHECK(found.opened > 5);
  }
}

TEST_CASE("boxes of groups that are a tenth too small are found out") {
  CHECK(count_misplaced(many_objects(30000, 3), views().front(), 0.9).vertices > 0);
}

TEST_CASE("scenes of many instances have the same bytes with groups and runs, and without") {
  const Scene scene = many_objects(1500, 4);
  for (const View& view : views()) {
    for (const Shading shading : {Shading::kPhong, Shading::kGouraud, Shading::kFlat}) {
      RenderSettings settings;
      settings.shading = shading;
      settings.want_depth = true;
      const Statistics counts = check_planned(scene, view, settings);
      CHECK(counts.left_out > 0);
      settings.want_id = true;
      check_same(scene, view, settings);
    }
  }
}

TEST_CASE("a coordinate that may overflow, or is not finite, opens a group") {
  Scene scene = many_objects(1500, 5);
  for (Node& node : scene.nodes) {
    node.world_from_node = scale<World, World>(1e38, 1e38, 1e38) * node.world_from_node;
  }
  const GroupClassifier classifier(planned_view());
  const PreparedScene prepared = prepare_scene(scene, Transfer::kSrgb);
  for (const InstanceGroup& group : prepared.groups->groups) CHECK(!classifier.classify(group));
}

// ---- the rounding slack ----

// A pane 2e5 wide whose plane is a million units from the origin of its mesh. The mesh gets no
// anchor, since it is not farther away than eight times its size. Its depth is a difference of
// numbers near 1/2, with an error of up to 2^-25.
Mesh far_pane(float z) {
  Mesh mesh;
  for (const auto& [x, y] : {std::pair{-1e5f, -1e5f}, {1e5f, -1e5f}, {1e5f, 1e5f}, {-1e5f, 1e5f}}) {
    mesh.positions.push_back({x, y, z});
  }
  add_face(mesh, {0, 1, 2, 3});
  return mesh;
}

// Adds a pane of one colour, about 0.5 + `behind_near` from the eye.
void add_pane(Scene& scene, float z, double scale_z, double behind_near,
              std::array<float, 3> color) {
  Material material;
  material.unlit = true;
  material.base_color = {color[0], color[1], color[2], 1};
  add_object(scene, far_pane(z), material);
  Node& node = scene.nodes.back();
  node.world_from_node = translate<World, World>({0, 0, -0.5 - behind_near - 1e6 * 1e-5}) *
                         scale<World, Object>(1, 1, scale_z);
}

// The depth of a pane: exact for the matrix of its draw, and as computed.
struct PaneDepth {
  double exact = 0;
  float computed = 0;
};
PaneDepth depth_of_pane(const Draw& draw, const View& view) {
  REQUIRE(draw.anchor.z == 0);
  const auto& m = draw.clip_from_anchored;
  return {double(m.at(2, 2)) * double(draw.mesh->positions[0].z) + double(m.at(2, 3)),
          project_vertices(draw, view).positions[0].z};
}

View parallel_view() {
  return planned_view(OrthographicLens{2, 0.5, 20}, 48, 32);
}

TEST_CASE("a draw before the near plane by less than its vertices are rounded is drawn") {
  const View view = parallel_view();
  int before_and_drawn = 0;
  for (int i = 0; i < 200; ++i) {
    Scene scene;
    const float z = 1e6f + float(i) * 0.0625f;
    add_pane(scene, z, 1e-5 * (1 + i * 1e-7), (double(z) * (1 + i * 1e-7) - 1e6) * 1e-5, {1, 0, 0});
    const PaneDepth depth = depth_of_pane(plan_of(scene, view).list.draws[0], view);
    if (depth.exact >= 0 || depth.computed < 0) continue;
    ++before_and_drawn;
    check_planned(scene, view);
    CHECK(plan_of(scene, view).plan.methods[0].drawn);
  }
  CHECK(before_and_drawn > 10);
}

TEST_CASE(
    "a draw nearer than one before it by less than its depths are rounded does not overtake") {
  const View view = parallel_view();
  int ties = 0;
  for (int i = 0; i + 1 < 200; ++i) {
    Scene scene;
    for (const int k : {i, i + 1}) {
      add_pane(scene, 1e6f + float(k) * 0.0625f, 1e-5,
               5e-4 + k * 0.0625 * 1e-5 + (k - i) * 2e-8 * -1, {k == i ? 1.0f : 0.0f, 0, 1});
    }
    const PlannedScene planned = plan_of(scene, view);
    const PaneDepth first = depth_of_pane(planned.list.draws[0], view);
    const PaneDepth second = depth_of_pane(planned.list.draws[1], view);
    // Nearer by more than the 32 roundings by which a depth code may be off in general.
    const bool nearer = second.exact < first.exact * (1 - 128 * unit_roundoff<float>);
    if (!nearer || first.computed != second.computed) continue;
    ++ties;
    CHECK(planned.plan.order == std::vector<std::uint32_t>{0, 1});
    check_planned(scene, view);
  }
  CHECK(ties > 5);
}

// ---- runs ----

// The report of a picture, which counts its draws and its runs.
TileReport report_of(const Scene& scene, const View& view, const RenderSettings& settings) {
  TileReport report;
  Rendering drawn;
  const PreparedScene prepared = prepare_scene(scene, settings.transfer);
  TileEngine({.threads = 1}).render(scene, prepared, view, settings, drawn, &report);
  return report;
}

TEST_CASE("instances of one mesh that follow each other are one list of triangles") {
  Scene scene = ball_to_place();
  for (int i = 0; i < 10; ++i) add_instance_at(scene, 0, {i * 0.3 - 1.5, 0, -5.0}, 0.1);
  const View view = planned_view();
  const TileReport report = report_of(scene, view, {});
  CHECK(report.draws == 10);
  CHECK(report.runs == 1);
  CHECK(!decision(scene, view, "a draw by itself").needed);
  RenderSettings with_ids;
  with_ids.want_id = true;
  CHECK(report_of(scene, view, with_ids).runs == 10);
  CHECK(decision(scene, view, "a draw by itself", with_ids).needed);
}

TEST_CASE("runs of textured, coloured, masked, blended and cut meshes have the same bytes") {
  for (const char* name : {"forest", "room", "thicket", "checker"}) {
    Scene scene = *make_builtin(name);
    const auto once = scene.instances;
    // Each instance is there three times, moved a little, so that runs are long and some of their
    // large triangles are clipped.
    scene.instances.clear();
    for (const Instance& instance : once) {
      for (int i = 0; i < 3; ++i) {
        Node node = scene.nodes[instance.node];
        node.world_from_node =
            translate<World, World>({0.11 * i, 0.07 * i, 0.05 * i}) * node.world_from_node;
        scene.instances.push_back({instance.mesh, std::uint32_t(scene.nodes.size())});
        scene.nodes.push_back(node);
      }
    }
    const View view = *make_view(camera_for(scene, 1.5), 90, 60);
    CHECK(report_of(scene, view, {}).runs < report_of(scene, view, {}).draws);
    for (const AlphaMode mode : {AlphaMode::kOpaque, AlphaMode::kMask, AlphaMode::kBlend}) {
      for (Material& material : scene.materials) {
        material.alpha_mode = mode;
        if (mode == AlphaMode::kBlend) material.base_color.a = 0.5f;
      }
      for (const int samples : {1, 4}) {
        RenderSettings settings;
        settings.samples = samples;
        CAPTURE(name, int(mode), samples);
        check_same(scene, view, settings);
        check_same(scene, view, settings, {.threads = 2, .tile_side = 32, .round_size = 2000});
      }
    }
  }
}

}  // namespace
}  // namespace glassbox
