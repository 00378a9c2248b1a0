// glassbox views: what pictures are good for.
#pragma once

#include "cli/options/cli_fwd.h"
#include "views/commands/geometry_command.h"
#include "views/commands/glyphs_command.h"
#include "views/commands/klt_command.h"
#include "views/commands/layers_command.h"
#include "views/commands/match_command.h"
#include "views/commands/polygons_command.h"
#include "views/commands/ring_command.h"
#include "views/commands/texture_command.h"
#include "views/commands/voxels_command.h"

namespace glassbox::views {

class ViewsCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  ViewsGeometryCommand geometry_;
  ViewsMatchCommand match_;
  ViewsLayersCommand layers_;
  ViewsRingCommand ring_;
  ViewsVoxelsCommand voxels_;
  ViewsPolygonsCommand polygons_;
  ViewsTextureCommand texture_;
  ViewsKltCommand klt_;
  ViewsGlyphsCommand glyphs_;
};

}  // namespace glassbox::views
