// The properties of a PLY element that are used.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>

#include <glassbox/mesh/ply/header.h>

namespace glassbox::ply {

using PropertyIndex = std::optional<std::size_t>;  // index of a property in its element

// The property with one of these names, if it is a single number; a list of the same name has
// another meaning.
inline PropertyIndex scalar(const Element& e, std::initializer_list<std::string_view> names) {
  const PropertyIndex index = e.find(names);
  return index && !e.properties[*index].count_type ? index : PropertyIndex();
}

struct ColorPropertyIndices {
  PropertyIndex red, green, blue, alpha;

  explicit ColorPropertyIndices(const Element& e)
      : red(scalar(e, {"red", "diffuse_red", "r"})),
        green(scalar(e, {"green", "diffuse_green", "g"})),
        blue(scalar(e, {"blue", "diffuse_blue", "b"})),
        alpha(scalar(e, {"alpha", "diffuse_alpha", "a"})) {}
  bool complete() const { return red && green && blue; }
};

struct VertexPropertyIndices {
  std::array<PropertyIndex, 3> position, normal;
  std::array<PropertyIndex, 2> texcoord;
  ColorPropertyIndices color;

  explicit VertexPropertyIndices(const Element& e)
      : position{scalar(e, {"x"}), scalar(e, {"y"}), scalar(e, {"z"})},
        normal{scalar(e, {"nx"}), scalar(e, {"ny"}), scalar(e, {"nz"})},
        texcoord{scalar(e, {"u", "s", "texture_u", "texture_s"}),
                 scalar(e, {"v", "t", "texture_v", "texture_t"})},
        color(e) {}
  bool has_normals() const { return normal[0] && normal[1] && normal[2]; }
  bool has_texcoords() const { return texcoord[0] && texcoord[1]; }
};

}  // namespace glassbox::ply
