// A scene drawn with a student's functions in the pipeline: built, drawn, reported.
#pragma once

#include <optional>
#include <string>

#include "app/lab/find_lab.h"
#include "app/options/picture_options.h"

namespace glassbox::app {

struct LabPicture {
  const AskedLab& lab;
  const std::string& scene;
  std::string output;  // an image
  const PictureOptions& picture;
  std::optional<std::string> json, html;
  double seconds = 10;  // that a stage may take
};

// What can be said against it before anything is done.
Result<void> check_lab_picture(const LabPicture& asked);

// The exit code: 0 where every number is within its bound.
int draw_lab_picture(const LabPicture& asked);

}  // namespace glassbox::app
