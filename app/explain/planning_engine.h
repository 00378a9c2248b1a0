// The tile engine, and what it plans for the pictures that it draws.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <glassbox/render/engine/engine.h>
#include <glassbox/render/tile/tile_engine.h>

namespace glassbox::app {

// What there is to say about the pictures of a job.
struct PlannedPictures {
  std::vector<std::string> texts;  // by eye
  std::vector<nlohmann::ordered_json> json;
  TileReport report;  // of all
};

class PlanningEngine : public Engine {
public:
  // `planned` outlives it. Each job adds to it.
  PlanningEngine(const TileOptions& options, PlannedPictures& planned);

  // Draws twice, and counts the second time: the first one waits for threads and memory.
  NotSubmitted draw(const PictureJob& job) override;

private:
  TileOptions options_;
  TileEngine engine_;
  PlannedPictures& planned_;
};

// Without drawing anything.
void plan_pictures(const PictureJob& job, const TileOptions& options, PlannedPictures& planned);

}  // namespace glassbox::app
