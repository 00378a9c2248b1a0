// Classifies the box of a whole group of instances and bounds its depths, so that the plan need not
// test each instance.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/instance_groups.h>
#include <glassbox/render/plan/box_bounds.h>
#include <glassbox/render/plan/box_classification.h>

namespace glassbox {

// Does for a group of instances what classify_draw_box() and depth_codes() do for one draw. The
// result for a group holds for each draw of it, as it is transformed to clip space in float.
class GroupClassifier {
public:
  explicit GroupClassifier(const View& view);

  // Returns nothing if each draw has to be tested: the group may be on both sides of a plane, or a
  // number may overflow.
  std::optional<BoxClassification> classify(const InstanceGroup& group) const;

  DepthCodes codes(const InstanceGroup& group, DepthFormat format) const;

private:
  // A row of the map to clip space: coordinate = slope . X + offset for a point X in world space,
  // in exact arithmetic.
  struct Row {
    std::array<double, 3> slope{};
    double offset = 0;
    double length = 0;  // length of the vector `slope`
    // Two sums of absolute values of products of the matrices' entries. The rounding error of the
    // coordinate in double is at most gamma(32) (by_far |largest world coordinate| + by_one).
    double by_far = 0, by_one = 0;
  };
  ClipCoordinate coordinate_over(const InstanceGroup& group, const Row& row) const;

  const View& view_;
  std::array<Row, 4> rows_;
  // Clip planes: near, far and eye; and the edges of the picture and of the guard band.
  std::vector<ClipPlane> near_eye_far_, edges_;
};

}  // namespace glassbox
