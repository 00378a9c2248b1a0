// Adds materials, found by their names, and their textures to the scene.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glassbox/mesh/input/directory.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/obj/mtl.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::obj {

// How map_Kd transforms texture coordinates whose v axis points up: (u, v) becomes (s_u u + o_u,
// s_v v + o_v) with the scale s and the offset o.
struct TexCoordMap {
  std::array<float, 2> offset{0, 0};
  std::array<float, 2> scale{1, 1};
  friend bool operator==(const TexCoordMap&, const TexCoordMap&) = default;
};

// Finds materials by their names and adds those that are used to the scene, with the images that
// they need.
class MaterialMaker {
public:
  MaterialMaker(Scene& scene, Directory& directory, const LoadLimits& limits, Warnings& warnings)
      : scene_(scene),
        directory_(directory),
        limits_(limits),
        warnings_(warnings),
        pixels_left_(limits.max_image_pixels) {}

  // Reads a material library. If two materials have the same name, the first one is used.
  void add_library(std::string_view text, std::string_view name);
  // Reads the libraries that the text after mtllib names: one name that may contain blanks, or
  // several names in which blanks are escaped.
  void read_libraries(std::string_view names);

  struct Made {
    std::uint32_t index = 0;  // in scene.materials
    TexCoordMap texcoord_map;
  };
  // The material that usemtl calls `name`; a default one where it is not defined.
  Made make(const std::string& name);

private:
  bool read_library(std::string_view name);
  Made made_from(const MtlMaterial& written);
  const MtlMaterial* find(std::string_view name) const;
  std::optional<std::uint32_t> texture(const MapStatement& map);
  std::optional<std::uint32_t> image(const std::filesystem::path& path);
  void set_opacity(const MtlMaterial& written, Material& material);
  void set_emission(const MtlMaterial& written, Material& material, TexCoordMap& texcoord_map);
  std::array<float, 3> clamped(const std::array<float, 3>& color, const std::string& material);

  Scene& scene_;
  Directory& directory_;
  const LoadLimits& limits_;
  Warnings& warnings_;
  std::uint64_t pixels_left_;
  int textures_sought_ = 0;

  std::vector<MtlMaterial> written_;
  std::map<const MtlMaterial*, Made> made_;
  std::map<std::string, std::size_t, std::less<>> written_by_name_;
  std::map<std::string, bool> libraries_read_;  // by canonical path
  // The index of each image, by its canonical path; nothing where decoding failed, so that it is
  // tried only once.
  std::map<std::string, std::optional<std::uint32_t>> images_;
  // By image, and whether it is clamped.
  std::map<std::pair<std::uint32_t, bool>, std::uint32_t> textures_;
};

}  // namespace glassbox::obj
