// glassbox views ring: draws calibrated pictures of a scene from all around it.
#pragma once

#include <optional>
#include <string>

#include "cli/options/arguments.h"
#include "cli/options/cli_fwd.h"
#include "views/rings/draw_ring.h"
#include "views/rings/ring.h"

#include <glassbox/render/engine/settings.h>

namespace glassbox::views {

class ViewsRingCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  int run();

  std::string scene_, output_;
  Size size_{320, 320};
  views::RingOptions ring_;
  views::Matte matte_ = views::Matte::kDepth;
  std::optional<Shading> shading_;
  int samples_ = 1;
  Rgba8 background_{0, 0, 0, 255};
  std::optional<std::string> json_output_;
};

}  // namespace glassbox::views
