// The header of a PLY file: which elements follow, how many of each, and which properties each has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::ply {

enum class Format { kAscii, kLittleEndian, kBigEndian };
enum class Type { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

inline bool is_integer(Type type) {
  return type != Type::kFloat32 && type != Type::kFloat64;
}
inline std::size_t bytes_of(Type type) {
  constexpr std::size_t kBytes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes[std::size_t(type)];
}

struct Property {
  std::string name;
  // The type of the value, or of each value of the list.
  Type type = Type::kFloat32;
  // For lists: the type in which the file stores the number of values.
  std::optional<Type> count_type = {};
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;

  // The index of the property with one of the names, if there is one.
  std::optional<std::size_t> find(std::initializer_list<std::string_view> names) const;
};

struct Header {
  Format format = Format::kAscii;
  std::vector<Element> elements;      // in the order of their data
  std::vector<std::string> textures;  // "comment TextureFile NAME", a convention of MeshLab
  std::size_t data_begin = 0;         // offset in the file
  std::uint64_t data_line = 0;        // line number of the first data

  const Element* find(std::string_view name) const;
};

// Whether the first line is "ply", apart from a byte order mark before it and blanks behind it.
bool begins_as_ply(std::string_view file);

// Checks every line, and that the counts of elements fit into the bytes after the header: in binary
// a value has the bytes of its type, in text at least a digit and a blank, and a list has at least
// its count.
Result<Header> parse_header(std::string_view file);

}  // namespace glassbox::ply
