// The generated inputs of lab 1: of all kinds that student.h names and of the borders between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "cases.h"
#include "labs/framework/bezout.h"
#include "labs/framework/choices.h"

namespace lab_01 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

// ---- texts (task 1.1) ----

// A text, and what it was made from.
struct AnyText {
  const char* what;
  std::string text;
  std::vector<std::string> numbers;  // the coordinates of all positions, as they are written
  std::vector<double> faces;         // for each face: how many corners, and their positions from 0
  bool refused = false;              // one line of the text is wrong
};

inline std::string digits(Choices& c, std::uint64_t count) {
  std::string text;
  for (std::uint64_t i = 0; i < count; ++i) text += char('0' + c.below(10));
  return text;
}

// A number in one of the ways in which C++ reads and writes them.
inline std::string any_number(Choices& c) {
  const std::string sign = c.one_of({"", "-", "+"});
  switch (c.below(5)) {
    case 0:
      return sign + std::to_string(c.below(10));
    case 1: {
      const std::string whole = digits(c, c.below(4)), rest = digits(c, c.below(8));
      return sign + (whole.empty() && rest.empty() ? "0" : whole + "." + rest);
    }
    case 2: {  // with an exponent: from the smallest floats, which become 0, to the largest
      const std::uint64_t first = 1 + c.below(9);
      const std::string number = std::to_string(first) + "." + digits(c, c.below(12));
      const std::string letter = c.one_of({"e", "E"});
      return sign + number + letter + std::to_string(c.integer(-48, 37));
    }
    case 3: {  // halfway between two floats, which are even numbers from 2^24 on, or a little above
      const std::uint64_t odd = (1u << 24) + 2 * c.below(1u << 23) + 1;
      return sign + std::to_string(odd) + c.one_of({"", ".0", ".00000000000000000001"});
    }
    default: {  // a little below halfway
      const std::uint64_t even = (1u << 24) + 2 * c.below(1u << 23);
      return sign + std::to_string(even) + ".99999999999999999999";
    }
  }
}

inline std::string space(Choices& c) {
  return std::string(1 + c.below(3), ' ');
}

// What may stand before and after the words of a line.
inline std::string indented(Choices& c, const std::string& words) {
  const std::string before(c.below(3), ' ');
  const std::string after = c.one_of({"", " ", "#", " # 1 2 3", "  #f 1", "# v 0 0 0 # 4"});
  return before + words + after + "\n";
}

// A corner's number, counted from the first position or back from the last one.
inline std::string number_of(Choices& c, std::int64_t position, std::int64_t count) {
  return std::to_string(c.flag() ? position - count : position + 1);
}

inline void add_position(Choices& c, AnyText& made) {
  std::string line = "v";
  for (int i = 0; i < 3; ++i) {
    made.numbers.push_back(any_number(c));
    line += space(c) + made.numbers.back();
  }
  made.text += indented(c, line);
}

inline void add_face(Choices& c, AnyText& made) {
  const auto count = std::int64_t(made.numbers.size() / 3);
  const std::uint64_t corners = 3 + c.below(5);
  made.faces.push_back(double(corners));
  std::string line = "f";
  for (std::uint64_t i = 0; i < corners; ++i) {
    const std::int64_t position = c.integer(0, count - 1);
    made.faces.push_back(double(position));
    line += space(c);
    line += number_of(c, position, count);
  }
  made.text += indented(c, line);
}

inline void add_line(Choices& c, AnyText& made) {
  const std::uint64_t kind = c.below(8);
  if (kind == 7) {
    made.text += indented(c, "");
  } else if (kind < 4 || made.numbers.empty()) {
    add_position(c, made);
  } else {
    add_face(c, made);
  }
}

