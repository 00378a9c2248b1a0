// How much each view contributes to a polygon that is seen by another eye (S1-40, D-24).
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "views/texture/view_sphere.h"

namespace glassbox::views {

enum class Blend {
  kNearest,      // only the nearest view
  kBarycentric,  // the three views around the direction
  // The k views with the smallest angles: unstructured lumigraph rendering (Buehler, Bosse,
  // McMillan, Gortler and Cohen 2001).
  kNeighbours,
};
std::string_view name_of(Blend blend);

inline constexpr int kMaxNeighbours = 16;

class ViewBlend {
public:
  // Directions are unit vectors from the object's middle. `neighbours`, 1 to kMaxNeighbours, is
  // used by kNeighbours.
  ViewBlend(Blend blend, std::vector<Vector3d> directions, int neighbours = 4);

  std::size_t views() const { return directions_.size(); }
  const ViewSphere& sphere() const { return sphere_; }

  // The weights for everything that is seen from one direction, given which views see a polygon.
  // They are positive and sum to 1; there are none if no view sees the polygon. With kBarycentric,
  // the weights of views that do not see the polygon are removed, and the remaining weights are
  // divided by their sum; if none remains, the nearest view that sees the polygon has all the
  // weight.
  class FromDirection {
  public:
    FromDirection(const ViewBlend& blend, const Vector3d& direction);
    ViewWeights weights(const std::function<bool(std::size_t view)>& sees) const;

  private:
    const ViewBlend& blend_;
    ViewWeights around_;  // barycentric weights of the three views around the direction
    // All views, nearest first; equally near ones in their order.
    std::vector<std::size_t> nearest_;
    std::vector<double> angles_;  // between the direction and each view; radians
  };
  FromDirection from_direction(const Vector3d& direction) const { return {*this, direction}; }

private:
  Blend blend_;
  std::vector<Vector3d> directions_;
  ViewSphere sphere_;
  std::size_t neighbours_;
};

}  // namespace glassbox::views
