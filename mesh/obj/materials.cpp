#include <glassbox/mesh/obj/materials.h>

#include <algorithm>

#include <glassbox/images/decode.h>

namespace glassbox::obj {
namespace {

// Finds the file of a map statement. A comment may follow the name, but the name itself may also
// contain a '#', so the text with the '#' is tried first.
Result<std::filesystem::path> find_map(const Directory& directory, std::string_view file) {
  auto found = directory.find(file);
  if (found) return found;
  const std::string_view shorter = without_comment(file);
  if (shorter.empty() || shorter == file) return found;
  if (auto second = directory.find(shorter); second) return second;
  return found;
}

// Splits "a.mtl b\ c.mtl" into "a.mtl" and "b c.mtl".
std::vector<std::string> split_names(std::string_view text) {
  std::vector<std::string> names(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escapes = text[i] == '\\' && i + 1 < text.size() && text[i + 1] == ' ';
    if (escapes) {
      names.back() += text[++i];
    } else if (text[i] == ' ' || text[i] == '\t') {
      if (!names.back().empty()) names.emplace_back();
    } else {
      names.back() += text[i];
    }
  }
  return names;
}

std::string bounded_name(std::string_view name) {
  constexpr std::size_t kMaxLength = 255;
  const std::string_view short_name = without_comment(name);
  return std::string((short_name.empty() ? name : short_name).substr(0, kMaxLength));
}

// MTL's exponent Ns is a real number, at least 0; the scene's exponents are integers, at least 1.
int shininess_from(float exponent) {
  return int(std::clamp(double(exponent), 1.0, 1024.0) + 0.5);
}

TexCoordMap texcoord_map_of(const MapStatement& map) {
  return {map.offset, map.scale};
}

// OBJ does not say which side of a face is its outside, and files disagree: both sides are drawn.
Material plain_material(std::string name) {
  Material material;
  material.name = std::move(name);
  material.double_sided = true;
  return material;
}

}  // namespace

void MaterialMaker::add_library(std::string_view text, std::string_view name) {
  const std::size_t before = written_.size();
  parse_mtl(text, name, written_, warnings_);
  for (std::size_t i = before; i < written_.size(); ++i) {
    const auto [first, is_first] = written_by_name_.try_emplace(written_[i].name, i);
    if (!is_first) {
      warnings_.add("the material " + in_quotes(written_[i].name) +
                    " is defined more than once; the first definition is used");
    }
  }
  for (std::size_t i = before; i < written_.size(); ++i) {
    written_by_name_.try_emplace(std::string(without_comment(written_[i].name)), i);
  }
}

bool MaterialMaker::read_library(std::string_view name) {
  const auto found = directory_.find(name);
  if (!found) return false;
  if (!libraries_read_.emplace(found->string(), true).second) return true;
  const auto bytes = directory_.read(*found);
  if (!bytes) {
    warnings_.add("the material library " + in_quotes(name) +
                  " was not read: " + bytes.error().cause);
    return true;
  }
  add_library({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, name);
  return true;
}

void MaterialMaker::read_libraries(std::string_view names) {
  const std::string_view uncommented = without_comment(names);
  if (read_library(names) || read_library(uncommented)) return;
  // A line may name any number of files; at most this many are searched.
  constexpr std::size_t kMaxNames = 64;
  const std::vector<std::string> all = split_names(uncommented);
  bool any = false;
  for (std::size_t i = 0; i < std::min(all.size(), kMaxNames); ++i) {
    if (!all[i].empty() && read_library(all[i])) any = true;
  }
  if (!any && !uncommented.empty()) warnings_.add(directory_.find(uncommented).error().cause);
}

const MtlMaterial* MaterialMaker::find(std::string_view name) const {
  auto found = written_by_name_.find(name);
  if (found == written_by_name_.end()) found = written_by_name_.find(without_comment(name));
  return found == written_by_name_.end() ? nullptr : &written_[found->second];
}

std::array<float, 3> MaterialMaker::clamped(const std::array<float, 3>& color,
                                            const std::string& material) {
  std::array<float, 3> within{};
  for (std::size_t i = 0; i < 3; ++i) within[i] = std::clamp(color[i], 0.0f, 1.0f);
  if (within != color) {
    warnings_.add("the material " + in_quotes(material) +
                  " has a colour outside [0, 1], which was clamped");
  }
  return within;
}

void MaterialMaker::set_opacity(const MtlMaterial& written, Material& material) {
  const float opacity = written.opacity        ? *written.opacity
                        : written.transparency ? 1.0f - *written.transparency
                                               : 1.0f;
  material.base_color.a = std::clamp(opacity, 0.0f, 1.0f);
  if (material.base_color.a < 1.0f) material.alpha_mode = AlphaMode::kBlend;
  if (!written.opacity_map) return;
  // If both maps name one file, its own alpha is to be used: this is how exporters say so.
  if (written.diffuse_map && written.diffuse_map->file == written.opacity_map->file) {
    if (material.texture) material.alpha_mode = AlphaMode::kBlend;
  } else {
    warnings_.add(
        "the material " + in_quotes(written.name) +
        " has an opacity texture (map_d) that is not its colour texture (map_Kd), and was ignored");
  }
}

// A mesh has one table of texture coordinates, so the maps of colour and emission must transform
// them in the same way.
void MaterialMaker::set_emission(const MtlMaterial& written, Material& material,
                                 TexCoordMap& texcoord_map) {
  if (material.unlit || (!written.emission && !written.emission_map)) return;
  const std::array<float, 3> own = written.emission.value_or(std::array<float, 3>{1, 1, 1});
  std::array<float, 3> emission{};
  for (std::size_t i = 0; i < 3; ++i) emission[i] = std::max(own[i], 0.0f);
  if (written.emission_map && emission != std::array<float, 3>{}) {
    const TexCoordMap moved = texcoord_map_of(*written.emission_map);
    if (material.texture && moved != texcoord_map) {
      warnings_.add("the material " + in_quotes(written.name) +
                    " has an emission texture (map_Ke) with other coordinates than its colour "
                    "texture (map_Kd): its emission was left out");
      return;
    }
    material.emission_texture = texture(*written.emission_map);
    // Without the texture, the whole surface would glow.
    if (!material.emission_texture) return;
    texcoord_map = moved;
  }
  material.emission = emission;
}

MaterialMaker::Made MaterialMaker::make(const std::string& name) {
  if (const MtlMaterial* const written = name.empty() ? nullptr : find(name)) {
    const auto [known, is_first] = made_.try_emplace(written);
    if (is_first) known->second = made_from(*written);
    return known->second;
  }
  if (!name.empty()) {
    warnings_.add("the material " + in_quotes(name) +
                  " is not defined; a default material is used");
  }
  const auto index = std::uint32_t(scene_.materials.size());
  scene_.materials.push_back(plain_material(name.empty() ? "default" : bounded_name(name)));
  return {index, {}};
}

MaterialMaker::Made MaterialMaker::made_from(const MtlMaterial& written) {
  Made made;
  Material material = plain_material(bounded_name(written.name));
  if (written.diffuse) {
    const auto kd = clamped(*written.diffuse, written.name);
    material.base_color = {kd[0], kd[1], kd[2], 1};
  }
  const std::int64_t illumination = written.illumination.value_or(2);
  material.unlit = illumination == 0;
  if (written.specular && illumination >= 2) {
    material.specular = clamped(*written.specular, written.name);
  }
  if (written.exponent) material.shininess = shininess_from(*written.exponent);
  if (written.diffuse_map) {
    material.texture = texture(*written.diffuse_map);
    if (material.texture) made.texcoord_map = texcoord_map_of(*written.diffuse_map);
  }
  set_opacity(written, material);
  set_emission(written, material, made.texcoord_map);
  made.index = std::uint32_t(scene_.materials.size());
  scene_.materials.push_back(std::move(material));
  return made;
}

std::optional<std::uint32_t> MaterialMaker::texture(const MapStatement& map) {
  // The number of searches is limited, because searching for a file takes far longer than naming
  // it, and a hostile library can name many files.
  constexpr int kMaxTexturesSought = 4096;
  if (textures_sought_ == kMaxTexturesSought) {
    warnings_.add("a texture was left out: only the first " + std::to_string(kMaxTexturesSought) +
                  " are looked for");
    return std::nullopt;
  }
  ++textures_sought_;
  const auto path = find_map(directory_, map.file);
  if (!path) {
    warnings_.add("a texture was left out: " + path.error().cause);
    return std::nullopt;
  }
  const auto pixels = image(*path);
  if (!pixels) return std::nullopt;
  const auto [known, is_first] =
      textures_.try_emplace(std::pair(*pixels, map.clamp), std::uint32_t(scene_.textures.size()));
  if (is_first) {
    Texture made;
    made.image = *pixels;
    made.sampler.wrap_u = made.sampler.wrap_v = map.clamp ? Wrap::kClampToEdge : Wrap::kRepeat;
    scene_.textures.push_back(made);
  }
  return known->second;
}

std::optional<std::uint32_t> MaterialMaker::image(const std::filesystem::path& path) {
  const auto [known, is_first] = images_.try_emplace(path.string());
  if (!is_first) return known->second;
  const auto refuse = [&](const std::string& cause) {
    warnings_.add("the texture " + in_quotes(path.filename().string()) + " was left out: " + cause);
    return std::nullopt;
  };
  const auto bytes = directory_.read(path);
  if (!bytes) return refuse(bytes.error().cause);
  DecodeLimits decode_limits;
  decode_limits.max_pixels = pixels_left_;
  decode_limits.max_side = limits_.max_image_side;
  auto decoded = decode_image(*bytes, decode_limits);
  if (!decoded) return refuse(decoded.error().cause);
  pixels_left_ -= std::min<std::uint64_t>(pixels_left_, decoded->pixels.size());
  known->second = std::uint32_t(scene_.images.size());
  scene_.images.push_back(std::move(*decoded));
  return known->second;
}

}  // namespace glassbox::obj
