#include <glassbox/mesh/gltf/cameras_lights.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/gltf/text.h>

namespace glassbox::gltf {
namespace {

using Direction = Vector<World, double>;

// Lengths and angles that differ from exact ones only by the rounding of sums of three products are
// taken as exact, so that a rigid pose and a unit direction keep all their bits. 64 roundings of
// 2^-53 add up to 2^-47; the tolerance is twice that.
constexpr double kRigidTolerance = 0x1p-46;

Direction column(const Transform<World, Object>& m, int i) {
  return {m.at(0, i), m.at(1, i), m.at(2, i)};
}

// Divides v by its largest component first, so that no square overflows or vanishes.
std::optional<Direction> normalized(const Direction& v) {
  const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
  const Direction scaled{v.x / size, v.y / size, v.z / size};
  const double length = std::sqrt(dot(scaled, scaled));
  return Direction{scaled.x / length, scaled.y / length, scaled.z / length};
}

bool is_unit(const Direction& v) {
  return std::abs(dot(v, v) - 1) <= kRigidTolerance;
}

bool is_rigid(const Transform<World, Object>& m) {
  const Direction x = column(m, 0), y = column(m, 1), z = column(m, 2);
  return is_unit(x) && is_unit(y) && is_unit(z) && std::abs(dot(x, y)) <= kRigidTolerance &&
         std::abs(dot(y, z)) <= kRigidTolerance && std::abs(dot(z, x)) <= kRigidTolerance &&
         dot(cross(x, y), z) > 0;
}

// The matrices that nodes would have as cameras, by the index in Scene::nodes. A camera ignores the
// scale of its node and of those above (glTF 2.0, section 3.10.2). Positive scales do not turn the
// axes of the product of all matrices. If a scale is negative or zero, the axes are those of the
// same nodes without scale.
std::vector<Transform<World, Object>> camera_matrices(const Asset& asset, const NodeTree& tree,
                                                      const Scene& scene) {
  std::vector<Transform<World, Object>> unscaled(tree.drawn.size()), matrices;
  std::vector<bool> turned(tree.drawn.size(), false);
  for (std::size_t i = 0; i < tree.drawn.size(); ++i) {
    const tinygltf::Node& node = asset.model.nodes[tree.drawn[i]];
    const Transform<World, Object>& placed = tree.world_from_node[tree.drawn[i]];
    const std::uint32_t parent = scene.nodes[i].parent;
    unscaled[i] = without_scale(node);
    turned[i] = !std::ranges::all_of(node.scale, [](double s) { return s > 0; });
    if (parent != kNone) {
      unscaled[i] = compose(unscaled[parent], unscaled[i]);
      turned[i] = turned[i] || turned[parent];
    }
    matrices.push_back(turned[i] ? unscaled[i] : placed);
    for (int row = 0; row < 3; ++row) matrices[i].at(row, 3) = placed.at(row, 3);
  }
  return matrices;
}

// Makes the node's transform rigid: the direction of view (-z) is kept, and up becomes the part of
// the y axis that is perpendicular to it.
Result<Transform<World, Eye>> rigid_pose(const Transform<World, Object>& node, std::size_t index) {
  Transform<World, Eye> pose(node.columns);
  if (is_rigid(node)) return pose;
  const auto refuse = [&] {
    return fail(entry("node", index),
                "carries a camera but has no usable orientation: an axis has length zero, or up is "
                "along the gaze",
                "give the camera a node of its own, without scale");
  };
  const auto z = normalized(column(node, 2));
  const auto up = normalized(column(node, 1));
  if (!z || !up) return refuse();
  const auto x = normalized(cross(*up, *z));
  if (!x || dot(cross(*up, *z), cross(*up, *z)) < 0x1p-40) return refuse();
  const Direction y = cross(*z, *x);
  const Direction axes[3] = {*x, y, *z};
  for (int i = 0; i < 3; ++i) {
    pose.at(0, i) = axes[i].x;
    pose.at(1, i) = axes[i].y;
    pose.at(2, i) = axes[i].z;
  }
  return pose;
}

tl::unexpected<Error> refuse_camera(std::size_t index, std::string cause) {
  return fail(entry("camera", index), std::move(cause), "correct the camera in the file");
}

Result<Lens> perspective(const Asset& asset, std::size_t index) {
  const tinygltf::PerspectiveCamera& camera = asset.model.cameras[index].perspective;
  if (!(camera.yfov > 0 && camera.yfov < kPi)) {
    return refuse_camera(index, "its field of view of " + std::to_string(camera.yfov) +
                                    " radians is not between 0 and pi");
  }
  if (!(camera.znear > 0)) return refuse_camera(index, "its near plane is not in front of the eye");
  PerspectiveLens lens;
  lens.fovy_radians = camera.yfov;
  lens.near = camera.znear;
  if (asset.document["cameras"][index]["perspective"].contains("zfar")) {
    if (!(camera.zfar > camera.znear))
      return refuse_camera(index, "its far plane is not behind the near plane");
    lens.far = camera.zfar;
  }
  return lens;
}

// An orthographic lens from ymag, half the height of the view. xmag is half the width in world
// units; here the viewport's aspect ratio determines the width, as for perspective cameras, so xmag
// is only checked.
Result<Lens> orthographic(const Asset& asset, std::size_t index) {
  const tinygltf::OrthographicCamera& camera = asset.model.cameras[index].orthographic;
  if (camera.xmag == 0 || !(camera.ymag > 0))
    return refuse_camera(
        index, "its half width (xmag) is zero, or its half height (ymag) is not greater than zero");
  if (!(camera.znear >= 0 && camera.zfar > camera.znear)) {
    return refuse_camera(
        index, "its far plane is not behind the near plane, or the near plane is behind the eye");
  }
  return OrthographicLens{camera.ymag, camera.znear, camera.zfar};
}

std::string name_of(const std::string& own, const std::string& node, const char* kind,
                    std::size_t number) {
  if (!own.empty()) return printable(own);
  return node.empty() ? entry(kind, number) : printable(node);
}

// A camera that cannot be used is no reason to refuse the file, which may be drawn by another one.
void place_camera(Asset& asset, const Transform<World, Object>& matrix, std::uint32_t node,
                  Scene& scene) {
  const std::size_t index = std::size_t(asset.model.nodes[node].camera);
  const tinygltf::Camera& described = asset.model.cameras[index];
  const auto lens =
      described.type == "perspective" ? perspective(asset, index) : orthographic(asset, index);
  const auto pose = rigid_pose(matrix, node);
  Camera camera;
  camera.name =
      name_of(described.name, asset.model.nodes[node].name, "camera", scene.cameras.size());
  if (lens && pose) {
    camera.lens = *lens;
    camera.world_from_eye = *pose;
  } else {
    const Error& error = lens ? pose.error() : lens.error();
    camera.fault = error.place + ": " + error.cause;
    asset.warn("the camera " + in_quotes(camera.name) + " cannot be used: " + camera.fault);
  }
  scene.cameras.push_back(std::move(camera));
}

Result<void> place_light(const Asset& asset, const NodeTree& tree, std::uint32_t node,
                         std::size_t index, Scene& scene) {
  const tinygltf::Light& described = asset.model.lights[index];
  const nlohmann::json& document =
      asset.document["extensions"]["KHR_lights_punctual"]["lights"][index];
  Light light;
  light.name = name_of(described.name, asset.model.nodes[node].name, "light", scene.lights.size());
  light.kind = described.type == "point"  ? LightKind::kPoint
               : described.type == "spot" ? LightKind::kSpot
                                          : LightKind::kDirectional;
  for (std::size_t i = 0; i < described.color.size(); ++i)
    light.color[i] = float(described.color[i]);
  light.intensity = document.value("intensity", 1.0);
  if (document.contains("range")) light.range = document["range"].get<double>();
  if (light.kind == LightKind::kSpot) {
    const nlohmann::json& spot = document["spot"];
    light.inner_cone_radians = spot.value("innerConeAngle", light.inner_cone_radians);
    light.outer_cone_radians = spot.value("outerConeAngle", light.outer_cone_radians);
    if (!(light.inner_cone_radians < light.outer_cone_radians)) {
      return fail(entry("light", index), "its inner cone is not narrower than the outer one",
                  "correct the cone angles");
    }
  }
  const Transform<World, Object>& matrix = tree.world_from_node[node];
  light.position = {matrix.at(0, 3), matrix.at(1, 3), matrix.at(2, 3)};
  const Direction gaze = -column(matrix, 2);
  const auto direction = is_unit(gaze) ? gaze : normalized(gaze);
  if (!direction && light.kind != LightKind::kPoint) {
    return fail(entry("node", node),
                "carries a light that shines nowhere: its z axis has length zero",
                "give the light a node without scale");
  }
  if (direction) light.direction = *direction;
  scene.lights.push_back(std::move(light));
  return {};
}

}  // namespace

Result<void> place_cameras_and_lights(Asset& asset, const NodeTree& tree, Scene& scene) {
  const auto matrices = asset.model.cameras.empty() ? std::vector<Transform<World, Object>>()
                                                    : camera_matrices(asset, tree, scene);
  for (const std::uint32_t node : tree.drawn) {
    if (asset.model.nodes[node].camera >= 0) {
      place_camera(asset, matrices[tree.scene_index[node]], node, scene);
    }
    if (const auto* light =
            find(asset.document["nodes"][node], {"extensions", "KHR_lights_punctual", "light"})) {
      if (auto done = place_light(asset, tree, node, *light, scene); !done) return done;
    }
  }
  return {};
}

}  // namespace glassbox::gltf
