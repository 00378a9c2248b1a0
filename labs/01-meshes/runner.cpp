// Calls your functions with the cases of lab 1.
#include <stdexcept>

#include "cases.h"
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

void ask_turn(const MeshCase& input, Answer& answer) {
  const auto turns = faces_to_turn(input.mesh);
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
      // BEGIN HIDDEN
      check("texts with mistakes and odd numbers", hidden_texts(), ask_read),
      check("tori, books and repeated corners", hidden_edge_meshes(), ask_edges),
      check("meshes in several pieces", hidden_turn_meshes(), ask_turn),
      check("polygons that are concave, bent or thin", hidden_polygons(), ask_newell),
      check("angles near 0 and near half a turn", hidden_angles(), ask_angle),
      // END HIDDEN
  };
}
