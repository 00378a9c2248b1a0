// Promises that must hold for any input of a fuzz target. A broken one stops the program.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::fuzz {

inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "a promise is broken: %s\n", what);
  std::abort();
}

inline void check_error(const Error& error) {
  require(!error.cause.empty() && !error.remedy.empty(), "cause and remedy");
  require(error.message().find('\n') == std::string::npos, "one line");
}

// ---- scenes: what loaders guarantee (mesh/mesh.h), so that later stages need not check ----

template <class Table>
bool in_range_or_none(std::uint32_t index, const Table& table) {
  return index == kNone || index < table.size();
}

inline void check_corner(const Corner& corner, const Mesh& mesh) {
  require(corner.position < mesh.positions.size(), "position in range");
  require(in_range_or_none(corner.normal, mesh.normals), "normal in range");
  require(in_range_or_none(corner.texcoord, mesh.texcoords), "texture coordinate in range");
  require(in_range_or_none(corner.color, mesh.colors), "colour in range");
}

inline void check_indices(const Mesh& mesh) {
  for (const auto& face : mesh.faces) {
    require(face.count >= 3, "three corners");
    require(face.first <= mesh.corners.size() && face.count <= mesh.corners.size() - face.first,
            "face in range");
  }
  for (const auto& corner : mesh.corners) check_corner(corner, mesh);
  for (const auto& line : mesh.lines) {
    for (const auto& corner : line) check_corner(corner, mesh);
  }
  for (const auto& corner : mesh.points) check_corner(corner, mesh);
}

inline void check_mesh(const Mesh& mesh) {
  for (const auto& p : mesh.positions) {
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "finite position");
  }
  for (const auto& n : mesh.normals) {
    const double length = std::sqrt(double(n.x) * double(n.x) + double(n.y) * double(n.y) +
                                    double(n.z) * double(n.z));
    // Each component is rounded to float: it is off by at most half an ulp, 2^-25.
    require(std::abs(length - 1) < 0x1p-23, "unit normal");
  }
  for (const auto& t : mesh.texcoords) {
    require(std::isfinite(t.u) && std::isfinite(t.v), "finite texture coordinate");
  }
  for (const auto& c : mesh.colors) {
    for (const float channel : {c.r, c.g, c.b, c.a}) {
      require(channel >= 0 && channel <= 1, "colour in [0, 1]");
    }
  }
  check_indices(mesh);
}

// Requires a scene that check_scene accepts, or an error in one line that names a cause and a
// remedy.
template <class Check>
void check_loaded(const Result<Scene>& scene, const Check& check_scene) {
  if (scene) {
    check_scene(*scene);
  } else {
    check_error(scene.error());
  }
}

}  // namespace glassbox::fuzz
