// glassbox views: what pictures are good for.
#pragma once

#include "app/options/cli_fwd.h"
#include "app/views/match_command.h"

namespace glassbox::app {

class ViewsCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  ViewsMatchCommand match_;
};

}  // namespace glassbox::app
