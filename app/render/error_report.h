// render --report: for each stage, the bounds of its errors, and its time.
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
  std::string scene;  // as the user gave it
  // the options that choose the picture, as words: --size 320x180
  std::vector<std::string> picture;
  int width = 0, height = 0;
  View view;
  RenderSettings settings;
  std::string engine;     // the engine that drew the picture: "the tile engine, 2 threads, avx512"
  Statistics statistics;  // counted by the engine that drew the picture
  PictureErrors errors;
  std::optional<views::SecondEyeError> second_eye;  // for a pair whose right eye was warped
};

std::string error_report_text(const ErrorReport& report);
// The report as JSON with the schema "glassbox-report/1" (docs/exactness.md).
nlohmann::ordered_json error_report_json(const ErrorReport& report);

}  // namespace glassbox::app
