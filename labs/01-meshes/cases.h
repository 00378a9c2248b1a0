// The inputs of lab 1's test cases: for the runner, which calls the student's functions, and for
// the checks, which compute the expected answers.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_01 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

// ---- texts (task 1.1): one that is well-formed, and the same with a mistake ----

struct TextCase {
  const char* what;
  std::string good, bad;  // if `bad` is empty, only the good text is read
};

inline std::vector<TextCase> texts() {
  const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
  return {
      {"the five vertices and three triangles of the slide (S4.34)",
       "v 0 0 0\nv 1 0 0\nv 0.5 1 0\nv 1.5 1.25 0\nv 1 2 0.5\nf 1 2 3\nf 3 2 4\nf 3 4 5\n", ""},
      {"a quad and a triangle, with comments and spaces",
       "# a house\n  v 0 0 0 # left\nv 2 0 0\n\nv 2 2 0\nv 0 2 0\nf  1 2   3 4  # the wall\nv 1 3 "
       "0\nf 4 3 5\n",
       ""},
      {"negative numbers, which are counted back from the last position",
       "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0.25\nf -4 -2 -1\n", ""},
      {"comments that contain corners and positions",
       "v 0 0 0 # 1\n# v 9 9 9\nv 1 0 0\nv 1 1 0 # 2\nv 0 1 0\nf 1 2 3 # 4\n#f 1 2 4\nf 1 3 4 #\n",
       ""},
      {"a corner that names position 0", tetrahedron + "f 2 3 4\n", tetrahedron + "f 2 3 0\n"},
  };
}

// BEGIN HIDDEN
inline std::vector<TextCase> hidden_texts() {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  return {
      {"a face that names a position before it is read", square + "v 2 2 2\nf 1 2 3 5\n",
       square + "f 1 2 3 5\nv 2 2 2\n"},
      {"a face of two corners", square + "f 1 2 4\n", square + "f 1 2\n"},
      {"a negative number that goes back before the first position", square + "f -4 -3 -2 -1\n",
       square + "f -5 -3 -2 -1\n"},
      {"a position of two numbers", square + "f 1 2 3\n", "v 0 0\n" + square + "f 1 2 3\n"},
      {"a position of one number", square + "f 1 2 3\n", square + "f 1 2 3\nv 7\n"},
      {"exponents, signs and many corners",
       "v 1e3 -2.5E-2 +4\nv -1e3 0 4\nv 0 1e-3 4\nv .5 -7 4\nv 5. -70 4\nf 1 2 3 4 5\n", ""},
  };
}
// END HIDDEN

// ---- meshes (tasks 1.2 and 1.3) ----

struct MeshCase {
  const char* what;
  Mesh mesh;
};

// A mesh of the given faces. The positions are on a spiral: any will do, since only their indices
// are tested.
inline Mesh mesh_of(std::size_t positions, const std::vector<std::vector<std::uint32_t>>& faces) {
  Mesh mesh;
  for (std::size_t i = 0; i < positions; ++i)
    mesh.positions.emplace_back(float(i % 7), float(i % 5), float(i));
  for (const auto& face : faces) {
    mesh.faces.push_back({std::uint32_t(mesh.corners.size()), std::uint32_t(face.size())});
    for (const std::uint32_t position : face) {
      glassbox::Corner corner;
      corner.position = position;
      mesh.corners.push_back(corner);
    }
  }
  return mesh;
}

inline Mesh cube() {
  return mesh_of(
      8, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

// Quads around a tube, whose ends are open, or joined (a torus).
enum class Ends { kOpen, kJoined };
inline Mesh torus(std::uint32_t around, std::uint32_t along, Ends ends) {
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t j = 0; j < (ends == Ends::kJoined ? along : along - 1); ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t k = (i + 1) % around, l = (j + 1) % along;
      faces.push_back({j * around + i, j * around + k, l * around + k, l * around + i});
    }
  }
  return mesh_of(std::size_t(around) * along, faces);
}

// A strip of quads whose ends are joined, either straight (a ring) or with half a turn (a Moebius
// strip, which has one side).
inline Mesh strip(std::uint32_t length, bool half_turn) {
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < length; ++i) {
    const std::uint32_t a = 2 * i, b = a + 1;
    std::uint32_t c = (b + 2) % (2 * length), d = (a + 2) % (2 * length);
    if (i + 1 == length && half_turn) std::swap(c, d);
    faces.push_back({a, b, c, d});
  }
  return mesh_of(2 * std::size_t(length), faces);
}

// The mesh with the corners of some of its faces in reverse order.
inline Mesh turned(Mesh mesh, const std::vector<std::size_t>& faces) {
  for (const std::size_t f : faces) {
    const glassbox::Face& face = mesh.faces[f];
    for (std::uint32_t i = 0; i < face.count / 2; ++i)
      std::swap(mesh.corners[face.first + i], mesh.corners[face.first + face.count - 1 - i]);
  }
  return mesh;
}

