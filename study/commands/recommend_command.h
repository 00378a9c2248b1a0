// glassbox study recommend: finds the cheapest way to draw a scene that is accurate enough, and
// shows the evidence.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/arguments.h"
#include "cli/options/camera_options.h"
#include "cli/options/cli_fwd.h"
#include "study/commands/recommendation.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

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

}  // namespace glassbox::study
