// The scene as data: meshes placed in the world, with materials, cameras and lights.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glassbox/base/spaces.h>
#include <glassbox/images/image.h>
#include <glassbox/mesh/mesh.h>

namespace glassbox {

// ---- surfaces ----

enum class Wrap { kRepeat, kMirroredRepeat, kClampToEdge };
enum class Filter { kNearest, kLinear };
enum class MipFilter { kNone, kNearest, kLinear };

struct Sampler {
  Wrap wrap_u = Wrap::kRepeat;
  Wrap wrap_v = Wrap::kRepeat;
  Filter magnify = Filter::kLinear;
  Filter minify = Filter::kLinear;
  MipFilter mip = MipFilter::kLinear;
  friend bool operator==(const Sampler&, const Sampler&) = default;
};

struct Texture {
  std::uint32_t image = 0;  // index into Scene::images
  Sampler sampler;
};

enum class AlphaMode { kOpaque, kMask, kBlend };

// Colours are linear. The reflection model is Blinn-Phong: see raster/shading.h for the formula.
struct Material {
  std::string name;
  Rgba base_color;                       // multiplied by the texture and the vertex colour
  std::optional<std::uint32_t> texture;  // index into Scene::textures
  std::array<float, 3> specular{0, 0, 0};
  int shininess = 16;  // exponent, 1 .. 1024
  AlphaMode alpha_mode = AlphaMode::kOpaque;
  float alpha_cutoff = 0.5f;  // kMask: visible where alpha >= cutoff
  bool double_sided = false;
  bool unlit = false;
  // The emitted light, in the units of the reflected light. It is multiplied by the texture and
  // then added to the reflected light. Unlit materials have none.
  std::array<float, 3> emission{0, 0, 0};
  std::optional<std::uint32_t> emission_texture;  // index into Scene::textures
};

inline bool emits_light(const Material& material) {
  const std::array<float, 3>& e = material.emission;
  return !material.unlit && (e[0] != 0 || e[1] != 0 || e[2] != 0);
}

// ---- placement ----

struct Node {
  std::string name;
  // Index into Scene::nodes, always smaller than the node's own index; kNone for a root, whose
  // parent is the world.
  std::uint32_t parent = kNone;
  Transform<World, Object> parent_from_node;
  Transform<World, Object> world_from_node;  // the product of the transforms from the root down
};

// A mesh at a node. Instances are drawn, and their triangles numbered, in the order of this list.
struct Instance {
  std::uint32_t mesh = 0;  // index into Scene::meshes
  std::uint32_t node = 0;  // index into Scene::nodes
};

// ---- cameras ----

// A perspective lens with a full vertical angle; far may be absent (infinite). The aspect ratio is
// the viewport's.
struct PerspectiveLens {
  double fovy_radians = 0.785398163397448309616;
  double near = 0.1;
  std::optional<double> far;
};
// A parallel lens with half the vertical extent of the view in world units; the horizontal extent
// follows from the viewport's aspect ratio.
struct OrthographicLens {
  double half_height = 1;
  double near = 0;
  double far = 1;
};
// The window's edges on the near plane, in world units, as for glFrustum.
struct FrustumLens {
  double left = -1, right = 1, bottom = -1, top = 1;
  double near = 1;
  std::optional<double> far;
};
using Lens = std::variant<PerspectiveLens, OrthographicLens, FrustumLens>;

struct Camera {
  std::string name;
  Lens lens;
  Transform<World, Eye> world_from_eye;  // rigid
  // Why the camera of a file cannot be used; empty if it can. Otherwise its lens and its pose mean
  // nothing. It keeps its place in the list, so that the others keep their numbers.
  std::string fault = {};
};

// ---- lights (KHR_lights_punctual) ----

enum class LightKind { kDirectional, kPoint, kSpot };

struct Light {
  std::string name;
  LightKind kind = LightKind::kDirectional;
  std::array<float, 3> color{1, 1, 1};                  // linear
  double intensity = 1;                                 // lux (directional), candela (point, spot)
  std::optional<double> range;                          // world units; no light beyond it
  double inner_cone_radians = 0;                        // spot lights: full intensity inside
  double outer_cone_radians = 0.785398163397448309616;  // spot lights: no light outside
  Point<World, double> position;                        // point lights and spot lights only
  // The direction in which the light travels, of unit length; directional and spot lights only.
  Vector<World, double> direction;
};

// ---- the whole ----

struct Scene {
  std::string name;
  std::string file;  // as the user gave it; empty for built-in scenes
  std::vector<Mesh> meshes;
  std::vector<Material> materials;  // never empty
  std::vector<Texture> textures;
  std::vector<Image<Rgba8>> images;
  std::vector<Node> nodes;
  std::vector<Instance> instances;
  std::vector<Camera> cameras;
  std::vector<Light> lights;            // if there are none, a default headlight is used
  std::vector<std::string> extensions;  // the names of the extensions that the file uses
  std::vector<std::string> warnings;    // what was ignored or repaired, one sentence each
};

}  // namespace glassbox
