#include <glassbox/mesh/gltf/describe.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include <glassbox/mesh/gltf/sampler_codes.h>
#include <glassbox/mesh/gltf/text.h>

namespace glassbox::gltf {
namespace {

using nlohmann::json;

int wrap_code(Wrap wrap) {
  return std::ranges::find(kWrapCodes, wrap, &WrapCode::wrap)->code;
}
int minify_code(const Sampler& sampler) {
  const auto same = [&](const MinifyCode& each) {
    return each.filter == sampler.minify && each.mip == sampler.mip;
  };
  return std::ranges::find_if(kMinifyCodes, same)->code;
}

// glTF's emissive factors are at most 1; brighter emission needs a separate strength (the extension
// KHR_materials_emissive_strength).
void describe_emission(const Material& material, json& described) {
  const std::array<float, 3>& e = material.emission;
  const double strength = std::max({1.0, double(e[0]), double(e[1]), double(e[2])});
  described["emissiveFactor"] = {e[0] / strength, e[1] / strength, e[2] / strength};
  if (strength > 1) {
    described["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", strength}};
  }
  if (material.emission_texture) {
    described["emissiveTexture"] = {{"index", *material.emission_texture}};
  }
}

}  // namespace

json describe(const Sampler& sampler) {
  return {{"magFilter", sampler.magnify == Filter::kLinear ? kLinearCode : kNearestCode},
          {"minFilter", minify_code(sampler)},
          {"wrapS", wrap_code(sampler.wrap_u)},
          {"wrapT", wrap_code(sampler.wrap_v)}};
}

json describe(const Material& material) {
  const Rgba& base = material.base_color;
  json pbr{{"baseColorFactor", {base.r, base.g, base.b, base.a}},
           {"metallicFactor", 0.0},
           {"roughnessFactor", 1.0}};
  if (material.texture) pbr["baseColorTexture"] = {{"index", *material.texture}};
  json described;
  if (!material.name.empty()) described["name"] = material.name;
  described["pbrMetallicRoughness"] = pbr;
  if (material.alpha_mode != AlphaMode::kOpaque) {
    described["alphaMode"] = material.alpha_mode == AlphaMode::kMask ? "MASK" : "BLEND";
  }
  if (material.alpha_mode == AlphaMode::kMask) described["alphaCutoff"] = material.alpha_cutoff;
  if (material.double_sided) described["doubleSided"] = true;
  if (emits_light(material)) describe_emission(material, described);
  if (material.unlit) {
    described["extensions"]["KHR_materials_unlit"] = json::object();
  }
  described["extras"]["glassbox"] = {{"specular", material.specular},
                                     {"shininess", material.shininess}};
  if (emits_light(material)) described["extras"]["glassbox"]["emission"] = material.emission;
  return described;
}

Result<json> describe(const Camera& camera) {
  json described;
  if (!camera.name.empty()) described["name"] = camera.name;
  if (const auto* perspective = std::get_if<PerspectiveLens>(&camera.lens)) {
    described["type"] = "perspective";
    described["perspective"] = {{"yfov", perspective->fovy_radians}, {"znear", perspective->near}};
    if (perspective->far) described["perspective"]["zfar"] = *perspective->far;
  } else if (const auto* orthographic = std::get_if<OrthographicLens>(&camera.lens)) {
    described["type"] = "orthographic";
    described["orthographic"] = {{"xmag", orthographic->half_height},
                                 {"ymag", orthographic->half_height},
                                 {"znear", orthographic->near},
                                 {"zfar", orthographic->far}};
  } else {
    return fail("", "is given by the sides of a window, which glTF cannot store",
                "use a symmetric perspective camera");
  }
  return described;
}

json describe(const Light& light) {
  json described;
  if (!light.name.empty()) described["name"] = light.name;
  described["type"] = light.kind == LightKind::kDirectional ? "directional"
                      : light.kind == LightKind::kPoint     ? "point"
                                                            : "spot";
  described["color"] = light.color;
  described["intensity"] = light.intensity;
  if (light.range) described["range"] = *light.range;
  if (light.kind == LightKind::kSpot) {
    described["spot"] = {{"innerConeAngle", light.inner_cone_radians},
                         {"outerConeAngle", light.outer_cone_radians}};
  }
  return described;
}

glm::dmat4 pose_of(const Light& light) {
  glm::dmat4 columns(1.0);
  const Vector<World, double> z = -light.direction;
  if (light.kind != LightKind::kPoint) {
    const double ax = std::abs(z.x), ay = std::abs(z.y), az = std::abs(z.z);
    const Vector<World, double> other = ax <= ay && ax <= az ? Vector<World, double>{1, 0, 0}
                                        : ay <= az           ? Vector<World, double>{0, 1, 0}
                                                             : Vector<World, double>{0, 0, 1};
    Vector<World, double> x = cross(other, z);
    x = x * (1 / std::sqrt(dot(x, x)));
    const Vector<World, double> y = cross(z, x);
    const Vector<World, double> axes[3] = {x, y, z};
    for (int i = 0; i < 3; ++i) columns[i] = {axes[i].x, axes[i].y, axes[i].z, 0};
  }
  columns[3] = {light.position.x, light.position.y, light.position.z, 1};
  return columns;
}

Result<void> check_finite(const Scene& scene) {
  const auto refuse = [](std::string place) {
    return fail(std::move(place), "has numbers that are not finite",
                "repair the scene before writing it");
  };
  const auto matrix_is_finite = [](const glm::dmat4& columns) {
    for (int i = 0; i < 16; ++i) {
      if (!std::isfinite(columns[i / 4][i % 4])) return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (!matrix_is_finite(scene.nodes[i].parent_from_node.columns) ||
        !matrix_is_finite(scene.nodes[i].world_from_node.columns)) {
      return refuse(entry("node", i));
    }
  }
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    if (!matrix_is_finite(scene.cameras[i].world_from_eye.columns))
      return refuse(entry("camera", i));
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    if (!std::isfinite(light.intensity) || !matrix_is_finite(pose_of(light))) {
      return refuse(entry("light", i));
    }
  }
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    for (const Point<Object>& p : scene.meshes[i].positions) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        return refuse(entry("mesh", i));
    }
  }
  return {};
}

}  // namespace glassbox::gltf
