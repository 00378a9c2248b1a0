// A match: one point seen in two pictures.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace glassbox::views {

struct Match {
  Eigen::Vector2d left, right;  // pixels, or on the plane at distance 1 (calibrated)
};

using Matches = std::vector<Match>;

}  // namespace glassbox::views
