// glassbox views layers: makes layered depth images, and draws them from other views.
#pragma once

#include "app/options/cli_fwd.h"
#include "app/views/layers_build_command.h"
#include "app/views/layers_draw_command.h"

namespace glassbox::app {

class ViewsLayersCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  LayersBuildCommand build_;
  LayersDrawCommand draw_;
};

}  // namespace glassbox::app
