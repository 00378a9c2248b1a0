#include "inspect/manifest.h"

#include <algorithm>
#include <span>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/report/number_json.h"
#include "cli/report/stage_report.h"

#include <glassbox/base/trig.h>
#include <glassbox/render/engine/setting_names.h>
#include <glassbox/render/trace/bounds.h>

namespace glassbox::inspect {
namespace {

using Json = nlohmann::ordered_json;

// The sixteen numbers of a matrix, row by row. Floats are written as doubles, so that every reader
// gets exactly the same values.
template <class Target, class Source, class T>
Json rows(const Transform<Target, Source, T>& m) {
  Json json = Json::array();
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) json.push_back(double(m.at(row, column)));
  }
  return json;
}

Json lens_json(const Lens& lens) {
  if (const auto* l = std::get_if<PerspectiveLens>(&lens)) {
    return {{"kind", "perspective"},
            {"fovy_degrees", degrees_from_radians(l->fovy_radians)},
            {"near", l->near},
            {"far", l->far ? Json(*l->far) : Json("inf")}};
  }
  if (const auto* l = std::get_if<OrthographicLens>(&lens)) {
    return {{"kind", "parallel"},
            {"half_height", l->half_height},
            {"near", l->near},
            {"far", finite_or_inf(l->far)}};
  }
  const auto& l = std::get<FrustumLens>(lens);
  return {{"kind", "frustum"},
          {"left", l.left},
          {"right", l.right},
          {"bottom", l.bottom},
          {"top", l.top},
          {"near", l.near},
          {"far", l.far ? Json(*l.far) : Json("inf")}};
}

Json camera_json(const Camera& camera) {
  const auto& m = camera.world_from_eye;
  const auto column = [&](int k, double sign) {
    return Json{sign * m.at(0, k) + 0.0, sign * m.at(1, k) + 0.0, sign * m.at(2, k) + 0.0};
  };
  return {{"name", camera.name},      {"eye", column(3, 1)},   {"gaze", column(2, -1)},
          {"up", column(1, 1)},       {"right", column(0, 1)}, {"lens", lens_json(camera.lens)},
          {"world_from_eye", rows(m)}};
}

Json view_json(const View& view) {
  return {{"eye_from_world", rows(view.eye_from_world)},
          {"clip_from_eye", rows(view.clip_from_eye)},
          {"viewport",
           {view.viewport.left, view.viewport.top, view.viewport.right, view.viewport.bottom}},
          {"reversed", view.depth_range == DepthRange::kReversed},
          {"perspective", view.perspective},
          {"near", view.near},
          {"far", finite_or_inf(view.far)}};
}

// The nodes from the root to the node itself. The product of their matrices is world_from_node.
Json nodes_json(const Scene& scene, std::uint32_t node) {
  std::vector<Json> path;
  for (std::uint32_t n = node; n != kNone; n = scene.nodes[n].parent) {
    path.push_back(
        {{"name", scene.nodes[n].name}, {"matrix", rows(scene.nodes[n].parent_from_node)}});
  }
  std::reverse(path.begin(), path.end());
  return path;
}

Json draws_json(const Scene& scene, const View& view, const ColumnRun& run) {
  Json json = Json::array();
  for (std::size_t d = 0; d < run.draws.size(); ++d) {
    const TracedDraw& draw = run.draws[d];
    const Instance& instance = scene.instances[draw.instance];
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Material& material = scene.materials[mesh.material];
    json.push_back(
        {{"instance", draw.instance},
         {"mesh", instance.mesh},
         {"material", material.name},
         {"double_sided", material.double_sided},
         {"first_number", draw.first_number},
         {"triangles", run.triangles_of_draw[d]},
         {"mirrored", draw.mirrored},
         {"anchor", numbers_json(draw.anchor)},
         {"world_from_object", rows(scene.nodes[instance.node].world_from_node)},
         {"nodes", nodes_json(scene, instance.node)},
         {"clip_from_anchored", rows(draw.clip_from_anchored)},
         {"clip_bound", rows(Transform<Clip, Object>(bounds_of(draw, view).clip_from_anchored))}});
  }
  return json;
}

Json planes_json(std::span<const ClipPlane> planes) {
  Json json = Json::array();
  for (const ClipPlane& p : planes) {
    json.push_back({{"name", p.name}, {"factors", {p.a, p.b, p.c, p.d, p.e}}});
  }
  return json;
}

}  // namespace

Json manifest_of(const Scene& scene, const Camera& camera, const View& view,
                 const RenderSettings& settings, const InspectOptions& options,
                 const ColumnRun& run) {
  Json json{{"format", "glassbox inspect"},
            {"version", 1},
            {"program", options.program},
            {"command", options.command},
            {"scene", options.scene_name},
            {"options", options.words},
            {"width", run.rendering.buffers.color.width},
            {"height", run.rendering.buffers.color.height},
            {"background", numbers_json(settings.background)},
            {"depth_format", name_of(settings.depth)},
            {"cull", name_of(settings.cull)},
            {"wireframe", settings.wireframe},
            {"camera", camera_json(camera)},
            {"view", view_json(view)},
            {"planes", planes_json(run.planes)},
            {"draws", draws_json(scene, view, run)},
            {"meshes", Json::array()},
            {"stages", to_json(run.rendering.statistics)}};
  if (options.pixel) json["pixel"] = {options.pixel->x, options.pixel->y};
  if (options.rectangle) json["rectangle"] = numbers_json(*options.rectangle);
  return json;
}

}  // namespace glassbox::inspect
