// Tables of vertices in the layouts that programs write, and what is refused.
#include <glassbox/matrices/vertex_table.h>

#include <string>

#include "tests/support/catch.h"

namespace glassbox {
namespace {

VertexTable read(const std::string& text, VertexColumns wanted = VertexColumns::kObject) {
  const auto table = parse_vertex_table(text, "in.csv", wanted);
  INFO((table ? std::string() : table.error().message()));
  REQUIRE(table);
  return *table;
}

std::string error(const std::string& text, VertexColumns wanted = VertexColumns::kObject) {
  const auto table = parse_vertex_table(text, "in.csv", wanted);
  REQUIRE_FALSE(table);
  return table.error().message();
}

}  // namespace

TEST_CASE("a table of vertices is read in every layout") {
  const std::string layouts[] = {
      "1 2 3\n4 5 6\n",
      "1,2,3\r\n4,5,6\r\n",
      "\xef\xbb\xbf# points\n1;2;3\n\n4;5;6",
      "1\t2\t3\n4\t5\t6\n",
      "x,y,z\n1,2,3\n4,5,6\n",
      "\"X\",\"Y\",\"Z\"\n1,2,3\n4,5,6\n",
      "VTX, IDX, Position.x, Position.y, Position.z, TexCoord.x, TexCoord.y\n"
      "0, 7, 1.00000, 2.00000, 3.00000, 0.1, 0.2\n1, 9, 4.00000, 5.00000, 6.00000, 0.3, 0.4\n",
      "VTX, IDX, in_normal.x, in_normal.y, in_normal.z, in_pos.x, in_pos.y, in_pos.z\n"
      "0, 7, 0, 0, 1, 1, 2, 3\n1, 9, 0, 0, 1, 4, 5, 6\n",
      "mtllib a.mtl\no cube\nv 1 2 3\nvt 0 1\nvn 0 0 1\nv 4 5 6 0.5 0.5 0.5\nusemtl m\nf 1 2 1\n",
  };
  for (const std::string& layout : layouts) {
    CAPTURE(layout);
    const VertexTable table = read(layout);
    REQUIRE(table.vertices.size() == 2);
    CHECK(table.vertices[0].position == glm::dvec4(1, 2, 3, 1));
    CHECK(table.vertices[1].position == glm::dvec4(4, 5, 6, 1));
  }
}

TEST_CASE("a table that a Windows shell wrote in UTF-16 is read") {
  std::string text = "\xff\xfe";
  for (const char c : std::string("1,2,3\r\n4,5,6\r\n")) text += {c, '\0'};
  CHECK(read(text).vertices[1].position == glm::dvec4(4, 5, 6, 1));
}

TEST_CASE("clip positions are the shader's position output, with w") {
  const std::string text =
      "VTX, IDX, v_color.x, v_color.y, v_color.z, v_color.w, gl_Position.x, gl_Position.y, "
      "gl_Position.z, gl_Position.w\n0, 0, 9, 9, 9, 9, 0.50000, -1.25000, 3.12345, 4.00000\n";
  const VertexTable table = read(text, VertexColumns::kClip);
  CHECK(table.vertices[0].position == glm::dvec4(0.5, -1.25, 3.12345, 4));
  CHECK(table.vertices[0].uncertainty.z == 0.5e-5);
  CHECK(table.columns == "gl_Position.x, gl_Position.y, gl_Position.z, gl_Position.w");
  CHECK(read("1 2 3 4", VertexColumns::kClip).vertices[0].position.w == 4);
}

TEST_CASE("a table that cannot be read says in which line") {
  CHECK(error("").find("there is no row of numbers") != std::string::npos);
  CHECK(error("1 2 3\n1 2 x\n").find("line 2: 'x' is not a number") != std::string::npos);
  CHECK(error("1,2,3\n1,2\n").find("line 2: there is no column 3") != std::string::npos);
  CHECK(error("1 2 3\n1 2 nan\n").find("line 2: a coordinate is not finite") != std::string::npos);
  CHECK(error("1 2 1e39\n").find("line 1: a coordinate is not finite") != std::string::npos);
  CHECK(error("x;y;z\n0,5;1,25;-2\n").find("write a point before decimals") != std::string::npos);
  CHECK(error("1 2\n").find("a position has three numbers") != std::string::npos);
  CHECK(error("1 2 3 4 5\n").find("a position has three numbers") != std::string::npos);
  CHECK(error("a,b,c\n1,2,3\n").find("no columns end in .x, .y and .z") != std::string::npos);
  CHECK(error("1 2 3\n", VertexColumns::kClip).find("four numbers") != std::string::npos);
  CHECK(error("p.x,p.y,p.z\n1,2,3\n", VertexColumns::kClip).find(".z and .w") != std::string::npos);
}

}  // namespace glassbox
