// Where a whole group of instances lies, and which depths it has: what the plan need not ask of each of them.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/instance_groups.h>
#include <glassbox/render/plan/box_bounds.h>
#include <glassbox/render/plan/box_place.h>

namespace glassbox {

// Asks groups what place_box() and depth_codes() ask a draw: what they say of a group holds for each draw of it, as that is carried to
// clip space in float.
class GroupPlaces {
public:
  explicit GroupPlaces(const View& view);

  // Nothing where the group has to be opened: some of it may lie on a plane, or a number may overflow.
  std::optional<BoxPlace> place(const InstanceGroup& group) const;

  DepthCodes codes(const InstanceGroup& group, DepthFormat format) const;

private:
  // Of clip space: coordinate = slope . X + offset for a point X of the world, in exact arithmetic.
  struct Row {
    std::array<double, 3> slope{};
    double offset = 0;
    double length = 0;  // of the slope
    // What the double matrices may be off by: by_far |largest coordinate| + by_one.
    double by_far = 0, by_one = 0;
  };
  ClipCoordinate over(const InstanceGroup& group, const Row& row) const;

  const View& view_;
  std::array<Row, 4> rows_;
  std::vector<ClipPlane> near_eye_far_, edges_;  // of the picture, and of the guard band
};

}  // namespace glassbox
