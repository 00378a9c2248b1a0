// glassbox views: the methods that work on pictures of a scene, such as matching and
// reconstruction.
#pragma once

#include "app/options/cli_fwd.h"
#include "app/views/geometry_command.h"
#include "app/views/glyphs_command.h"
#include "app/views/klt_command.h"
#include "app/views/layers_command.h"
#include "app/views/match_command.h"
#include "app/views/polygons_command.h"
#include "app/views/ring_command.h"
#include "app/views/texture_command.h"
#include "app/views/voxels_command.h"

namespace glassbox::app {

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

}  // namespace glassbox::app
