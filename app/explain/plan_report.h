// The plan of a picture, as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/engine/engine.h>
#include <glassbox/render/plan/plan.h>
#include <glassbox/render/tile/tile_engine.h>

namespace glassbox::app {

// The plan of the whole picture as text, then the plans of its groups of draws: of a few groups
// only, those with the most triangles first.
std::string plan_text(const Scene& scene, const Plan& plan, const PlannedEye& eye);

// All groups of draws as JSON, with the instances in each group.
nlohmann::ordered_json to_json(const Plan& plan, const PlannedEye& eye);

// The plans of the pictures of all jobs, as text and as JSON.
struct PlannedPictures {
  std::vector<std::string> texts;  // one text per eye
  std::vector<nlohmann::ordered_json> json;
  TileReport report;  // on all pictures together
};

// The tile engine, which also keeps the plans of the pictures that it draws.
class PlanningEngine : public Engine {
public:
  // `planned` must outlive the engine. Each call of draw() adds the plans of its pictures to it.
  PlanningEngine(const TileOptions& options, PlannedPictures& planned);

  // Draws twice and counts in the second run, because the first run also starts threads and
  // allocates memory.
  PairCullCounts draw(const PictureJob& job) override;

private:
  TileOptions options_;
  TileEngine engine_;
  PlannedPictures& planned_;
};

// Adds the plans of the job's pictures to `planned` without drawing.
void plan_pictures(const PictureJob& job, const TileOptions& options, PlannedPictures& planned);

}  // namespace glassbox::app