// A line that must be refused.
inline std::string wrong_line(Choices& c, std::int64_t count) {
  const std::uint64_t kind = c.below(4);
  if (kind == 0) {  // a position of fewer than three numbers; the rest may be in a comment
    std::string line = "v";
    const std::uint64_t numbers = c.below(3);
    for (std::uint64_t i = 0; i < numbers; ++i) {
      line += space(c);
      line += any_number(c);
    }
    return line + c.one_of({"", "#1 2 3", " # 4 5 6"});
  }
  if (kind == 1) {  // a face of fewer than three corners
    std::string line = "f";
    const std::uint64_t corners = count == 0 ? 0 : c.below(3);
    for (std::uint64_t i = 0; i < corners; ++i) {
      line += space(c);
      line += number_of(c, c.integer(0, count - 1), count);
    }
    return line + c.one_of({"", "#1 1 1", " # 1 1 1"});
  }
  // A face of which one corner names no position: a number just beyond the ends, or one whose last
  // 32 bits would name the first or the last position, or the largest one, 2^62 - 1.
  const std::uint64_t corners = 3 + c.below(3), wrong = c.below(corners);
  std::string line = "f";
  for (std::uint64_t i = 0; i < corners; ++i) {
    line += space(c);
    if (i != wrong && count > 0) {
      line += number_of(c, c.integer(0, count - 1), count);
    } else if (kind == 2) {
      line += c.one_of({std::string("0"), std::to_string(count + 1), std::to_string(-count - 1)});
    } else {
      line += c.one_of({"1000", "-1000", "4294967297", "-4294967297", "4611686018427387903",
                        "-4611686018427387903"});
    }
  }
  return line;
}

inline AnyText any_text(Choices& c, bool refused) {
  AnyText made{"a text", "", {}, {}, refused};
  const std::uint64_t before = c.below(9);
  for (std::uint64_t i = 0; i < before; ++i) add_line(c, made);
  if (refused) made.text += wrong_line(c, std::int64_t(made.numbers.size() / 3)) + "\n";
  const std::uint64_t after = c.below(4);
  for (std::uint64_t i = 0; i < after; ++i) add_line(c, made);
  if (c.flag() && !made.text.empty()) made.text.pop_back();  // the last line may have no end
  return made;
}

