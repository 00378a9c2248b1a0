// glassbox views glyphs: finds walls of coloured discs in pictures, and computes the camera from
// them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/cli_fwd.h"
#include "cli/report/progress.h"
#include "views/glyphs/find.h"
#include "views/glyphs/pose.h"
#include "views/glyphs/sweep.h"
#include "views/glyphs/wall.h"

#include <glassbox/base/error.h>

namespace glassbox::views {

class ViewsGlyphsCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  void add_layout(CLI::App& command);
  void add_rules(CLI::App& command);
  // Switches a rule off, so that regions need not fulfil it.
  void leave_out(const std::string& name);
  int sheet();
  int find();
  int sweep();

  views::WallLayout layout_;
  std::optional<int> panel_;
  std::optional<double> dpi_, fov_;
  std::string output_, picture_;
  std::optional<std::string> against_, page_, json_output_;
  views::LensKnown known_ = views::LensKnown::kCentre;
  views::FindSettings settings_;
  views::SweepOf what_ = views::SweepOf::kSize;
  std::vector<const CLI::Option*> options_;
};

}  // namespace glassbox::views
