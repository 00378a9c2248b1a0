// glassbox inspect SCENE -o page.html: writes a run of the scene as a page in which every stage can
// be examined.
#pragma once

#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"
#include "cli/options/picture_options.h"
#include "inspect/page.h"

#include <glassbox/mesh/limits.h>

namespace glassbox::app {

class InspectCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();
  Result<void> check_pixels() const;
  std::string command_line() const;

  std::string scene_;
  std::string output_;
  PictureOptions picture_;
  inspect::InspectOptions page_;
  LoadLimits limits_;
};

}  // namespace glassbox::app