inline std::vector<InputClass<AnyText>> generated_texts() {
  return {{"texts of all kinds of lines", 8'000, [](Choices& c) { return any_text(c, false); }},
          {"texts with a wrong line", 8'000, [](Choices& c) { return any_text(c, true); }}};
}

// ---- meshes (tasks 1.2 and 1.3) ----

using Faces = std::vector<std::vector<std::uint32_t>>;

// The mesh with the given faces. In the table of corners they are in this order, or in the opposite
// one with corners between them that belong to no face.
inline Mesh laid_out(Choices& c, std::size_t positions, Faces faces) {
  if (!c.flag()) return mesh_of(positions, faces);
  std::reverse(faces.begin(), faces.end());
  Faces apart;
  for (const auto& face : faces) {
    apart.push_back({0});
    apart.push_back(face);
  }
  const Mesh with_gaps = mesh_of(positions, apart);
  Mesh mesh = with_gaps;
  mesh.faces.clear();
  for (std::size_t f = with_gaps.faces.size(); f > 0; f -= 2)
    mesh.faces.push_back(with_gaps.faces[f - 1]);
  return mesh;
}

// Faces that repeat positions, share edges and meet in any way.
inline MeshCase any_mesh(Choices& c) {
  const std::uint64_t positions = 1 + c.below(7), count = c.below(6);
  Faces faces(count);
  for (auto& face : faces) {
    const std::uint64_t corners = c.below(8);
    for (std::uint64_t i = 0; i < corners; ++i) face.push_back(std::uint32_t(c.below(positions)));
  }
  return {"a mesh", laid_out(c, positions, faces)};
}

// More positions than 16 bits can count, and than 100,000: a number made of two of theirs must have
// more than 32 bits to be that of one edge only.
inline MeshCase many_positions(Choices& c) {
  constexpr std::uint32_t kPositions = 120'000;
  Faces faces(1 + c.below(5));
  for (auto& face : faces) {
    const std::uint64_t corners = 3 + c.below(3);
    for (std::uint64_t i = 0; i < corners; ++i)
      face.push_back(c.one_of({0u, 1u, 2u, 3u, 65535u, 65536u, 65537u, 65538u, 99'999u, 100'000u,
                               100'001u, 100'002u, 100'003u, kPositions - 1}));
  }
  return {"a mesh of many positions", mesh_of(kPositions, faces)};
}

inline Mesh some_turned(Choices& c, const Mesh& mesh) {
  std::vector<std::size_t> faces;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (c.flag()) faces.push_back(f);
  }
  return turned(mesh, faces);
}

// Tubes, tori, cubes, and strips with one side or two; some of their faces are turned round.
inline Mesh one_piece(Choices& c) {
  const std::uint64_t kind = c.below(5);
  const auto around = std::uint32_t(3 + c.below(3)), along = std::uint32_t(3 + c.below(2));
  return some_turned(c, kind == 0   ? cube()
                        : kind == 1 ? torus(around, along, Ends::kOpen)
                        : kind == 2 ? torus(around, along, Ends::kJoined)
                                    : strip(around, kind == 3));
}
inline MeshCase pieces(Choices& c) {
  const Mesh first = one_piece(c);
  if (!c.flag()) return {"one piece", first};
  const Mesh second = one_piece(c);
  return {"two pieces", both(first, second)};
}

// Polygons among few positions; no edge belongs to more than two of them: surfaces of any kind.
inline MeshCase any_surface(Choices& c) {
  const std::uint64_t positions = 3 + c.below(6), tries = c.below(11);
  int uses[8][8] = {};
  Faces faces;
  for (std::uint64_t k = 0; k < tries; ++k) {
    std::vector<std::uint32_t> order(positions);
    std::iota(order.begin(), order.end(), 0u);
    const std::uint64_t corners = std::min<std::uint64_t>(3 + c.below(3), positions);
    for (std::uint64_t i = 0; i < corners; ++i)
      std::swap(order[i], order[i + c.below(positions - i)]);
    order.resize(corners);
    const auto use = [&](int by) {
      bool allowed = true;
      for (std::uint64_t i = 0; i < corners; ++i) {
        const auto [low, high] = std::minmax(order[i], order[(i + 1) % corners]);
        uses[low][high] += by;
        allowed = allowed && uses[low][high] <= 2;
      }
      return allowed;
    };
    if (use(1)) {
      faces.push_back(order);
    } else {
      use(-1);
    }
  }
  return {"a surface", laid_out(c, positions, faces)};
}

inline std::vector<InputClass<MeshCase>> generated_meshes() {
  return {{"few positions, faces of no corner and more", 15'000, any_mesh},
          {"surfaces of all kinds", 8'000, any_surface},
          {"tubes, tori, cubes and strips", 2'000, pieces},
          {"120,000 positions", 60, many_positions}};
}

inline std::vector<InputClass<MeshCase>> generated_surfaces() {
  return {{"surfaces of all kinds, with one side or two", 20'000, any_surface},
          {"tubes, tori, cubes and strips, alone and two of them", 4'000, pieces}};
}

// ---- polygons (task 1.4) ----

// `count` corners, (a + d) 2^-`down`: a is the same for all and has up to 22 binary digits, d up to
// `bits`, so that every coordinate is a float.
inline PolygonCase a_polygon(Choices& c, std::uint64_t count, int bits, int down) {
  std::int64_t a[3];
  for (std::int64_t& each : a) each = c.sized(22);
  PolygonCase made{"a polygon", {}};
  for (std::uint64_t i = 0; i < count; ++i) {
    float p[3];
    for (int k = 0; k < 3; ++k) p[k] = std::ldexp(float(a[k] + c.sized(bits)), -down);
    made.corners.emplace_back(p[0], p[1], p[2]);
  }
  return made;
}

// Corners on a line, there and back again: no area.
inline PolygonCase flat_polygon(Choices& c) {
  const PolygonCase two = a_polygon(c, 2, 8, 3);
  const Point<Object> p = two.corners[0];
  const Vector<Object> d = two.corners[1] - p;
  const std::uint64_t count = 3 + c.below(4);
  PolygonCase made{"corners on a line", {}};
  for (std::uint64_t i = 0; i < count; ++i) made.corners.push_back(p + d * float(c.integer(-4, 4)));
  return made;
}

inline std::vector<InputClass<PolygonCase>> generated_polygons() {
  return {{"small polygons, near and far from the origin (C-22)", 15'000,
           [](Choices& c) {
             const std::uint64_t count = 3 + c.below(5);
             return a_polygon(c, count, 2, 3);
           }},
          {"polygons of every size and at every place (C-22, C-23)", 20'000,
           [](Choices& c) {
             const std::uint64_t count = 3 + c.below(5);
             const auto bits = int(c.below(22)), down = int(c.integer(3, 50));
             return a_polygon(c, count, bits, down);
           }},
          {"corners on a line (C-21)", 5'000, flat_polygon},
          {"all corners in one place (C-25)", 2'000,
           [](Choices& c) {
             const PolygonCase one = a_polygon(c, 1, 20, int(c.integer(3, 50)));
             const std::uint64_t count = 3 + c.below(5);
             return PolygonCase{"one place", std::vector<Point<Object>>(count, one.corners[0])};
           }},
          {"polygons of up to 100 corners", 1'000, [](Choices& c) {
             const std::uint64_t count = 3 + c.below(98);
             return a_polygon(c, count, 10, 3);
           }}};
}

// ---- pairs of vectors (task 1.5) ----

inline constexpr std::int64_t kLargest = std::int64_t(1) << 25;

inline Vector<Object, double> whole_vector(const std::int64_t (&v)[3]) {
  const auto at = [&](int i) { return double(std::clamp(v[i], -kLargest, kLargest)); };
  if (v[0] == 0 && v[1] == 0 && v[2] == 0) return {1, 0, 0};
  return {at(0), at(1), at(2)};
}

inline AngleCase any_angle(Choices& c, int bits) {
  std::int64_t a[3], b[3];
  for (std::int64_t& each : a) each = c.sized(bits);
  for (std::int64_t& each : b) each = c.sized(bits);
  return {"an angle", whole_vector(a), whole_vector(b)};
}

// Vectors that are nearly the same, or nearly opposite, or a multiple of each other.
inline AngleCase small_angle(Choices& c) {
  std::int64_t a[3], b[3];
  const std::int64_t times = c.one_of({1, -1, 2, -2, 3});
  for (std::int64_t& each : a) each = c.sized(23);
  for (std::size_t i = 0; i < 3; ++i) b[i] = times * a[i] + c.integer(-2, 2);
  return {"a small angle", whole_vector(a), whole_vector(b)};
}

// Two vectors in a coordinate plane with the smallest angle that their sizes allow: the cross
// product is the greatest common divisor of the first one's components.
inline AngleCase smallest_angle(Choices& c) {
  const std::int64_t x = c.sized(23), y = c.sized(23);
  const auto [u, v] = glassbox::labs::bezout(x, y);
  const std::int64_t sign = c.flag() ? -1 : 1;
  const std::size_t i = c.below(3), j = (i + 1) % 3;
  std::int64_t a[3] = {}, b[3] = {};
  a[i] = x, a[j] = y;
  b[i] = sign * (x - v), b[j] = sign * (y + u);
  return {"a very small angle", whole_vector(a), whole_vector(b)};
}

inline std::vector<InputClass<AngleCase>> generated_angles() {
  return {{"small whole numbers", 15'000, [](Choices& c) { return any_angle(c, 2); }},
          {"vectors of every size", 15'000, [](Choices& c) { return any_angle(c, 25); }},
          {"nearly the same and nearly opposite (C-04)", 15'000, small_angle},
          {"the smallest angles that whole numbers allow (C-04)", 15'000, smallest_angle}};
}

}  // namespace inputs
}  // namespace lab_01
