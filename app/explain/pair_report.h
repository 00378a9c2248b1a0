// Both eyes' pictures of `explain --stereo`, for people and for machines.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/explain/planning_engine.h"

#include <glassbox/render/renderer.h>

namespace glassbox::app {

struct PairReport {
  const StereoRendering& both;
  // Empty where the staged stages have drawn, who plan nothing.
  const PlannedPictures& planned;
  bool counted = false;  // what the stages did is wanted

  bool is_planned() const { return !planned.texts.empty(); }
};

// Of eyes of which the same is said, once.
std::string pair_text(const PairReport& pair);

// "left" and "right", or "both" where they have one picture.
nlohmann::ordered_json pair_json(const PairReport& pair);

}  // namespace glassbox::app
