// The properties of a PLY element that are used, and the meaning of their numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

#include <glassbox/images/srgb.h>
#include <glassbox/mesh/ply/header.h>

namespace glassbox::ply {

using PropertyIndex = std::optional<std::size_t>;  // index of a property in its element

// ---- which properties have which meaning ----

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

// ---- colours ----

// A channel's value as a fraction of the largest value of its type.
inline double fraction_of(double value, Type type) {
  switch (type) {
    case Type::kInt8:
      return value / 127;
    case Type::kUint8:
      return value / 255;
    case Type::kInt16:
      return value / 32767;
    case Type::kUint16:
      return value / 65535;
    case Type::kInt32:
      return value / 2147483647.0;
    case Type::kUint32:
      return value / 4294967295.0;
    case Type::kFloat32:
    case Type::kFloat64:
      break;
  }
  return value;
}

// The fraction clamped to [0, 1]; NaN becomes 0.
inline double clamp_to_unit(double fraction) {
  return fraction > 0 ? std::min(fraction, 1.0) : 0.0;
}

// The linear light of a channel: integers and fractions are taken as sRGB and rounded to one of its
// 256 codes.
inline float light_of(double value, Type type) {
  const double code = std::floor(clamp_to_unit(fraction_of(value, type)) * 255 + 0.5);
  return decode_srgb(std::uint8_t(code));
}

}  // namespace glassbox::ply
