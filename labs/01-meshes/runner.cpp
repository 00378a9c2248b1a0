// Puts the cases of lab 1 to your functions.
#include <stdexcept>

#include "cases.h"
#include "labs/framework/runner.h"
#include "student.h"

namespace lab_01 {
namespace {

using glassbox::labs::Answer;
using glassbox::labs::RunnerCheck;

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

RunnerCheck read(const std::string& name, const std::vector<TextCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const TextCase& each = cases[std::size_t(index)];
            emit_mesh(read_mesh(each.good), answer);
            if (each.bad.empty()) return;
            double refused = 0;
            try {
              read_mesh(each.bad);
            } catch (const std::invalid_argument&) {
              refused = 1;
            }
            answer.emit("refused", {refused});
          }};
}

RunnerCheck edges(const std::string& name, const std::vector<MeshCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const EdgeTable table = find_edges(cases[std::size_t(index)].mesh);
            std::vector<double> rows;
            for (const Edge& edge : table.edges) {
              rows.insert(rows.end(), {double(edge.low), double(edge.high), double(edge.ascending),
                                       double(edge.descending)});
            }
            answer.emit("edges", rows);
            answer.emit("V - E + F", {double(table.euler)});
            answer.emit("closed", {table.closed ? 1.0 : 0.0});
          }};
}

RunnerCheck turn(const std::string& name, const std::vector<MeshCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const auto turns = faces_to_turn(cases[std::size_t(index)].mesh);
            if (turns) answer.emit("turned", {turns->begin(), turns->end()});
          }};
}

RunnerCheck sides(const std::string& name, const std::vector<SidesCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const SidesCase& each = cases[std::size_t(index)];
            answer.emit("of the one-sided", {faces_to_turn(each.one_sided) ? 1.0 : 0.0});
            answer.emit("of the two-sided", {faces_to_turn(each.two_sided) ? 1.0 : 0.0});
          }};
}

RunnerCheck newell(const std::string& name, const std::vector<PolygonCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const Vector<Object> m = newell_vector(cases[std::size_t(index)].corners);
            answer.emit("newell", {m.x, m.y, m.z});
          }};
}

RunnerCheck angle(const std::string& name, const std::vector<AngleCase>& cases) {
  return {name, int(cases.size()), [cases](int index, Answer& answer) {
            const AngleCase& each = cases[std::size_t(index)];
            answer.emit("angle", {angle_between(each.a, each.b)});
          }};
}

}  // namespace
}  // namespace lab_01

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_01;
  return {
      read("the tables are as the text says", texts()),
      edges("every edge is found, and who uses it", edge_meshes()),
      turn("faces are turned until all agree", turn_meshes()),
      sides("a surface with one side is told from one with two", one_sided_meshes()),
      newell("the normal has the length and the direction of the area", polygons()),
      newell("the normal is as good far away", far_polygons()),
      angle("angles between vectors", angles()),
      // BEGIN HIDDEN
      read("texts with mistakes and odd numbers", hidden_texts()),
      edges("tori, books and repeated corners", hidden_edge_meshes()),
      turn("meshes in several pieces", hidden_turn_meshes()),
      newell("polygons that are concave, bent or thin", hidden_polygons()),
      angle("angles near 0 and near half a turn", hidden_angles()),
      // END HIDDEN
  };
}
