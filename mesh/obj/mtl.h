// Parses MTL text to materials as written, before textures are searched.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/mesh/input/text.h>

namespace glassbox::obj {

// A map statement: options, then a file name, which may contain blanks.
struct MapStatement {
  std::string file;
  std::array<float, 2> offset{0, 0};  // -o u v
  std::array<float, 2> scale{1, 1};   // -s u v
  bool clamp = false;                 // -clamp on
};

struct MtlMaterial {
  std::string name;  // to the end of the line
  std::optional<std::array<float, 3>> diffuse, specular, emission;
  std::optional<float> exponent, opacity, transparency;
  std::optional<std::int64_t> illumination;
  std::optional<MapStatement> diffuse_map, opacity_map, emission_map;
};

// Appends the materials of `text` in its order. Statements that cannot be read are skipped with a
// warning that names `library` and the line.
void parse_mtl(std::string_view text, std::string_view library, std::vector<MtlMaterial>& materials,
               Warnings& warnings);

MapStatement parse_map(std::string_view arguments);

}  // namespace glassbox::obj
