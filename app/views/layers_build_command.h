// glassbox views layers build: a scene's surfaces from one view, one behind the other, as a file.
#pragma once

#include <optional>
#include <string>

#include "app/options/cli_fwd.h"
#include "app/options/picture_options.h"

namespace glassbox::app {

class LayersBuildCommand {
public:
  void add_to(CLI::App& layers, int& exit_code);

private:
  int run();
  Result<void> check_asked(const Scene& scene) const;

  std::string scene_, output_;
  int layers_ = 10;
  PictureOptions picture_;
  std::optional<std::string> json_output_;
};

}  // namespace glassbox::app
