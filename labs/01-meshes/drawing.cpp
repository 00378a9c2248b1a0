// Lab 1 in a picture: the student's functions read the scene's meshes from text, turn their faces
// so that neighbours agree, and give them normals. A surface that is not closed shows both its
// sides.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "labs/drawing/drawing.h"

#include <glassbox/base/rounding.h>
#include <glassbox/mesh/normals.h>
#include <glassbox/mesh/topology.h>

namespace glassbox::labs {

namespace lab_01_drawing {

// ---- tables as numbers ----

void append_tables(Numbers& out, const Mesh& mesh) {
  out.push_back(double(mesh.positions.size()));
  for (const auto& p : mesh.positions) append_point(out, p);
  for (const Face& face : mesh.faces) {
    out.push_back(double(face.count));
    for (std::uint32_t c = face.first; c < face.first + face.count; ++c)
      out.push_back(double(mesh.corners[c].position));
  }
}

// Makes a mesh from a student's numbers, which may have any values: a face is left out if it has
// fewer than three corners, or an index that no position has.
Mesh tables(const Numbers& numbers) {
  Mesh mesh;
  if (numbers.empty()) return mesh;
  RecordReader in(numbers.data(), numbers.size());
  const double count = std::clamp(in.number(), 0.0, double(numbers.size() / 3));
  for (double i = 0; i < count; ++i) {
    const auto p = in.point<Point<Object>>();
    mesh.positions.push_back({to_finite_float(p.x), to_finite_float(p.y), to_finite_float(p.z)});
  }
  while (in.more()) {
    const double corners = std::clamp(in.number(), 0.0, double(numbers.size()));
    const Face face{std::uint32_t(mesh.corners.size()), std::uint32_t(corners)};
    bool good = corners >= 3;
    for (double i = 0; i < corners && in.more(); ++i) {
      const double position = in.number();
      good = good && position >= 0 && position < count;
      mesh.corners.emplace_back();
      mesh.corners.back().position = good ? std::uint32_t(position) : 0;
    }
    good = good && mesh.corners.size() == face.first + face.count;
    if (good) {
      mesh.faces.push_back(face);
    } else {
      mesh.corners.resize(face.first);
    }
  }
  return mesh;
}

Mesh tables(RecordReader& in) {
  Numbers numbers;
  while (in.more()) numbers.push_back(in.number());
  return tables(numbers);
}

// Writes the mesh as text. Nine digits are enough to read the same floats again.
std::string text_of(const Mesh& mesh) {
  std::string text;
  for (const Point<Object>& p : mesh.positions)
    text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
  for (const Face& face : mesh.faces) {
    if (face.count < 3) continue;  // read_mesh refuses such faces
    text += "f";
    for (std::uint32_t c = face.first; c < face.first + face.count; ++c)
      text += fmt::format(" {}", mesh.corners[c].position + 1);
    text += "\n";
  }
  return text;
}

// ---- the reference ----

// The reference for read_mesh. It reads only what text_of() wrote, so it need not handle mistakes;
// nine digits give the same floats again.
Numbers read(RecordReader& in) {
  std::string text;
  while (in.more()) text += char(in.integer());
  Mesh mesh;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const char kind = text[at];
    const char* word = text.c_str() + at + 1;
    char* next = nullptr;
    if (kind == 'v') {
      const float x = std::strtof(word, &next), y = std::strtof(next, &next);
      mesh.positions.push_back({x, y, std::strtof(next, &next)});
    } else {
      mesh.faces.push_back({std::uint32_t(mesh.corners.size()), 0});
      while (*word == ' ') {
        mesh.corners.emplace_back();
        mesh.corners.back().position = std::uint32_t(std::strtoul(word, &next, 10) - 1);
        ++mesh.faces.back().count;
        word = next;
      }
    }
    at = end + 1;
  }
  Numbers out;
  append_tables(out, mesh);
  return out;
}

Numbers edges(RecordReader& in) {
  const Topology topology = find_topology(tables(in));
  Numbers out{double(topology.euler_characteristic()), topology.closed() ? 1.0 : 0.0};
  for (const Edge& edge : topology.edges) {
    int ascending = 0;
    for (std::uint32_t i = 0; i < edge.count; ++i)
      ascending += topology.uses[edge.first + i].ascending ? 1 : 0;
    out.insert(out.end(), {double(edge.low), double(edge.high), double(ascending),
                           double(int(edge.count) - ascending)});
  }
  return out;
}

// Decides which faces are turned, and passes the decisions across edges to neighbouring faces.
// Returns nothing if two paths lead to different decisions.
Numbers turns(RecordReader& in) {
  const Mesh mesh = tables(in);
  const Topology topology = find_topology(mesh);
  struct Neighbour {
    std::uint32_t face = 0;
    bool differ = false;
  };
  std::vector<std::vector<Neighbour>> neighbours(mesh.faces.size());
  for (const Edge& edge : topology.edges) {
    if (edge.count != 2) continue;
    const EdgeUse &a = topology.uses[edge.first], &b = topology.uses[edge.first + 1];
    neighbours[a.face].push_back({b.face, a.ascending == b.ascending});
    neighbours[b.face].push_back({a.face, a.ascending == b.ascending});
  }
  constexpr double kUnknown = -1;
  Numbers turned(mesh.faces.size(), kUnknown);
  for (std::uint32_t first = 0; first < turned.size(); ++first) {
    if (turned[first] != kUnknown) continue;
    turned[first] = 0;
    std::vector<std::uint32_t> waiting{first};
    while (!waiting.empty()) {
      const std::uint32_t face = waiting.back();
      waiting.pop_back();
      for (const Neighbour& next : neighbours[face]) {
        const double wanted = next.differ ? 1 - turned[face] : turned[face];
        if (turned[next.face] == kUnknown) {
          turned[next.face] = wanted;
          waiting.push_back(next.face);
        } else if (turned[next.face] != wanted) {
          return {};
        }
      }
    }
  }
  return turned;
}

std::vector<Point<Object, double>> corners_in(RecordReader& in) {
  std::vector<Point<Object, double>> corners;
  while (in.more()) corners.push_back(in.point<Point<Object, double>>());
  return corners;
}

Numbers normal(RecordReader& in) {
  const auto face = corners_in(in);
  Numbers out;
  append_point(out, newell_vector<double>(std::span(face)));
  for (std::size_t i = 0; i < face.size(); ++i) {
    const auto& here = face[i];
    out.push_back(glassbox::angle_between(face[(i + 1) % face.size()] - here,
                                          face[(i + face.size() - 1) % face.size()] - here));
  }
  return out;
}

// ---- judgement ----

std::optional<WrongNumber> judge_exactly(const Numbers& yours, const Numbers& reference,
                                         const std::function<std::string(std::size_t)>& name) {
  const auto nothing = [](std::size_t) { return 0; };
  return first_wrong(yours, reference, nothing, "", name);
}

std::optional<WrongNumber> judge_read(const Numbers&, const Numbers& yours,
                                      const Numbers& reference) {
  const auto positions = std::size_t(reference[0]);
  return judge_exactly(yours, reference, [&](std::size_t i) {
    if (i == 0) return std::string("how many positions");
    if (i <= 3 * positions) return fmt::format("position {}, {}", (i - 1) / 3, "xyz"[(i - 1) % 3]);
    std::size_t face = 0, at = 1 + 3 * positions;
    while (at < reference.size() && at + std::size_t(reference[at]) < i)
      at += 1 + std::size_t(reference[at]), ++face;
    return i == at ? fmt::format("face {}, how many corners", face)
                   : fmt::format("face {}, corner {}", face, i - at - 1);
  });
}

std::optional<WrongNumber> judge_edges(const Numbers&, const Numbers& yours,
                                       const Numbers& reference) {
  return judge_exactly(yours, reference, [](std::size_t i) {
    static const char* const kNames[] = {"low", "high", "ascending", "descending"};
    if (i < 2) return std::string(i == 0 ? "V - E + F" : "closed");
    return fmt::format("edge {}, {}", (i - 2) / 4, kNames[(i - 2) % 4]);
  });
}

std::optional<WrongNumber> judge_turns(const Numbers&, const Numbers& yours,
                                       const Numbers& reference) {
  return judge_exactly(yours, reference,
                       [](std::size_t i) { return fmt::format("face {}: turned", i); });
}

// The bounds: gamma(N + 4) 4 N L^2 for Newell's vector of N corners (L: the largest coordinate
// difference from the first corner); 16 u (1 + angle) for an angle (u: the unit roundoff of
// double). student.h allows 16 u times the angle if the products are exact; those of a scene's
// sides are not, which adds 16 u.
std::optional<WrongNumber> judge_normal(const Numbers& in, const Numbers& yours,
                                        const Numbers& reference) {
  RecordReader reader(in.data(), in.size());
  const auto face = corners_in(reader);
  double longest = 0;
  for (const auto& p : face) {
    const auto d = p - face.front();
    longest = std::max({longest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  const int n = int(face.size());
  const double bound = gamma<float>(n + 4) * 4 * n * longest * longest;
  return first_wrong(
      yours, reference,
      [&](std::size_t i) {
        return i < 3 ? bound : 16 * unit_roundoff<double> * (1 + reference[i]);
      },
      "",
      [](std::size_t i) {
        return i < 3 ? fmt::format("Newell's vector, {}", "xyz"[i])
                     : fmt::format("the angle at corner {}, radian", i - 3);
      });
}

// ---- in the scene ----

// The beginning of the text that read_mesh gets.
std::string restated_text(const Numbers& in) {
  constexpr std::size_t kShown = 200;  // characters
  std::string text;
  for (std::size_t i = 0; i < std::min(in.size(), kShown); ++i)
    text += in[i] == '\n' ? std::string(" / ") : std::string(1, char(in[i]));
  return "the text \"" + text + (in.size() > kShown ? "...\"" : "\"");
}

const std::vector<DrawnStage>& stages() {
  static const auto tables_in_words =
      in_words({{"position", 3, kCounted}, {"face", kCounted, kAllThatFollow}});
  static const std::vector<DrawnStage> all{
      {"read", "object", "read_mesh", read, judge_read, restated_text},
      {"edges", "object", "find_edges", edges, judge_edges, tables_in_words},
      {"turns", "object", "faces_to_turn", turns, judge_turns, tables_in_words},
      {"normal", "object", "newell_vector, angle_between", normal, judge_normal,
       in_words({{"corner", 3, kAllThatFollow}})}};
  return all;
}

// Whether faces_to_turn is made for the mesh: no edge of more than two faces, no face that repeats
// a position.
bool can_be_turned(const Mesh& mesh) {
  for (const Face& face : mesh.faces) {
    std::vector<std::uint32_t> used;
    for (std::uint32_t c = face.first; c < face.first + face.count; ++c)
      used.push_back(mesh.corners[c].position);
    std::sort(used.begin(), used.end());
    if (std::adjacent_find(used.begin(), used.end()) != used.end()) return false;
  }
  return find_topology(mesh).non_manifold_edges == 0;
}

void turn_faces(Mesh& mesh, const Numbers& turned) {
  for (std::size_t f = 0; f < mesh.faces.size() && f < turned.size(); ++f) {
    const Face& face = mesh.faces[f];
    const auto first = mesh.corners.begin() + std::ptrdiff_t(face.first);
    if (turned[f] == 1) std::reverse(first, first + std::ptrdiff_t(face.count));
  }
}

Normal<Object> unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {float(v.x / length), float(v.y / length), float(v.z / length)};
}

// Gives each face its own normal or, if `smooth`, each position the sum of the unit normals of its
// faces, each weighted by the face's angle at the position.
void give_normals(Mesh& mesh, std::span<const Numbers> answers, bool smooth) {
  std::vector<glm::dvec3> sums(smooth ? mesh.positions.size() : 0, glm::dvec3(0));
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Face& face = mesh.faces[f];
    Numbers answer = answers[f];
    answer.resize(3 + face.count);
    const Normal<Object> normal = unit({answer[0], answer[1], answer[2]});
    for (std::uint32_t i = 0; i < face.count; ++i) {
      Corner& corner = mesh.corners[face.first + i];
      corner.normal = smooth ? corner.position : std::uint32_t(f);
      if (smooth && std::isfinite(answer[3 + i]))
        sums[corner.position] += glm::dvec3(normal.x, normal.y, normal.z) * answer[3 + i];
    }
    if (!smooth) mesh.normals.push_back(normal);
  }
  for (const glm::dvec3& sum : sums) mesh.normals.push_back(unit(sum));
}

std::vector<Question> face_questions(const Mesh& mesh) {
  std::vector<Question> questions;
  for (const Face& face : mesh.faces) {
    Question question;
    for (std::uint32_t c = face.first; c < face.first + face.count; ++c)
      append_point(question.numbers, mesh.positions[mesh.corners[c].position]);
    questions.push_back(std::move(question));
  }
  return questions;
}

Question tables_question(const Mesh& mesh) {
  Question question;
  append_tables(question.numbers, mesh);
  return question;
}

// The mesh as the student's functions make it; `closed` becomes their answer to whether the mesh is
// closed.
Result<Mesh> made_mesh(const Mesh& given, bool smooth, AnswerSource& answer_source, bool& closed) {
  const std::string text = text_of(given);
  const Question written{Numbers(text.begin(), text.end())};
  const auto answer = answer_source.ask(stages()[0], std::array{written});
  if (!answer) return tl::unexpected(answer.error());
  Mesh mesh = tables(answer->front());
  mesh.name = given.name;
  mesh.material = given.material;

  const auto found = answer_source.ask(stages()[1], std::array{tables_question(mesh)});
  if (!found) return tl::unexpected(found.error());
  closed = found->front().size() > 1 && found->front()[1] == 1;
  if (can_be_turned(mesh)) {
    const auto turned = answer_source.ask(stages()[2], std::array{tables_question(mesh)});
    if (!turned) return tl::unexpected(turned.error());
    turn_faces(mesh, turned->front());
  }
  const auto normals = answer_source.ask(stages()[3], face_questions(mesh));
  if (!normals) return tl::unexpected(normals.error());
  give_normals(mesh, *normals, smooth);
  return mesh;
}

Result<PictureSetup> draw(const DrawingInput& input, AnswerSource& answer_source) {
  PictureSetup made{input.scene, input.view, input.settings, nullptr, {}};
  // For flat shading each face gets its own normal.
  const bool flat = input.settings.shading == Shading::kFlat;
  if (flat) made.settings.shading = Shading::kPhong;
  for (Mesh& mesh : made.scene.meshes) {
    if (mesh.faces.empty()) continue;
    bool closed = false;
    auto read = made_mesh(mesh, !flat && !mesh.normals.empty(), answer_source, closed);
    if (!read) return tl::unexpected(read.error());
    mesh = std::move(*read);
    Material material = made.scene.materials[mesh.material];
    material.double_sided = material.double_sided || !closed;
    material.texture.reset();
    material.emission_texture.reset();
    mesh.material = std::uint32_t(made.scene.materials.size());
    made.scene.materials.push_back(std::move(material));
  }
  return made;
}

}  // namespace lab_01_drawing

LabDrawing drawing_01() {
  using namespace lab_01_drawing;
  return {stages(), draw, ""};
}

}  // namespace glassbox::labs
