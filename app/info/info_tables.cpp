#include "app/info/info_tables.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/number_json.h"
#include "cli/report/table.h"
#include "cli/report/text_layout.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/base/trig.h>
#include <glassbox/mesh/neighbours.h>
#include <glassbox/mesh/newell_sums.h>
#include <glassbox/mesh/normals.h>
#include <glassbox/mesh/topology.h>

namespace glassbox::app {

namespace {

using TablesJson = nlohmann::ordered_json;
using Vec = Vector<Object, double>;

constexpr std::size_t kTextList = 8;     // numbers of a list in a line of text
constexpr std::size_t kJsonList = 1000;  // numbers of a list in JSON
// Newell's sums of a face with so few corners are never cut, because only the last row is a result.
constexpr std::size_t kWholeFace = 12;

// A mesh with what its tables are made from. Positions at the same place are one vertex, which has
// the lowest number of its positions.
struct TabledMesh {
  explicit TabledMesh(const Mesh& shown)
      : mesh(shown),
        topology(find_topology(shown, Weld::kByCoordinates)),
        neighbours(find_neighbours(shown, topology)) {
    for (std::uint32_t i = 0; i < shown.positions.size(); ++i) {
      if (topology.vertex_of_position[i] == i) vertices.push_back(i);
    }
  }

  std::uint32_t vertex(const Face& face, std::uint32_t i) const {
    return topology.vertex_of_position[mesh.corners[face.first + i % face.count].position];
  }
  std::span<const EdgeUse> uses(const Edge& edge) const {
    return std::span(topology.uses).subspan(edge.first, edge.count);
  }

  const Mesh& mesh;
  Topology topology;
  Neighbours neighbours;
  std::vector<std::uint32_t> vertices;
};

// What a modeller should know about an edge; empty for an edge between two faces that are wound in
// the same way.
std::string name_of_edge(const TabledMesh& tables, const Edge& edge) {
  if (edge.boundary()) return "boundary";
  if (edge.non_manifold()) return fmt::format("non-manifold: {} faces", edge.count);
  const auto uses = tables.uses(edge);
  return uses[0].ascending == uses[1].ascending ? "the winding changes" : "";
}

// The normal of a face in two ways, as vectors whose length is twice an area.
struct FaceNormals {
  std::vector<NewellRow> rows;
  Vec newell{0, 0, 0};  // by the sums in `rows`
  // The product of the first two edges, (V2 - V1) x (V3 - V2); none for fewer than three corners.
  std::optional<Vec> cross_product;
  std::string difference;  // why the two have other directions; empty if they agree
};

double length_of(const Vec& v) {
  return std::sqrt(dot(v, v));
}

// An angle below this is due to rounding, in degrees: corners are floats, so a flat face's corners
// are off its plane by 2^-24 of their coordinates.
constexpr double kSameDegrees = 1e-3;

std::string difference_of(const FaceNormals& normals, std::uint32_t corners) {
  if (!normals.cross_product) return "fewer than three corners";
  const bool has_area = length_of(normals.newell) > length_of(newell_error_bound(normals.rows));
  const bool is_turned = length_of(*normals.cross_product) > 0;
  if (!has_area) return is_turned && corners > 3 ? "the face has no area" : "no area, no normal";
  if (!is_turned) return "the first three corners are on a line";
  const double degrees =
      degrees_from_radians(angle_between(*normals.cross_product, normals.newell));
  if (degrees > 90) return "the second corner is reflex: the product points to the back";
  if (degrees > kSameDegrees) return fmt::format("{:.3g} deg apart: the face is bent", degrees);
  return "";
}

FaceNormals normals_of(const Mesh& mesh, const Face& face) {
  FaceNormals normals;
  normals.rows = newell_rows(mesh, face);
  if (!normals.rows.empty()) normals.newell = normals.rows.back().sums;
  if (face.count >= 3) {
    const auto corner = [&](std::uint32_t i) {
      const Point<Object>& p = mesh.positions[mesh.corners[face.first + i].position];
      return Point<Object, double>(p.x, p.y, p.z);
    };
    normals.cross_product = three_point_normal(corner(0), corner(1), corner(2));
  }
  normals.difference = difference_of(normals, face.count);
  return normals;
}

// ---- text ----

// "f0 f1 f2", or "f0 f1 ... (998 more)".
std::string list_text(char letter, std::span<const std::uint32_t> numbers) {
  std::string text;
  for (std::size_t i = 0; i < std::min(numbers.size(), kTextList); ++i)
    text += fmt::format("{}{}{}", i == 0 ? "" : " ", letter, numbers[i]);
  if (numbers.size() > kTextList) text += fmt::format(" (+{})", numbers.size() - kTextList);
  return text;
}

std::string vector_text(const Vec& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x + 0.0, v.y + 0.0, v.z + 0.0);
}

// A table of the first rows, with a line for those that are left out.
template <class MakeRow>
std::string section(const std::string& title, const Row& head, std::size_t count, std::size_t rows,
                    std::size_t left, const MakeRow& make_row) {
  std::string text = fmt::format("  {}\n", title);
  const std::size_t shown = std::min(count, rows);
  std::vector<Row> lines{head};
  for (std::size_t i = 0; i < shown; ++i) lines.push_back(make_row(i));
  if (shown > 0) text += table(lines, left);
  if (shown < count) text += fmt::format("    ... {} more (--rows)\n", count - shown);
  return text;
}

Row vertex_row(const TabledMesh& tables, std::size_t i) {
  const std::uint32_t vertex = tables.vertices[i];
  const Point<Object>& p = tables.mesh.positions[vertex];
  const auto faces = tables.neighbours.faces_of_vertex[vertex];
  return {fmt::format("v{}", vertex),
          fmt::format("{}", p.x + 0.0f),
          fmt::format("{}", p.y + 0.0f),
          fmt::format("{}", p.z + 0.0f),
          faces.empty() ? "none" : list_text('f', faces),
          list_text('e', tables.neighbours.edges_of_vertex[vertex])};
}

// The faces that pass from the edge's first vertex to the second one, and those that pass back.
Row edge_row(const TabledMesh& tables, std::size_t i) {
  const Edge& edge = tables.topology.edges[i];
  std::vector<std::uint32_t> there, back;
  for (const EdgeUse& use : tables.uses(edge)) (use.ascending ? there : back).push_back(use.face);
  return {fmt::format("e{}", i), fmt::format("v{} v{}", edge.low, edge.high), list_text('f', there),
          list_text('f', back), name_of_edge(tables, edge)};
}

std::vector<std::uint32_t> corners_of(const TabledMesh& tables, const Face& face) {
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < face.count; ++i) corners.push_back(tables.vertex(face, i));
  return corners;
}

