// What is suspicious about the user's own matrices, for a picture in which little is seen.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/options/picture_options.h"

#include <glassbox/matrices/conventions_check.h>
#include <glassbox/matrices/findings.h>

namespace glassbox::app {

struct MatrixSuspicions {
  std::vector<Finding> alarms;  // what is wrong with the matrices by themselves
  // The changes of convention that bring more of the scene into the picture. The points are the
  // eight corners of the scene's bounding box and its middle.
  ConventionsReport conventions;

  bool any() const { return !alarms.empty() || !conventions.alternatives.empty(); }
};

// Examines the matrices; nothing without --proj. `scene` has the model matrix applied to it.
MatrixSuspicions suspect_matrices(const Scene& scene, const PictureOptions& picture);

// The alarms, and the likeliest change with its evidence and its remedy.
std::string suspicions_text(const MatrixSuspicions& found);
nlohmann::ordered_json suspicions_json(const MatrixSuspicions& found);

}  // namespace glassbox::app
