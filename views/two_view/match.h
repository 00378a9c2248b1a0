// A match: one point seen in two pictures.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace glassbox::views {

struct Match {
  // In pixels, or calibrated: on the plane at distance 1 from the camera.
  Eigen::Vector2d left, right;
};

using Matches = std::vector<Match>;

}  // namespace glassbox::views
