// The expected answers of lab 1, computed by the program's own reader, topology and Newell sums in
// double.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>
#include <glassbox/mesh/normals.h>
#include <glassbox/mesh/obj/parse.h>
#include <glassbox/mesh/topology.h>

#include "labs/01-meshes/generators.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

using namespace lab_01;

// ---- tables ----

Case expect_tables(const TextCase& input) {
  Case c{input.what, "the text is\n" + input.good, {}};
  obj::Warnings warnings;
  const auto tables = obj::parse_obj(input.good, LoadLimits{}, warnings);
  if (!tables) return c;  // the tests make sure that every text can be read
  std::vector<double> positions, faces;
  for (const auto& p : tables->positions) positions.insert(positions.end(), {p.x, p.y, p.z});
  for (const obj::Element& element : tables->elements) {
    faces.push_back(element.count);
    for (std::uint32_t i = 0; i < element.count; ++i)
      faces.push_back(tables->references[element.first + i].position);
  }
  c.expected = {polygon("positions", 3, positions, 0, "object units"), numbers("faces", faces)};
  if (!input.bad.empty()) {
    c.restated += "\nthis text must be refused:\n" + input.bad;
    c.expected.push_back(numbers("refused", {1}));
  }
  return c;
}

// What is expected of a generated text. The C library reads the numbers: it rounds to the nearest
// float.
std::vector<Expected> tables_of(const AnyText& input) {
  if (input.refused) return {numbers("refused", {1})};
  std::vector<double> positions;
  for (const std::string& number : input.numbers)
    positions.push_back(double(std::strtof(number.c_str(), nullptr)));
  double corners = 0;
  for (std::size_t i = 0; i < input.faces.size(); i += 1 + std::size_t(input.faces[i]))
    corners += input.faces[i];
  return {numbers("refused", {0}), polygon("positions", 3, positions, 0, "object units"),
          numbers("faces", input.faces), numbers("corners in the table", {corners}),
          numbers("further entries", {0})};
}

Case expect_any_text(const AnyText& input) {
  return {input.what,
          (input.refused ? "this text must be refused (1):\n" : "the text is\n") + input.text +
              "\n\"further entries\" counts what should be empty or kNone, but is not",
          tables_of(input)};
}

bool right_text(const AnyText& input, const Answer& answer) {
  return has_fields(answer, tables_of(input));
}

// ---- adjacency ----

std::string face_text(const Mesh& mesh) {
  std::string text = "faces";
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Face& face = mesh.faces[f];
    text += fmt::format("{} {}: (", f == 0 ? "" : ",", f);
    for (std::uint32_t i = 0; i < face.count; ++i)
      text += fmt::format("{}{}", i == 0 ? "" : " ", mesh.corners[face.first + i].position);
    text += ")";
  }
  return text;
}

std::vector<Expected> edges_of(const Mesh& mesh) {
  const Topology topology = find_topology(mesh);
  std::vector<double> rows;
  for (const glassbox::Edge& edge : topology.edges) {
    int ascending = 0;
    for (std::uint32_t i = 0; i < edge.count; ++i)
      ascending += topology.uses[edge.first + i].ascending ? 1 : 0;
    rows.insert(rows.end(), {double(edge.low), double(edge.high), double(ascending),
                             double(int(edge.count) - ascending)});
  }
  return {matrix("edges", 4, rows), numbers("V - E + F", {double(topology.euler_characteristic())}),
          numbers("closed", {topology.closed() ? 1.0 : 0.0})};
}

Case expect_edges(const MeshCase& input) {
  return {input.what,
          face_text(input.mesh) +
              "; each row: lower position, higher position, how often faces pass from low to high, "
              "and from high to low",
          edges_of(input.mesh)};
}

bool right_edges(const MeshCase& input, const Answer& answer) {
  return has_fields(answer, edges_of(input.mesh));
}

// Which faces must be turned. The first face of each connected group is not turned; the decisions
// are passed across edges to neighbouring faces until every face has one.
std::vector<double> turns_of(const Mesh& mesh) {
  const Topology topology = find_topology(mesh);
  constexpr double kUnknown = -1;
  std::vector<double> turns(mesh.faces.size(), kUnknown);
  for (double& first : turns) {
    if (first != kUnknown) continue;
    first = 0;
    for (bool changed = true; changed;) {
      changed = false;
      for (const glassbox::Edge& edge : topology.edges) {
        if (edge.count != 2) continue;
        const EdgeUse &a = topology.uses[edge.first], &b = topology.uses[edge.first + 1];
        const double differ = a.ascending == b.ascending ? 1 : 0;
        double &ta = turns[a.face], &tb = turns[b.face];
        if ((ta == kUnknown) == (tb == kUnknown)) continue;
        (ta == kUnknown ? ta : tb) = std::abs((ta == kUnknown ? tb : ta) - differ);
        changed = true;
      }
    }
  }
  return turns;
}

Case expect_turns(const MeshCase& input) {
  return {input.what, face_text(input.mesh), {numbers("turned", turns_of(input.mesh))}};
}

// Whether there is an answer, and which: the turns must be right at every edge of two faces.
std::vector<Expected> any_turns_of(const Mesh& mesh) {
  const std::vector<double> turns = turns_of(mesh);
  const Topology topology = find_topology(mesh);
  for (const glassbox::Edge& edge : topology.edges) {
    if (edge.count != 2) continue;
    const EdgeUse &a = topology.uses[edge.first], &b = topology.uses[edge.first + 1];
    if ((a.ascending == b.ascending) == (turns[a.face] == turns[b.face]))
      return {numbers("there is an answer", {0})};
  }
  return {numbers("there is an answer", {1}), numbers("turned", turns)};
}

