#include "app/explain/planning_engine.h"

#include "app/explain/plan_report.h"

namespace glassbox::app {

void plan_pictures(const PictureJob& job, const TileOptions& options, PlannedPictures& planned) {
  const std::vector<DrawList> lists = make_draw_lists(job.scene, job.prepared, views_of(job.eyes));
  std::vector<PlannedEye> eyes;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    eyes.push_back({lists[i], job.eyes[i].view, job.eyes[i].settings});
  }
  const std::vector<Plan> plans = options.planner(eyes, options.plan);
  for (std::size_t i = 0; i < plans.size(); ++i) {
    planned.texts.push_back(plan_text(job.scene, plans[i], eyes[i]));
    planned.json.push_back(to_json(plans[i], eyes[i]));
  }
}

PlanningEngine::PlanningEngine(const TileOptions& options, PlannedPictures& planned)
    : options_(options), engine_(options), planned_(planned) {}

NotSubmitted PlanningEngine::draw(const PictureJob& job) {
  plan_pictures(job, options_, planned_);
  engine_.render(job.scene, job.prepared, job.eyes);
  engine_.render(job.scene, job.prepared, job.eyes, &planned_.report);
  return {};
}

}  // namespace glassbox::app
