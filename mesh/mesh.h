// Meshes: tables of vertices, and the faces that index them (S3-01, S4-17, S4-18).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/base/spaces.h>

namespace glassbox {

struct TexCoord {
  float u = 0, v = 0;  // v = 0 is the top row of the image, as in glTF
  friend bool operator==(const TexCoord&, const TexCoord&) = default;
};

// A colour in linear light; the alpha is not premultiplied.
struct Rgba {
  float r = 1, g = 1, b = 1, a = 1;
  friend bool operator==(const Rgba&, const Rgba&) = default;
};

inline constexpr std::uint32_t kNone = 0xffffffffu;

// One corner of a face: an index into each table, kNone where the corner has no such attribute.
struct Corner {
  std::uint32_t position = kNone;
  std::uint32_t normal = kNone;
  std::uint32_t texcoord = kNone;
  std::uint32_t color = kNone;
  friend bool operator==(const Corner&, const Corner&) = default;
};

// A polygon: corners[first] .. corners[first + count - 1] of its mesh, counter-clockwise seen from
// outside.
struct Face {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  friend bool operator==(const Face&, const Face&) = default;
};

// One set of tables that is drawn with one material. Loaders guarantee that every index is in range
// (or kNone where allowed) and every number is finite, so that later stages need not check.
struct Mesh {
  std::string name;
  std::vector<Point<Object>> positions;
  std::vector<Normal<Object>> normals;  // unit length
  std::vector<TexCoord> texcoords;
  std::vector<Rgba> colors;

  std::vector<Corner> corners;
  std::vector<Face> faces;
  std::vector<std::array<Corner, 2>> lines;
  std::vector<Corner> points;

  std::uint32_t material = 0;  // index into Scene::materials
};

}  // namespace glassbox
