#include <glassbox/render/plan/planned_picture.h>

namespace glassbox {

void plan_picture(const Scene& scene, const PreparedScene& prepared,
                  std::span<const EyePicture> eyes, Planner planner, bool leave_out,
                  PlannedPicture& picture) {
  fill_draw_lists(scene, prepared, views_of(eyes), picture.lists);
  picture.eyes.clear();
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    picture.eyes.push_back(
        {picture.lists[i], eyes[i].view, eyes[i].settings, eyes[i].behind != nullptr});
  }
  picture.plans = planner(picture.eyes, leave_out);
}

}  // namespace glassbox