Case expect_any_turns(const MeshCase& input) {
  return {input.what, face_text(input.mesh) + "; 1: an answer, 0: std::nullopt",
          any_turns_of(input.mesh)};
}

bool right_turns(const MeshCase& input, const Answer& answer) {
  return has_fields(answer, any_turns_of(input.mesh));
}

Case expect_sides(const SidesCase& input) {
  return {input.what,
          "one-sided mesh: " + face_text(input.one_sided) + "; 1: an answer, 0: std::nullopt",
          {numbers("answer for the mesh with one side", {0}),
           numbers("answer for the mesh with two sides", {1})}};
}

// ---- normals ----

std::vector<Expected> newell_of(const PolygonCase& input) {
  std::vector<Point<Object, double>> corners;
  double longest = 0;
  for (const Point<Object>& p : input.corners) {
    corners.emplace_back(p.x, p.y, p.z);
    const Vector<Object, double> d = corners.back() - corners.front();
    longest = std::max({longest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  // In double the differences of floats and their products are exact; the rounding errors of the
  // sums are only 2^-29 of the bound.
  const auto m = newell_vector<double>(std::span<const Point<Object, double>>(corners));
  // The student measures the N corners from the first one; L is the largest coordinate then,
  // u = 2^-24 the unit roundoff. The differences and sums of two coordinates in Newell's formula
  // are at most 2 L and have errors of 4 u L: u L from each coordinate, 2 u L from their own
  // rounding. A product of two is at most 4 L^2, with a relative error of 2 u + 2 u + u = 5 u.
  // N - 1 additions of N products follow, so the error is at most gamma(N + 4) times 4 N L^2.
  const int n = int(corners.size());
  const double bound = gamma<float>(n + 4) * 4 * n * longest * longest;
  return {point("newell", {m.x, m.y, m.z}, bound, "object units squared")};
}

Case expect_newell(const PolygonCase& input) {
  std::string text = "corners";
  for (const Point<Object>& p : input.corners) text += fmt::format(" ({}, {}, {})", p.x, p.y, p.z);
  return {input.what, text, newell_of(input)};
}

bool right_newell(const PolygonCase& input, const Answer& answer) {
  return has_fields(answer, newell_of(input));
}

// The components of the cross product and the dot product are exact in double, so only the square,
// the root and the arctangent round; in long double, which has 11 binary digits more on most
// processors, their errors do not matter.
std::vector<Expected> angle_of(const AngleCase& input) {
  using Long = long double;
  const Vector<Object, double> across = cross(input.a, input.b);
  const Vector<Object, Long> v{across.x, across.y, across.z};
  const auto angle = double(std::atan2(std::sqrt(dot(v, v)), Long(dot(input.a, input.b))));
  // u is the unit roundoff. With square, sum, root, quotient and arctangent the errors add up to
  // 8 u in the student's angle. The bound is twice that, as student.h says: it leaves room for
  // other formulas, and for our own rounding.
  return {numbers("angle", {angle}, 16 * unit_roundoff<double> * angle, "radian")};
}

Case expect_angle(const AngleCase& input) {
  return {input.what,
          fmt::format("a = ({}, {}, {}), b = ({}, {}, {})", input.a.x, input.a.y, input.a.z,
                      input.b.x, input.b.y, input.b.z),
          angle_of(input)};
}

bool right_angle(const AngleCase& input, const Answer& answer) {
  return has_fields(answer, angle_of(input));
}

}  // namespace

Lab lab_01() {
  return {
      1,
      "01-meshes",
      "Meshes: tables, adjacency, normals",
      {{"1.1", "Read a vertex table and a face table", 20},
       {"1.2", "Find the edges", 25},
       {"1.3", "Turn all faces the same way round", 20},
       {"1.4", "Newell's normal", 25},
       {"1.5", "The angle between two vectors", 10}},
      {check("the tables are as the text says", "1.1", "object", texts, expect_tables),
       generated_check("any text", "1.1", "object", generated_texts, expect_any_text, right_text),
       hidden_check("texts with mistakes and odd numbers", "1.1", "object", hidden_texts,
                    expect_tables),
       check("every edge is found, and who uses it", "1.2", "object", edge_meshes, expect_edges),
       generated_check("any mesh", "1.2", "object", generated_meshes, expect_edges, right_edges),
       hidden_check("tori, books and repeated corners", "1.2", "object", hidden_edge_meshes,
                    expect_edges),
       check("faces are turned until all agree", "1.3", "object", turn_meshes, expect_turns),
       check("a surface with one side is told from one with two", "1.3", "object", one_sided_meshes,
             expect_sides),
       generated_check("any surface", "1.3", "object", generated_surfaces, expect_any_turns,
                       right_turns),
       hidden_check("meshes in several pieces", "1.3", "object", hidden_turn_meshes, expect_turns),
       check("the normal has the length and the direction of the area", "1.4", "object", polygons,
             expect_newell),
       check("the normal is as good far away", "1.4", "object", far_polygons, expect_newell),
       generated_check("any polygon", "1.4", "object", generated_polygons, expect_newell,
                       right_newell),
       hidden_check("polygons that are concave, bent or thin", "1.4", "object", hidden_polygons,
                    expect_newell),
       check("angles between vectors", "1.5", "object", angles, expect_angle),
       generated_check("any two vectors", "1.5", "object", generated_angles, expect_angle,
                       right_angle),
       hidden_check("angles near 0 and near half a turn", "1.5", "object", hidden_angles,
                    expect_angle)}};
}

}  // namespace glassbox::labs
