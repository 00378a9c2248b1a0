// Calls your functions with the meshes of a scene.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_01 {
namespace {

using glassbox::labs::append_point;
using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

// Writes tables as numbers: the number of positions and the positions; then for each face the
// number of its corners and their position indices.
void append_tables(Numbers& out, const Mesh& mesh) {
  out.push_back(double(mesh.positions.size()));
  for (const auto& p : mesh.positions) append_point(out, p);
  for (const glassbox::Face& face : mesh.faces) {
    out.push_back(double(face.count));
    for (std::uint32_t c = face.first; c < face.first + face.count; ++c)
      out.push_back(c < mesh.corners.size() ? double(mesh.corners[c].position) : -1);
  }
}

Mesh tables(RecordReader& in) {
  Mesh mesh;
  for (int left = in.integer(); left > 0; --left)
    mesh.positions.push_back(in.point<Point<Object>>());
  while (in.more()) {
    const auto count = std::uint32_t(in.integer());
    mesh.faces.push_back({std::uint32_t(mesh.corners.size()), count});
    for (std::uint32_t i = 0; i < count; ++i) {
      mesh.corners.emplace_back();
      mesh.corners.back().position = std::uint32_t(in.integer());
    }
  }
  return mesh;
}

// Input: a text, one number for each character. Output: the mesh in it, as tables of numbers.
void read(RecordReader& in, Numbers& out) {
  std::string text;
  while (in.more()) text += char(in.integer());
  append_tables(out, read_mesh(text));
}

// Input: a mesh as tables of numbers. Output: V - E + F, whether the surface is closed (1 or 0),
// then each edge: low, high, ascending, descending.
void edges(RecordReader& in, Numbers& out) {
  const EdgeTable found = find_edges(tables(in));
  out.insert(out.end(), {double(found.euler), found.closed ? 1.0 : 0.0});
  for (const Edge& edge : found.edges)
    out.insert(out.end(), {double(edge.low), double(edge.high), double(edge.ascending),
                           double(edge.descending)});
}

// Input: a mesh as tables of numbers. Output: 1 or 0 for each face, whether it is turned; nothing
// if the faces cannot be made to agree.
void turns(RecordReader& in, Numbers& out) {
  if (const auto found = faces_to_turn(tables(in)))
    out.insert(out.end(), found->begin(), found->end());
}

// Input: the corners of a face. Output: Newell's vector, and the angle at each corner.
void normal(RecordReader& in, Numbers& out) {
  std::vector<Point<Object>> face;
  while (in.more()) face.push_back(in.point<Point<Object>>());
  append_point(out, newell_vector(face));
  const auto side = [&](std::size_t from, std::size_t to) {
    const Point<Object>&a = face[from % face.size()], &b = face[to % face.size()];
    return Vector<Object, double>(double(b.x) - a.x, double(b.y) - a.y, double(b.z) - a.z);
  };
  const auto is_zero = [](const Vector<Object, double>& v) {
    return v.x == 0 && v.y == 0 && v.z == 0;
  };
  for (std::size_t i = 0; i < face.size(); ++i) {
    const auto on = side(i, i + 1), back = side(i, i + face.size() - 1);
    out.push_back(is_zero(on) || is_zero(back) ? 0 : angle_between(on, back));
  }
}

}  // namespace
}  // namespace lab_01

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  using namespace lab_01;
  return {{"read", read}, {"edges", edges}, {"turns", turns}, {"normal", normal}};
}
