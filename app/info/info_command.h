// glassbox info SCENE: prints what is in a scene, and what is wrong with it.
#pragma once

#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"

namespace glassbox::app {

class InfoCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();
  int tell_of_layers() const;  // reports on the file of a layered depth image

  std::string scene_;
  std::optional<std::string> json_output_;
  std::optional<std::string> glb_output_;
};

}  // namespace glassbox::app
