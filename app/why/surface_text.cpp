// What is wrong with the sides of surfaces: normals, windings and mirrors, in words.
#include <algorithm>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "app/why/verdict_text.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/mesh/normal_check.h>
#include <glassbox/mesh/orientation.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox {

namespace {

// The instances of one mesh.
struct Uses {
  std::uint32_t count = 0, first = 0;  // first: an index into Scene::instances
  std::uint32_t mirrored = 0, first_mirrored = 0;
};

// Whether the eye is inside the surface, which shows its fronts there, as a room does.
bool is_around(const Scene& scene, const Instance& instance, const Point<World, double>& eye) {
  const auto object_from_world = inverse_affine(scene.nodes[instance.node].world_from_node);
  if (!object_from_world) return false;
  constexpr double kHalf = 0.5;
  return winding_number(scene.meshes[instance.mesh], *object_from_world * eye) < -kHalf;
}

// By mesh.
std::vector<Uses> uses_of_meshes(const Scene& scene) {
  std::vector<Uses> all(scene.meshes.size());
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    Uses& uses = all[scene.instances[i].mesh];
    if (uses.count++ == 0) uses.first = i;
    const glm::dmat3 m(scene.nodes[scene.instances[i].node].world_from_node.columns);
    if (glm::determinant(m) < 0 && uses.mirrored++ == 0) uses.first_mirrored = i;
  }
  return all;
}

void add_normals(const std::string& mesh, const NormalReport& report,
                 std::vector<std::string>& found) {
  if (report.inverted()) {
    found.push_back(fmt::format(
        "{}: its normals point to the backs of its faces at {} of {}: negate them, or reverse the "
        "winding of the faces",
        mesh, report.against_faces, counted(report.corners, "corner")));
  } else if (report.scaled_by) {
    const glm::dvec3& s = *report.scaled_by;
    found.push_back(fmt::format(
        "{}: its normals are {:.3g} degrees off those of the faces on average, as after a scale of "
        "({:.3g}, {:.3g}, {:.3g}) by which they were multiplied as well: transform normals by the "
        "inverse transpose of the matrix (C-16)",
        mesh, report.degrees_off, s.x, s.y, s.z));
  }
}

void add_winding(const Scene& scene, const std::string& mesh, const Uses& uses, double volume,
                 bool normals_point_outwards, std::vector<std::string>& found) {
  const std::string inside_out =
      fmt::format("{}: it is closed, and its fronts are inside (its signed volume is {:.4g}{})",
                  mesh, volume, normals_point_outwards ? ", but its normals point outwards" : "");
  if (uses.mirrored == 0) {
    found.push_back(inside_out +
                    ": reverse the winding of its faces, unless it is a room that is seen from "
                    "inside");
    return;
  }
  const Node& node = scene.nodes[scene.instances[uses.first_mirrored].node];
  found.push_back(fmt::format(
      "{}, and node {} mirrors it: the winding was turned round in the mesh, and the renderer "
      "turns that of a mirrored node round again, as glTF says (C-17)",
      inside_out, in_quotes(node.name)));
}

void add_mirror(const Scene& scene, const std::string& mesh, const Uses& uses,
                std::vector<std::string>& found) {
  const Node& node = scene.nodes[scene.instances[uses.first_mirrored].node];
  found.push_back(fmt::format(
      "{}: {} it (determinant {:.4g}), so that its faces run clockwise in the world: their winding "
      "is turned round here, as glTF says; a renderer that does not do so culls the fronts (C-17)",
      mesh,
      uses.mirrored == 1 ? "node " + in_quotes(node.name) + " mirrors"
                         : counted(uses.mirrored, "node") + " mirror",
      glm::determinant(glm::dmat3(node.world_from_node.columns))));
}

}  // namespace

std::vector<std::string> surface_findings(const Scene& scene,
                                          const std::optional<Point<World, double>>& eye) {
  std::vector<std::string> found;
  const std::vector<Uses> all = uses_of_meshes(scene);
  for (std::uint32_t i = 0; i < scene.meshes.size(); ++i) {
    const Uses& uses = all[i];
    if (uses.count == 0 || scene.meshes[i].faces.empty()) continue;
    const std::string mesh = mesh_text(scene, uses.first);
    const NormalReport normals = normal_report(scene.meshes[i]);
    const double volume = signed_volume(scene.meshes[i]).value_or(0);
    const bool is_room = eye && is_around(scene, scene.instances[uses.first], *eye);
    const bool inside_out = volume < 0 && !is_room;
    if (!inside_out || !normals.inverted()) add_normals(mesh, normals, found);
    if (inside_out) {
      add_winding(scene, mesh, uses, volume, normals.inverted(), found);
    } else if (uses.mirrored > 0) {
      add_mirror(scene, mesh, uses, found);
    }
  }
  return found;
}

}  // namespace glassbox
