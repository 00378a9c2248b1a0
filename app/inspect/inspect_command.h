// glassbox inspect SCENE -o page.html: writes a run of the scene as a page in which every stage can
// be examined.
#pragma once

#include <optional>
#include <string>

#include "app/inspect/page.h"
#include "app/options/cli_fwd.h"
#include "app/options/picture_options.h"

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
  InspectOptions page_;
  LoadLimits limits_;
};

}  // namespace glassbox::app
