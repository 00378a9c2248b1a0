#include <glassbox/mesh/gltf/materials.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/gltf/images.h>
#include <glassbox/mesh/gltf/sampler_codes.h>
#include <glassbox/mesh/gltf/text.h>

namespace glassbox::gltf {
namespace {

using nlohmann::json;

// The reflectance of glass and plastics at normal incidence is about 0.04 in linear light.
// Blinn-Phong without a Fresnel term looks dull with this value, so 0.2 is used for dielectrics.
constexpr double kDielectricSpecular = 0.2;

// The Blinn-Phong exponent whose highlight is about as wide as that of the GGX reflection model
// with the same roughness: 2/alpha^2 - 2 with alpha = roughness^2.
int shininess_of(double roughness) {
  const double r = std::max(roughness, 0.1);
  const double exponent = std::floor(2 / ((r * r) * (r * r)) - 2 + 0.5);
  return int(std::clamp(exponent, 4.0, 256.0));
}

void set_specular(Material& material, double metallic, double roughness) {
  const double smooth = (1 - roughness) * (1 - roughness);
  const double base[3] = {material.base_color.r, material.base_color.g, material.base_color.b};
  for (std::size_t i = 0; i < 3; ++i) {
    const double reflected = kDielectricSpecular * (1 - metallic) + base[i] * metallic;
    material.specular[i] = float(reflected * smooth);
  }
  material.shininess = shininess_of(roughness);
}

// The largest emission for which neither its product with a texel nor its sum with the reflected
// light overflows (kBrightest of raster/shading.h).
constexpr double kBrightestEmission = 1e18;

float emission_of(double emitted) {
  return float(std::min(emitted, kBrightestEmission));
}

// With KHR_materials_unlit only the base colour is shown, so there is no emission.
void set_emission(Material& material, const json& document) {
  const json* factor = find(document, {"emissiveFactor"});
  if (factor == nullptr || material.unlit) return;
  const json* strength =
      find(document, {"extensions", "KHR_materials_emissive_strength", "emissiveStrength"});
  for (std::size_t i = 0; i < 3; ++i) {
    const double own = (*factor)[i].get<double>();
    material.emission[i] = emission_of(own * (strength ? strength->get<double>() : 1.0));
  }
}

// Restores the numbers that write_glb stored in the extras, because metallic-roughness has no exact
// counterpart for them.
void restore_exact(Material& material, const json& exact) {
  for (std::size_t i = 0; i < 3; ++i)
    material.specular[i] = float(exact["specular"][i].get<double>());
  material.shininess = exact["shininess"].get<int>();
  if (!exact.contains("emission") || material.unlit) return;
  for (std::size_t i = 0; i < 3; ++i)
    material.emission[i] = emission_of(exact["emission"][i].get<double>());
}

Material convert(const tinygltf::Material& described, const json& document) {
  Material material;
  const tinygltf::PbrMetallicRoughness& pbr = described.pbrMetallicRoughness;
  material.name = printable(described.name);
  if (pbr.baseColorFactor.size() == 4) {
    material.base_color = {float(pbr.baseColorFactor[0]), float(pbr.baseColorFactor[1]),
                           float(pbr.baseColorFactor[2]), float(pbr.baseColorFactor[3])};
  }
  material.alpha_mode = described.alphaMode == "MASK"    ? AlphaMode::kMask
                        : described.alphaMode == "BLEND" ? AlphaMode::kBlend
                                                         : AlphaMode::kOpaque;
  material.alpha_cutoff = float(described.alphaCutoff);
  material.double_sided = described.doubleSided;
  material.unlit = find(document, {"extensions", "KHR_materials_unlit"}) != nullptr;
  set_emission(material, document);
  if (const json* exact = find(document, {"extras", "glassbox"})) {
    restore_exact(material, *exact);
  } else {
    set_specular(material, pbr.metallicFactor, pbr.roughnessFactor);
  }
  return material;
}

TexCoordTransform read_transform(const json& described) {
  const json offset = described.value("offset", json{0.0, 0.0});
  const json scale = described.value("scale", json{1.0, 1.0});
  const SinCos turn = sin_cos(described.value("rotation", 0.0));
  const double u_scale = scale[0], v_scale = scale[1];
  TexCoordTransform transform;
  // The rotation is counter-clockwise on the displayed image, where v points down.
  transform.matrix[0][0] = turn.cos * u_scale;
  transform.matrix[0][1] = turn.sin * v_scale;
  transform.matrix[0][2] = offset[0];
  transform.matrix[1][0] = -turn.sin * u_scale;
  transform.matrix[1][1] = turn.cos * v_scale;
  transform.matrix[1][2] = offset[1];
  return transform;
}

Result<TexCoordSource> texcoord_source(const json& texture_info, std::size_t material) {
  TexCoordSource source;
  source.textured = true;
  source.set = texture_info.value("texCoord", 0u);
  if (const json* transform = find(texture_info, {"extensions", "KHR_texture_transform"})) {
    source.set = transform->value("texCoord", source.set);
    source.transform = read_transform(*transform);
    for (const auto& row : source.transform->matrix) {
      for (const double number : row) {
        if (!std::isfinite(number)) {
          return fail(entry("material", material),
                      "the transform of its texture has numbers that are not finite or a rotation "
                      "of too many turns",
                      "correct KHR_texture_transform");
        }
      }
    }
  }
  return source;
}

Result<Wrap> wrap_of(int code, std::size_t sampler) {
  const auto known = std::ranges::find(kWrapCodes, code, &WrapCode::code);
  if (known != std::end(kWrapCodes)) return known->wrap;
  return fail(entry("sampler", sampler), "has the unknown wrap mode " + std::to_string(code),
              "use 10497 (repeat), 33071 (clamp to edge) or 33648 (mirrored repeat)");
}

Result<Sampler> convert_sampler(const tinygltf::Sampler& described, std::size_t index) {
  Sampler sampler;
  const auto wrap_u = wrap_of(described.wrapS, index);
  const auto wrap_v = wrap_of(described.wrapT, index);
  if (!wrap_u) return tl::unexpected(wrap_u.error());
  if (!wrap_v) return tl::unexpected(wrap_v.error());
  sampler.wrap_u = *wrap_u;
  sampler.wrap_v = *wrap_v;
  if (described.magFilter == kNearestCode) sampler.magnify = Filter::kNearest;
  // A sampler without a minification filter gets the best one.
  if (described.minFilter == -1) return sampler;
  const auto known = std::ranges::find(kMinifyCodes, described.minFilter, &MinifyCode::code);
  if (known == std::end(kMinifyCodes)) {
    return fail(entry("sampler", index),
                "has the unknown filter " + std::to_string(described.minFilter),
                "use 9728 (nearest), 9729 (linear), or 9984 to 9987 (with mipmaps)");
  }
  sampler.minify = known->filter;
  sampler.mip = known->mip;
  return sampler;
}

// Adds the textures that materials need to the scene, each once.
class TextureTable {
public:
  TextureTable(Asset& asset, Scene& scene)
      : asset_(asset),
        scene_(scene),
        images_(asset, scene),
        known_(asset.model.textures.size()),
        reported_(asset.model.textures.size(), false) {}