inline Mesh both(const Mesh& a, const Mesh& b) {
  Mesh mesh = a;
  for (const glassbox::Face& face : b.faces)
    mesh.faces.push_back({face.first + std::uint32_t(a.corners.size()), face.count});
  for (glassbox::Corner corner : b.corners) {
    corner.position += std::uint32_t(a.positions.size());
    mesh.corners.push_back(corner);
  }
  mesh.positions.insert(mesh.positions.end(), b.positions.begin(), b.positions.end());
  return mesh;
}

inline std::vector<MeshCase> edge_meshes() {
  return {
      {"the three triangles of the slide (S4.34)", mesh_of(5, {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}})},
      {"a tetrahedron", mesh_of(4, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})},
      {"a cube of quads", cube()},
      {"a tube, open at both ends", torus(5, 3, Ends::kOpen)},
      {"a tetrahedron with one face twice, so that three edges have three faces",
       mesh_of(4, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {1, 2, 3}})},
  };
}

// BEGIN HIDDEN
inline std::vector<MeshCase> hidden_edge_meshes() {
  return glassbox::labs::with_varied(
      std::vector<MeshCase>{
          {"a torus: V - E + F = 0", torus(5, 4, Ends::kJoined)},
          {"two cubes apart", both(cube(), cube())},
          {"three triangles that share one edge", mesh_of(5, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}})},
          {"a cube with one face of the wrong winding", turned(cube(), {3})},
          {"two tetrahedra that share an edge of four faces", mesh_of(6, {{0, 2, 1},
                                                                          {0, 1, 3},
                                                                          {0, 3, 2},
                                                                          {1, 2, 3},
                                                                          {0, 4, 1},
                                                                          {0, 1, 5},
                                                                          {0, 5, 4},
                                                                          {1, 4, 5}})},
          {"a face that visits one position twice", mesh_of(5, {{0, 1, 2, 0, 3, 4}})},
          {"only faces with fewer than three positions, so that the mesh is not closed",
           mesh_of(3, {{0, 0, 1}, {2, 2, 2}})},
          {"repeated corners, and faces of fewer than three positions (C-25)",
           mesh_of(7, {{0, 1, 1, 2}, {2, 1, 3, 2}, {3, 4, 3}, {4, 4, 4}, {5, 6, 5, 6}})},
      },
      11, 2, [](glassbox::Random& random) {
        const auto around = std::uint32_t(random.integer(3, 7)),
                   along = std::uint32_t(random.integer(3, 6));
        std::vector<std::size_t> faces;
        for (std::size_t f = 1; f < std::size_t(around) * along; ++f) {
          if (random.integer(0, 2) == 0) faces.push_back(f);
        }
        return MeshCase{"a torus with some faces turned round",
                        turned(torus(around, along, Ends::kJoined), faces)};
      });
}
// END HIDDEN

inline std::vector<MeshCase> turn_meshes() {
  return {
      {"two triangles, the second with the wrong winding", mesh_of(4, {{0, 1, 2}, {1, 2, 3}})},
      {"a cube with two faces turned", turned(cube(), {1, 4})},
      {"a tube with every third face turned round",
       turned(torus(6, 4, Ends::kOpen), {2, 5, 8, 11, 14, 17})},
  };
}

// BEGIN HIDDEN
inline std::vector<MeshCase> hidden_turn_meshes() {
  return glassbox::labs::with_varied(
      std::vector<MeshCase>{
          {"a torus with all faces turned round except the first",
           turned(torus(4, 3, Ends::kJoined), {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})},
          {"two separate cubes, each with some faces turned round",
           turned(both(cube(), cube()), {2, 3, 5, 7, 11})},
          {"triangles that touch only in a point, so that no face has to be turned round",
           mesh_of(5, {{0, 1, 2}, {2, 4, 3}})},
      },
      12, 2, [](glassbox::Random& random) {
        const auto around = std::uint32_t(random.integer(3, 7)),
                   along = std::uint32_t(random.integer(3, 6));
        std::vector<std::size_t> faces;
        for (std::size_t f = 1; f < std::size_t(around) * along; ++f) {
          if (random.integer(0, 2) == 0) faces.push_back(f);
        }
        return MeshCase{"a torus with some faces turned round",
                        turned(torus(around, along, Ends::kJoined), faces)};
      });
}
// END HIDDEN

// A surface with one side, and a similar one that has two.
struct SidesCase {
  const char* what;
  Mesh one_sided, two_sided;
};
inline std::vector<SidesCase> one_sided_meshes() {
  return {{"a Moebius strip, and a ring", strip(5, true), strip(5, false)},
          {"a Moebius strip and a ring, with some faces turned round",
           turned(strip(8, true), {1, 2}), turned(strip(8, false), {3})}};
}

// ---- polygons (task 1.4) ----

struct PolygonCase {
  const char* what;
  std::vector<Point<Object>> corners;
};