Row face_row(const TabledMesh& tables, std::uint32_t i) {
  const auto edges = tables.neighbours.edges_of_face[i];
  return {fmt::format("f{}", i), list_text('v', corners_of(tables, tables.mesh.faces[i])),
          edges.empty() ? "none: fewer than three different vertices" : list_text('e', edges),
          list_text('f', faces_beside(tables.topology, tables.neighbours, i))};
}

Row normal_row(const TabledMesh& tables, std::uint32_t i) {
  const FaceNormals normals = normals_of(tables.mesh, tables.mesh.faces[i]);
  const auto unit = unit_normal(normals.newell);
  return {fmt::format("f{}", i), normals.cross_product ? vector_text(*normals.cross_product) : "-",
          vector_text(normals.newell), unit ? vector_text({unit->x, unit->y, unit->z}) : "-",
          normals.difference};
}

std::string sums_text(const TabledMesh& tables, std::uint32_t number, std::size_t rows) {
  const Face& face = tables.mesh.faces[number];
  const std::vector<NewellRow> sums = newell_rows(tables.mesh, face);
  const auto row = [&](std::size_t i) {
    const auto corner = std::uint32_t(i);
    Row words{
        fmt::format("  v{} v{}", tables.vertex(face, corner), tables.vertex(face, corner + 1))};
    for (const Vec& v : {sums[i].terms, sums[i].sums}) {
      for (const double value : {v.x, v.y, v.z})
        words.push_back(fmt::format("{:.6g}", value + 0.0));
    }
    return words;
  };
  return section(fmt::format("  f{}", number),
                 {"  i j", "dy (z+z)", "dz (x+x)", "dx (y+y)", "Nx", "Ny", "Nz"}, sums.size(),
                 std::max(rows, kWholeFace), 1, row);
}

std::string mesh_tables_text(const Mesh& mesh, std::size_t number, std::size_t rows) {
  const TabledMesh tables(mesh);
  const Topology& topology = tables.topology;
  std::string text = fmt::format("\nmesh {} '{}'\n", number, printable(mesh.name));
  text += section(fmt::format("{} ({}; those in one place are one vertex)",
                              counted(tables.vertices.size(), "vertex", "vertices"),
                              counted(mesh.positions.size(), "position")),
                  {"", "x", "y", "z", "faces", "edges"}, tables.vertices.size(), rows, 6,
                  [&](std::size_t i) { return vertex_row(tables, i); });
  text += section(fmt::format("{}: {} boundary, {} non-manifold, {} where the winding changes",
                              counted(topology.edges.size(), "edge"), topology.boundary_edges,
                              topology.non_manifold_edges, topology.inconsistent_edges),
                  {"", "from to", "passed by", "passed back by", "named"}, topology.edges.size(),
                  rows, 5, [&](std::size_t i) { return edge_row(tables, i); });
  const auto with_number = [&](const auto& make) {
    return [&](std::size_t i) { return make(tables, std::uint32_t(i)); };
  };
  text += section(counted(mesh.faces.size(), "face"), {"", "vertices", "edges", "faces beside"},
                  mesh.faces.size(), rows, 4, with_number(face_row));
  if (mesh.faces.empty()) return text;
  text += section(
      "normals, not of unit length: the product of the first two edges, "
      "(V2 - V1) x (V3 - V2); Newell's sums",
      {"", "product", "Newell", "unit", "named"}, mesh.faces.size(), rows, 5,
      with_number(normal_row));
  text +=
      "  Newell's sums: Nx = sum (y_i - y_j)(z_i + z_j), Ny = sum (z_i - z_j)(x_i + x_j),\n"
      "  Nz = sum (x_i - x_j)(y_i + y_j), where j is the corner after i\n";
  const std::size_t shown = std::min(rows, mesh.faces.size());
  for (std::uint32_t i = 0; i < shown; ++i) text += sums_text(tables, i, rows);
  if (shown < mesh.faces.size())
    text += fmt::format("    ... {} more (--rows)\n", counted(mesh.faces.size() - shown, "face"));
  return text;
}

