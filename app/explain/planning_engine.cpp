#include "app/explain/planning_engine.h"

#include "app/explain/plan_report.h"

#include <glassbox/render/plan/plan.h>

namespace glassbox::app {

void plan_pictures(const PictureJob& job, const TileOptions& options, PlannedPictures& planned) {
  PlannedPicture picture;
  plan_picture(job.scene, job.prepared, job.eyes, options.planner, options.plan, picture);
  for (std::size_t i = 0; i < picture.plans.size(); ++i) {
    planned.texts.push_back(plan_text(job.scene, picture.plans[i], picture.eyes[i]));
    planned.json.push_back(to_json(picture.plans[i], picture.eyes[i]));
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
