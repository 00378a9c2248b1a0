// Pair, matches and truth from the rasterizer: cameras of all three scenarios (S2-02), and where each point is in the other picture
// (S2-03).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/options/cli_fwd.h"
#include "app/options/picture_options.h"
#include "app/views/geometry_input.h"
#include "views/files/camera_file.h"
#include "views/two_view/truth.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

class Progress;

enum class Arrangement { kParallel, kConverging, kArbitrary };
const char* name_of(Arrangement arrangement);

struct GeometryScene {
  std::optional<std::string> scene;
  PictureOptions picture;
  std::optional<Arrangement> arrangement;     // absent: arbitrary with move or turn, else parallel
  std::optional<std::array<double, 3>> move;  // right, up, forward; world units
  std::optional<std::array<double, 3>> turn;  // right, up, clockwise; degrees
  views::MatchSampling sampling;              // of which the seed is the command's
  std::vector<const CLI::Option*> options;    // those that add_geometry_scene_options has added

  Arrangement chosen() const;
};

void add_geometry_scene_options(CLI::App& command, GeometryScene& scene);

// What can be known before anything is drawn.
Result<void> check_geometry_scene(const GeometryScene& scene);

// The pair of the scene; and its cameras, as a file has them.
struct SceneGeometry {
  GeometryInput input;
  std::array<views::PinholeCamera, 2> cameras;
};
Result<SceneGeometry> draw_geometry_scene(const GeometryScene& scene, Progress& progress);

}  // namespace glassbox::app