// ---- JSON ----

// Adds a list of numbers under a name, and how many are left out if it is long.
void add_list(TablesJson& json, const std::string& name, std::span<const std::uint32_t> numbers) {
  const auto shown = numbers.first(std::min(numbers.size(), kJsonList));
  json[name] = std::vector<std::uint32_t>(shown.begin(), shown.end());
  if (shown.size() < numbers.size()) json[name + "_left_out"] = numbers.size() - shown.size();
}

// Adds a table of the first rows, and how many are left out.
template <class MakeRow>
void add_table(TablesJson& json, const std::string& name, std::size_t count, std::size_t rows,
               const MakeRow& make_row) {
  TablesJson table = TablesJson::array();
  const std::size_t shown = std::min(count, rows);
  for (std::size_t i = 0; i < shown; ++i) table.push_back(make_row(i));
  json[name] = std::move(table);
  json[name + "_left_out"] = count - shown;
}

TablesJson vertex_json(const TabledMesh& tables, std::size_t i) {
  const std::uint32_t vertex = tables.vertices[i];
  TablesJson json{{"vertex", vertex}, {"position", numbers_json(tables.mesh.positions[vertex])}};
  add_list(json, "faces", tables.neighbours.faces_of_vertex[vertex]);
  add_list(json, "edges", tables.neighbours.edges_of_vertex[vertex]);
  return json;
}

TablesJson edge_json(const TabledMesh& tables, std::size_t i) {
  const Edge& edge = tables.topology.edges[i];
  TablesJson json{{"edge", i}, {"vertices", {edge.low, edge.high}}};
  std::vector<std::uint32_t> there, back;
  for (const EdgeUse& use : tables.uses(edge)) (use.ascending ? there : back).push_back(use.face);
  add_list(json, "passed_by", there);
  add_list(json, "passed_back_by", back);
  json["boundary"] = edge.boundary();
  json["non_manifold"] = edge.non_manifold();
  json["named"] = name_of_edge(tables, edge);
  return json;
}

TablesJson face_json(const TabledMesh& tables, std::size_t i, std::size_t rows) {
  const Face& face = tables.mesh.faces[i];
  TablesJson json{{"face", i}};
  add_list(json, "vertices", corners_of(tables, face));
  add_list(json, "edges", tables.neighbours.edges_of_face[i]);
  add_list(json, "faces_beside",
           faces_beside(tables.topology, tables.neighbours, std::uint32_t(i)));
  const FaceNormals normals = normals_of(tables.mesh, face);
  json["product"] =
      normals.cross_product ? numbers_json(*normals.cross_product) : TablesJson(nullptr);
  json["newell"] = numbers_json(normals.newell);
  const auto unit = unit_normal(normals.newell);
  json["unit"] = unit ? numbers_json(*unit) : TablesJson(nullptr);
  json["named"] = normals.difference;
  json["newell_error_bound"] = numbers_json(newell_error_bound(normals.rows));
  json["newell_from_first_corner"] = numbers_json(newell_vector(tables.mesh, face));
  add_table(json, "newell_rows", normals.rows.size(), std::max(rows, kWholeFace),
            [&](std::size_t k) {
              return TablesJson{{"terms", numbers_json(normals.rows[k].terms)},
                                {"sums", numbers_json(normals.rows[k].sums)}};
            });
  return json;
}

}  // namespace

std::string tables_text(const Scene& scene, std::size_t rows) {
  std::string text;
  const std::size_t shown = std::min(rows, scene.meshes.size());
  for (std::size_t i = 0; i < shown; ++i) text += mesh_tables_text(scene.meshes[i], i, rows);
  if (shown < scene.meshes.size())
    text += fmt::format("\n... {} more (--rows)\n",
                        counted(scene.meshes.size() - shown, "mesh", "meshes"));
  return text;
}

nlohmann::ordered_json tables_json(const Mesh& mesh, std::size_t rows) {
  const TabledMesh tables(mesh);
  TablesJson json;
  add_table(json, "vertices", tables.vertices.size(), rows,
            [&](std::size_t i) { return vertex_json(tables, i); });
  add_table(json, "edges", tables.topology.edges.size(), rows,
            [&](std::size_t i) { return edge_json(tables, i); });
  add_table(json, "faces", mesh.faces.size(), rows,
            [&](std::size_t i) { return face_json(tables, i, rows); });
  return json;
}

}  // namespace glassbox::app
