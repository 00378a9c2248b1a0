// Reads the pictures, matches and cameras of a pair from files.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "views/commands/geometry_input.h"

#include <glassbox/base/error.h>

namespace glassbox::views {

struct GeometryFiles {
  std::pair<std::string, std::string> pair;  // the pictures; empty: none
  std::optional<std::string> matches, cameras;

  bool has_pair() const { return !pair.first.empty(); }
};

// The cameras of a pair from its file: those with the names of the pictures. If there are two
// cameras with other names, they are left and right.
Result<std::array<views::PinholeCamera, 2>> read_pair_cameras(const GeometryFiles& files);

// Reads a pair, with the cameras as in read_pair_cameras. Errors: pictures of different sizes, and
// files that the readers of views/files refuse.
Result<GeometryInput> read_geometry_files(const GeometryFiles& files);

}  // namespace glassbox::views
