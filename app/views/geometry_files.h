// Pair, matches and cameras from files.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "app/views/geometry_input.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

struct GeometryFiles {
  std::pair<std::string, std::string> pair;  // pictures; empty: none
  std::optional<std::string> matches, cameras;

  bool has_pair() const { return !pair.first.empty(); }
};

// The cameras of such a pair, from its file: those that are named as the pictures are. Where two have other names, left and right.
Result<std::array<views::PinholeCamera, 2>> read_pair_cameras(const GeometryFiles& files);

// Cameras as read_pair_cameras takes them. Refused: pictures of unequal sizes, and files that the
// readers of views/files refuse.
Result<GeometryInput> read_geometry_files(const GeometryFiles& files);

}  // namespace glassbox::app
