// How much each view has to say of a polygon, from another eye (S1-40, D-24).
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "views/texture/view_sphere.h"

namespace glassbox::views {

enum class Blend {
  kNearest,      // the nearest view alone
  kBarycentric,  // the three around it
  kNeighbours,  // the k nearest by their angles: unstructured lumigraph rendering (Buehler, Bosse, McMillan, Gortler and Cohen 2001)
};
std::string_view name_of(Blend blend);

inline constexpr int kMostNeighbours = 16;

class ViewBlend {
public:
  // Directions are unit vectors from the object's middle; `neighbours`, 1 to kMostNeighbours, is of kNeighbours.
  ViewBlend(Blend blend, std::vector<Vector3d> directions, int neighbours = 4);

  std::size_t views() const { return directions_.size(); }
  const ViewSphere& sphere() const { return sphere_; }

  // For all that is seen from one direction, given which views see a polygon. Positive and summing to 1, or none where nobody sees it. Of
  // the barycentric weights those of views that do not see it are left out, and the rest divided by its sum; where that is 0 the
  // nearest view that sees it has all.
  class From {
  public:
    From(const ViewBlend& blend, const Vector3d& direction);
    ViewWeights weights(const std::function<bool(std::size_t view)>& sees) const;

  private:
    const ViewBlend& blend_;
    ViewWeights around_;                // of the three
    std::vector<std::size_t> nearest_;  // all views, nearest first, of equally near ones the first
    std::vector<double> angles_;        // radians, by view
  };
  From from(const Vector3d& direction) const { return {*this, direction}; }

private:
  Blend blend_;
  std::vector<Vector3d> directions_;
  ViewSphere sphere_;
  std::size_t neighbours_;
};

}  // namespace glassbox::views
