// glassbox study stiffness: reports the condition numbers of a scene in one view, and the error
// bounds that follow.
#pragma once

#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"
#include "cli/options/picture_options.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

struct StiffnessReport;

class StudyStiffnessCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;
  Result<void> write_outputs(const Scene& scene, const StiffnessReport& report) const;

  std::string scene_;
  PictureOptions picture_;
  std::optional<std::string> json_output_, html_output_;
};

}  // namespace glassbox::study
