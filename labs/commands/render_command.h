// glassbox lab render: draws a scene with the student's functions in the pipeline, next to the
// reference's picture.
#pragma once

#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"
#include "cli/options/picture_options.h"
#include "labs/commands/find_lab.h"

namespace glassbox::labs {

class LabRenderCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  AskedLab asked_;
  std::string scene_, output_;
  PictureOptions picture_;
  std::optional<std::string> json_output_, html_output_;
  double seconds_ = 10;
};

}  // namespace glassbox::labs
