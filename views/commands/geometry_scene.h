// Draws a pair with the rasterizer, for cameras of all three arrangements (S2-02), and computes the
// true matches: where each point is in the other picture (S2-03).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/cli_fwd.h"
#include "cli/options/picture_options.h"
#include "cli/report/progress.h"
#include "views/commands/geometry_input.h"
#include "views/files/camera_file.h"
#include "views/two_view/truth.h"

#include <glassbox/base/error.h>

namespace glassbox::views {

enum class Arrangement { kParallel, kConverging, kArbitrary };
const char* name_of(Arrangement arrangement);

struct GeometryScene {
  std::optional<std::string> scene;
  PictureOptions picture;
  // absent: arbitrary if move or turn is given, else parallel
  std::optional<Arrangement> arrangement;
  std::optional<std::array<double, 3>> move;  // right, up, forward; world units
  std::optional<std::array<double, 3>> turn;  // right, up, clockwise; degrees
  views::MatchSampling sampling;              // with the command's seed
  // the options that add_geometry_scene_options has added
  std::vector<const CLI::Option*> options;

  Arrangement chosen() const;
};

void add_geometry_scene_options(CLI::App& command, GeometryScene& scene);

// The checks that are possible before anything is drawn.
Result<void> check_geometry_scene(const GeometryScene& scene);

// The pair of the scene, and its cameras in the form of a file.
struct SceneGeometry {
  GeometryInput input;
  std::array<views::PinholeCamera, 2> cameras;
};
Result<SceneGeometry> draw_geometry_scene(const GeometryScene& scene, Progress& progress);

}  // namespace glassbox::views