  // Returns the index in Scene::textures; nothing where the texture has no image that could be
  // drawn.
  Result<std::optional<std::uint32_t>> add(std::size_t index) {
    if (known_[index]) return known_[index];
    const tinygltf::Texture& described = asset_.model.textures[index];
    if (described.source < 0) {
      if (!reported_[index]) {
        asset_.warn_at(entry("texture", index),
                       "has no image in a supported format and was left out");
      }
      reported_[index] = true;
      return std::optional<std::uint32_t>();
    }
    Texture texture;
    if (described.sampler >= 0) {
      const auto sampler = convert_sampler(asset_.model.samplers[std::size_t(described.sampler)],
                                           std::size_t(described.sampler));
      if (!sampler) return tl::unexpected(sampler.error());
      texture.sampler = *sampler;
    }
    const auto image = images_.add(std::size_t(described.source));
    if (!image) return tl::unexpected(image.error());
    texture.image = *image;
    known_[index] = std::uint32_t(scene_.textures.size());
    scene_.textures.push_back(texture);
    return known_[index];
  }

private:
  Asset& asset_;
  Scene& scene_;
  ImageTable images_;
  std::vector<std::optional<std::uint32_t>> known_;
  // Textures without an image for which a warning was given.
  std::vector<bool> reported_;
};

// The texture that a material of the file names, and its coordinates; nothing where it cannot be
// drawn.
struct NamedTexture {
  std::optional<std::uint32_t> texture;
  TexCoordSource texcoords;
};

Result<NamedTexture> named_texture(const json& info, std::size_t material, TextureTable& textures) {
  NamedTexture named;
  const auto texcoords = texcoord_source(info, material);
  if (!texcoords) return tl::unexpected(texcoords.error());
  const auto texture = textures.add(info["index"].get<std::size_t>());
  if (!texture) return tl::unexpected(texture.error());
  named.texture = *texture;
  if (*texture) named.texcoords = *texcoords;
  return named;
}

// If the emission texture cannot be read, the material gets no emission, because otherwise the
// whole surface would glow.
Result<void> add_emission_texture(Asset& asset, const json& info, std::size_t index,
                                  TextureTable& textures, Material& material,
                                  TexCoordSource& source) {
  const auto named = named_texture(info, index, textures);
  if (!named) return tl::unexpected(named.error());
  if (!named->texture || (source.textured && source != named->texcoords)) {
    material.emission = {};
    if (named->texture) {
      asset.warn_at(
          entry("material", index),
          "its emission was left out: the emission's texture has other texture coordinates "
          "than the base colour's");
    }
    return {};
  }
  material.emission_texture = named->texture;
  source = named->texcoords;
  return {};
}

// Calls `visit` with each primitive of each mesh that a drawn node has.
template <class Visit>
void for_each_drawn_primitive(const Asset& asset, const NodeTree& tree, Visit visit) {
  std::vector<bool> seen(asset.model.meshes.size(), false);
  for (const std::uint32_t node : tree.drawn) {
    const int mesh = asset.model.nodes[node].mesh;
    if (mesh < 0 || seen[std::size_t(mesh)]) continue;
    seen[std::size_t(mesh)] = true;
    for (const tinygltf::Primitive& primitive : asset.model.meshes[std::size_t(mesh)].primitives) {
      visit(primitive);
    }
  }
}

}  // namespace

std::vector<bool> used_materials(const Asset& asset, const NodeTree& tree) {
  std::vector<bool> used(asset.model.materials.size(), false);
  for_each_drawn_primitive(asset, tree, [&](const tinygltf::Primitive& primitive) {
    if (primitive.material >= 0) used[std::size_t(primitive.material)] = true;
  });
  return used;
}

bool shows_emission_texture(const tinygltf::Material& described, const json& document,
                            const json& textures) {
  const json* own = find(document, {"emissiveTexture"});
  if (own == nullptr || !emits_light(convert(described, document))) return false;
  const json* base = find(document, {"pbrMetallicRoughness", "baseColorTexture"});
  if (base == nullptr || !textures[(*base)["index"].get<std::size_t>()].contains("source")) {
    return true;
  }
  const auto wanted = texcoord_source(*own, 0), present = texcoord_source(*base, 0);
  return wanted && present && *wanted == *present;
}

Result<Materials> convert_materials(Asset& asset, const NodeTree& tree, Scene& scene) {
  const std::vector<bool> used = used_materials(asset, tree);
  Materials materials;
  TextureTable textures(asset, scene);
  for (std::size_t i = 0; i < asset.model.materials.size(); ++i) {
    const json& document = asset.document["materials"][i];
    Material material = convert(asset.model.materials[i], document);
    TexCoordSource source;
    if (const json* info = find(document, {"pbrMetallicRoughness", "baseColorTexture"});
        info && used[i]) {
      const auto named = named_texture(*info, i, textures);
      if (!named) return tl::unexpected(named.error());
      material.texture = named->texture;
      source = named->texcoords;
    }
    if (const json* info = find(document, {"emissiveTexture"});
        info && used[i] && emits_light(material)) {
      auto done = add_emission_texture(asset, *info, i, textures, material, source);
      if (!done) return tl::unexpected(done.error());
    }
    scene.materials.push_back(std::move(material));
    materials.texcoords.push_back(source);
  }
  bool needs_default = false;
  for_each_drawn_primitive(asset, tree, [&](const tinygltf::Primitive& primitive) {
    needs_default = needs_default || primitive.material < 0;
  });
  if (needs_default) {
    // glTF's default is white, metallic and fully rough.
    scene.materials.push_back(convert(tinygltf::Material(), json::object()));
    scene.materials.back().name = "default";
    materials.texcoords.emplace_back();
  }
  return materials;
}

}  // namespace glassbox::gltf
