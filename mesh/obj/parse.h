// Parses OBJ text to tables: every statement is read and checked, but nothing is arranged for
// drawing yet.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/input/text.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/mesh.h>

namespace glassbox::obj {

// Gives each name a number. Number 0 is the empty name.
class Names {
public:
  Names() { number_of(""); }
  Names(Names&&) = default;
  Names& operator=(Names&&) = default;

  std::uint32_t number_of(std::string_view name);
  const std::string& operator[](std::uint32_t number) const { return *names_[number]; }

private:
  std::map<std::string, std::uint32_t, std::less<>> numbers_;
  std::vector<const std::string*> names_;  // keys of the map, whose addresses do not change
};

// The indices at one corner, counted from 0; kNone where there is none.
struct Reference {
  std::uint32_t position = kNone;
  std::uint32_t texcoord = kNone;
  std::uint32_t normal = kNone;
};

enum class ElementKind : std::uint8_t { kFace, kPolyline, kPoints };

// One f, l or p statement: references[first] .. references[first + count - 1].
struct Element {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t part = 0;
  std::uint32_t smoothing_group = 0;  // 0: in none
  ElementKind kind = ElementKind::kFace;
};

// The part that becomes one mesh: everything that is drawn under the same names.
struct Part {
  std::uint32_t object = 0, group = 0, material = 0;  // in Tables::names
  auto operator<=>(const Part&) const = default;
};

// The colour of a vertex as an sRGB code for each channel, if the file gives one.
struct VertexColor {
  std::uint8_t r = 255, g = 255, b = 255;
  bool given = false;
};

// A vertex whose coordinates are not finite numbers is an error only if something is drawn with it.
struct UnreadableVertex {
  std::uint32_t index = 0;
  std::uint64_t line = 0;
  std::string not_finite;  // "nan" or "1e99": the first coordinate that is a number, but not finite
};

struct Tables {
  std::vector<Point<Object>> positions;      // NaN where unreadable, otherwise finite
  std::vector<UnreadableVertex> unreadable;  // ascending
  std::vector<VertexColor> colors;           // as many as positions, or none at all
  std::vector<TexCoord> texcoords;      // v = 0 at the bottom, as in the file; NaN where unreadable
  std::vector<Normal<Object>> normals;  // of any length; zero where unreadable

  std::vector<Reference> references;  // all within the tables
  std::vector<Element> elements;
  std::vector<Part> parts;  // each has at least one element

  Names names;
  std::vector<std::string> libraries;  // the text after mtllib, each text once
};

Result<Tables> parse_obj(std::string_view text, const LoadLimits& limits, Warnings& warnings);

}  // namespace glassbox::obj
