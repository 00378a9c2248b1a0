// The draws of a picture's eyes, and the plans for them.
#pragma once

#include <span>
#include <vector>

#include <glassbox/render/engine/engine.h>
#include <glassbox/render/plan/plan.h>

namespace glassbox {

// One entry for each eye. `eyes` refers to `lists`; the memory is used again for the next picture.
struct PlannedPicture {
  std::vector<DrawList> lists;
  std::vector<PlannedEye> eyes;
  std::vector<Plan> plans;
};

void plan_picture(const Scene& scene, const PreparedScene& prepared,
                  std::span<const EyePicture> eyes, Planner planner, bool leave_out,
                  PlannedPicture& picture);

}  // namespace glassbox