// Corners in a tilted plane, (x, y, x/2 + y/4), moved by `at`. The coordinates have few binary
// digits, so everything is exact in float.
inline std::vector<Point<Object>> tilted(const std::vector<std::pair<float, float>>& outline,
                                         const Point<Object>& at = {0, 0, 0}) {
  std::vector<Point<Object>> corners;
  for (const auto& [x, y] : outline) corners.emplace_back(at.x + x, at.y + y, at.z + x / 2 + y / 4);
  return corners;
}

inline std::vector<std::pair<float, float>> octagon() {
  std::vector<std::pair<float, float>> corners;
  for (int i = 0; i < 8;
       ++i) {  // constants, because the cosines of libraries differ in their last bits
    constexpr float kLong = 0.9238795f, kShort = 0.3826834f;
    const float x[] = {kLong, kShort, -kShort, -kLong, -kLong, -kShort, kShort, kLong};
    const float y[] = {kShort, kLong, kLong, kShort, -kShort, -kLong, -kLong, -kShort};
    corners.emplace_back(x[i], y[i]);
  }
  return corners;
}

inline std::vector<PolygonCase> polygons() {
  return {
      {"a triangle", tilted({{0, 0}, {2, 0}, {0, 3}})},
      {"a square whose list of corners begins at the corner (1, 1)",
       tilted({{1, 1}, {0, 1}, {0, 0}, {1, 0}})},
      {"an arrow whose second corner is reflex (C-23)", tilted({{0, 3}, {1, 0}, {0, -3}, {4, 0}})},
      {"a polygon whose first three corners are on a line (C-21)",
       tilted({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}})},
      {"an octagon", tilted(octagon())},
      {"a bow-tie with wings of different sizes, whose areas are subtracted (C-24)",
       tilted({{0, 0}, {3, 3}, {3, 0}, {0, 2}})},
  };
}

inline std::vector<PolygonCase> far_polygons() {
  return {
      {"the octagon moved by 100", tilted(octagon(), {100, 70, -90})},
      {"the octagon moved by 10^4 (C-22)", tilted(octagon(), {10000, -9000, 8000})},
      {"the octagon moved by 10^6 (C-22)", tilted(octagon(), {1000000, 900000, -800000})},
  };
}

// BEGIN HIDDEN
inline std::vector<PolygonCase> hidden_polygons() {
  return glassbox::labs::with_varied(
      std::vector<PolygonCase>{
          {"an L", tilted({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}})},
          {"a quad with one corner off the plane of the others (C-26)",
           {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5f}, {0, 1, 0}}},
          {"corners repeated (C-25)", tilted({{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 2}})},
          {"a triangle whose three corners are in one place (C-25)",
           {{3, 0.1f, -7}, {3, 0.1f, -7}, {3, 0.1f, -7}}},
          {"a sliver, far away",
           tilted({{0, 0}, {1, 0.0625f}, {2, 0.1875f}, {1, 0.125f}}, {50000, -30000, 20000})},
      },
      13, 3, [](glassbox::Random& random) {
        const auto in = [&](int low, int high) { return float(random.integer(low, high)); };
        const float width = in(1, 9), height = in(1, 9), x = in(-9, 9), y = in(-99, 99);
        return PolygonCase{"a triangle of any shape", tilted({{0, 0}, {width, 0}, {x, height}},
                                                             {y, in(-99, 99), in(-99, 99)})};
      });
}
// END HIDDEN

// ---- pairs of vectors (task 1.5) ----

struct AngleCase {
  const char* what;
  Vector<Object, double> a, b;
};

inline std::vector<AngleCase> angles() {
  return {
      {"a right angle", {1, 2, 2}, {2, 1, -2}},
      {"an acute one", {1, 0, 0}, {3, 4, 0}},
      {"an obtuse one", {1, 2, 3}, {-3, 1, -2}},
      {"a thousandth of a radian (C-04)", {1000, 0, 0}, {1000, 1, 0}},
  };
}

// BEGIN HIDDEN
inline std::vector<AngleCase> hidden_angles() {
  return glassbox::labs::with_varied(
      std::vector<AngleCase>{
          {"5e-8 radians (C-04)", {30000001, 7, 3}, {30000000, 8, 3}},
          {"almost opposite", {1048573, 3, 1}, {-1048571, -2, 0}},
          {"small and slanted", {100001, 200002, 300003}, {100000, 200003, 300003}},
          {"opposite", {1, -2, 5}, {-3, 6, -15}},
      },
      14, 3, [](glassbox::Random& random) {
        for (;;) {
          double v[6];
          for (double& each : v) each = double(random.integer(-9, 9));
          const Vector<Object, double> a{v[0], v[1], v[2]}, b{v[3], v[4], v[5]};
          const auto across = cross(a, b);
          if (dot(across, across) > 0) return AngleCase{"whole numbers", a, b};
        }
      });
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_01
