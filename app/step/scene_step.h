// glassbox step SCENE --triangle N | --pick X,Y: a triangle of a scene through every stage.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options/cli_fwd.h"
#include "app/step/stage_text.h"
#include "app/step/stepped.h"

#include <glassbox/mesh/limits.h>

namespace glassbox::app {

class SceneStep {
public:
  // SCENE and what goes with it; the picture's options are added to `command`.
  void add_to(CLI::App& command);

  bool is_asked_for() const { return !scene_.empty(); }
  const PictureOptions& picture() const { return picture_; }

  int run(bool bits, const std::optional<std::string>& json_output);

private:
  Result<StepTarget> find_target(const Scene& scene) const;
  std::string heading(const SteppedTriangle& stepped) const;

  std::string scene_;
  PictureOptions picture_;
  LoadLimits limits_;
  std::optional<std::uint32_t> triangle_;
  std::optional<int> vertex_;
  std::optional<std::array<int, 2>> pick_;
  bool interactive_ = false;
};

}  // namespace glassbox::app
