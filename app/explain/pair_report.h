// The report of `explain --stereo` on both eyes' pictures, as text and as JSON.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/explain/planning_engine.h"

#include <glassbox/render/renderer.h>

namespace glassbox::app {

struct PairReport {
  const StereoRendering& both;
  // Empty if the staged engine has drawn, which makes no plan.
  const PlannedPictures& planned;
  bool counted = false;  // counts of the stages are wanted

  bool is_planned() const { return !planned.texts.empty(); }
};

// Eyes with the same text are reported once, together.
std::string pair_text(const PairReport& pair);

// The keys are "left" and "right", or "both" where both eyes have one picture.
nlohmann::ordered_json pair_json(const PairReport& pair);

}  // namespace glassbox::app
