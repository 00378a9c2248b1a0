// Calls your functions with the cases of lab 1.
#include <stdexcept>

#include "generators.h"
#include "labs/framework/runner.h"
#include "student.h"

namespace lab_01 {
namespace {

using glassbox::labs::Answer;

void emit_mesh(const Mesh& mesh, Answer& answer) {
  std::vector<double> positions, faces;
  for (const Point<Object>& p : mesh.positions)
    positions.insert(positions.end(), {double(p.x), double(p.y), double(p.z)});
  for (const glassbox::Face& face : mesh.faces) {
    faces.push_back(face.count);
    for (std::uint32_t c = face.first; c < face.first + face.count; ++c)
      faces.push_back(c < mesh.corners.size() ? double(mesh.corners[c].position) : -1);
  }
  answer.emit("positions", positions);
  answer.emit("faces", faces);
}

void ask_read(const TextCase& input, Answer& answer) {
  emit_mesh(read_mesh(input.good), answer);
  if (input.bad.empty()) return;
  double refused = 0;
  try {
    read_mesh(input.bad);
  } catch (const std::invalid_argument&) {
    refused = 1;
  }
  answer.emit("refused", {refused});
}

// How much of a mesh should be empty, or kNone, but is not.
double further_entries(const Mesh& mesh) {
  std::size_t further = mesh.name.size() + mesh.normals.size() + mesh.texcoords.size() +
                        mesh.colors.size() + mesh.lines.size() + mesh.points.size();
  for (const glassbox::Corner& corner : mesh.corners)
    further += corner.normal != glassbox::kNone || corner.texcoord != glassbox::kNone ||
                       corner.color != glassbox::kNone
                   ? 1
                   : 0;
  return double(further);
}

void ask_any_text(const AnyText& input, Answer& answer) {
  Mesh mesh;
  double refused = 0;
  try {
    mesh = read_mesh(input.text);
  } catch (const std::invalid_argument&) {
    refused = 1;
  }
  answer.emit("refused", {refused});
  if (refused == 1) return;
  emit_mesh(mesh, answer);
  answer.emit("corners in the table", {double(mesh.corners.size())});
  answer.emit("further entries", {further_entries(mesh)});
}

void ask_edges(const MeshCase& input, Answer& answer) {
  const EdgeTable table = find_edges(input.mesh);
  std::vector<double> rows;
  for (const Edge& edge : table.edges) {
    rows.insert(rows.end(), {double(edge.low), double(edge.high), double(edge.ascending),
                             double(edge.descending)});
  }
  answer.emit("edges", rows);
  answer.emit("V - E + F", {double(table.euler)});
  answer.emit("closed", {table.closed ? 1.0 : 0.0});
}

// Also says whether there is an answer, since there may be none.
void ask_turn(const MeshCase& input, Answer& answer) {
  const auto turns = faces_to_turn(input.mesh);
  answer.emit("there is an answer", {turns ? 1.0 : 0.0});
  if (turns) answer.emit("turned", {turns->begin(), turns->end()});
}

void ask_sides(const SidesCase& input, Answer& answer) {
  answer.emit("answer for the mesh with one side", {faces_to_turn(input.one_sided) ? 1.0 : 0.0});
  answer.emit("answer for the mesh with two sides", {faces_to_turn(input.two_sided) ? 1.0 : 0.0});
}

void ask_newell(const PolygonCase& input, Answer& answer) {
  const Vector<Object> m = newell_vector(input.corners);
  answer.emit("newell", {m.x, m.y, m.z});
}

void ask_angle(const AngleCase& input, Answer& answer) {
  answer.emit("angle", {angle_between(input.a, input.b)});
}

}  // namespace
}  // namespace lab_01

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_01;
  return {
      check("the tables are as the text says", texts(), ask_read),
      check("every edge is found, and who uses it", edge_meshes(), ask_edges),
      check("faces are turned until all agree", turn_meshes(), ask_turn),
      check("a surface with one side is told from one with two", one_sided_meshes(), ask_sides),
      check("the normal has the length and the direction of the area", polygons(), ask_newell),
      check("the normal is as good far away", far_polygons(), ask_newell),
      check("angles between vectors", angles(), ask_angle),
      generated_check("any text", generated_texts(), ask_any_text),
      generated_check("any mesh", generated_meshes(), ask_edges),
      generated_check("any surface", generated_surfaces(), ask_turn),
      generated_check("any polygon", generated_polygons(), ask_newell),
      generated_check("any two vectors", generated_angles(), ask_angle),
      // BEGIN HIDDEN
      check("texts with mistakes and odd numbers", hidden_texts(), ask_read),
      check("tori, books and repeated corners", hidden_edge_meshes(), ask_edges),
      check("meshes in several pieces", hidden_turn_meshes(), ask_turn),
      check("polygons that are concave, bent or thin", hidden_polygons(), ask_newell),
      check("angles near 0 and near half a turn", hidden_angles(), ask_angle),
      // END HIDDEN
  };
}
