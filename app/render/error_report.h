// render --report: of each stage, how far its numbers may be off, and how long it took.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "views/layers/second_eye_error.h"

#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/engine/statistics.h>
#include <glassbox/render/trace/picture_bounds.h>

namespace glassbox::app {

struct ErrorReport {
  std::string scene;                 // as it was given
  std::vector<std::string> picture;  // the words of its options: --size 320x180
  int width = 0, height = 0;
  View view;
  RenderSettings settings;
  std::string engine;     // what drew the picture: "the tile engine, 2 threads, avx512"
  Statistics statistics;  // of that engine
  PictureErrors errors;
  std::optional<views::SecondEyeError> second_eye;  // of a pair whose right eye was warped
};

std::string error_report_text(const ErrorReport& report);
// Schema "glassbox-report/1" (docs/exactness.md).
nlohmann::ordered_json error_report_json(const ErrorReport& report);

}  // namespace glassbox::app
