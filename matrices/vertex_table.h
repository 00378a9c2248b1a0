// Reads a table of vertices from a text: one row for each vertex, numbers separated by commas,
// semicolons, tabs or blanks.
//
//   1 2 3                                          x, y, z, and perhaps w
//   x,y,z                                          the same with names; other columns are skipped
//   VTX, IDX, Position.x, Position.y, ...          RenderDoc, "VS Input" of the mesh viewer
//   VTX, IDX, gl_Position.x, gl_Position.y, ...    RenderDoc, "VS Output"; also SV_Position
//   v 1 2 3                                        the vertices of an OBJ file; its other lines are
//                                                  skipped
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec4.hpp>

#include <glassbox/base/error.h>

namespace glassbox {

struct TableVertex {
  glm::dvec4 position{0, 0, 0, 1};
  glm::dvec4 uncertainty{0};  // half a unit of the last digit of each number, at least float's own
  int line = 0;               // counted from 1
};

struct VertexTable {
  std::vector<TableVertex> vertices;
  std::string columns;  // where the numbers are from: "Position.x, Position.y, Position.z"
};

// Vertices in a table. Larger ones are refused.
inline constexpr std::size_t kMaxTableVertices = 1'000'000;

// Which of the columns with names are read if several end in .x, .y and .z: a vertex's position in
// object space, or what a vertex shader computed from it.
enum class VertexColumns { kObject, kClip };

// Errors call the text `name` and say which line cannot be read. Clip positions need w.
Result<VertexTable> parse_vertex_table(std::string_view text, const std::string& name,
                                       VertexColumns wanted);

}  // namespace glassbox
