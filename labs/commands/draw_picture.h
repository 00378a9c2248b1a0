// Builds a student's functions, draws a scene with them in the pipeline, and reports the result.
#pragma once

#include <optional>
#include <string>

#include "cli/options/picture_options.h"
#include "labs/commands/find_lab.h"

namespace glassbox::labs {

struct LabPictureRequest {
  const LabSelection& lab;
  const std::string& scene;
  std::string output;  // an image file
  const PictureOptions& picture;
  std::optional<std::string> json, html;
  double seconds = 10;  // time limit of a stage
};

// Refuses options that can be known to be wrong before anything is built.
Result<void> check_lab_picture(const LabPictureRequest& request);

// Draws the picture. The exit code is 0 if every number is within its bound.
int draw_lab_picture(const LabPictureRequest& request);

}  // namespace glassbox::labs
