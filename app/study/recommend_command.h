// glassbox study recommend: finds the cheapest way to draw a scene that is accurate enough, and
// shows the evidence.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options/arguments.h"
#include "app/options/camera_options.h"
#include "app/options/cli_fwd.h"
#include "app/study/recommendation.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

class StudyRecommendCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;

  std::string scene_, budgets_;
  PictureOptions picture_;
  std::vector<const CLI::Option*> picture_words_;
  std::optional<std::string> json_output_;
};

}  // namespace glassbox::app
