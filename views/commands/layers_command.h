// glassbox views layers: makes layered depth images, and draws them from other views.
#pragma once

#include "cli/options/cli_fwd.h"
#include "views/commands/layers_build_command.h"
#include "views/commands/layers_draw_command.h"

namespace glassbox::views {

class ViewsLayersCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  LayersBuildCommand build_;
  LayersDrawCommand draw_;
};

}  // namespace glassbox::views
