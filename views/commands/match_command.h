// glassbox views match: finds for each point how far apart two pictures show it (the disparity).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/options/cli_fwd.h"
#include "views/commands/match_input.h"
#include "views/matching/match.h"

namespace glassbox::views {

class ViewsMatchCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  void add_settings_options(CLI::App& command);
  void add_output_options(CLI::App& command);
  int run();
  Result<void> check_sources() const;
  Result<void> check_outputs() const;
  Result<void> check_rectified() const;
  Result<void> check_depth(const MatchInput& input) const;
  Result<void> write_maps(const MatchInput& input, const views::DenseMatch& match) const;
  Result<std::string> write_surface(const MatchInput& input, const views::DenseMatch& match) const;
  Result<void> write_page(const MatchInput& input, const views::DenseMatch& match,
                          const nlohmann::ordered_json& json) const;
  std::string command_line() const;
  views::MatchSettings settings(const MatchInput& input) const;

  MatchSources sources_;
  std::string method_ = "default";
  std::optional<views::MatchingCost> cost_;
  std::optional<int> window_, adaptive_, paths_, planes_, left_right_, speckle_;
  std::optional<float> confidence_;
  std::optional<views::DisparityRange> range_;
  std::optional<views::Calibration> calibration_;
  bool no_fill_ = false, no_subpixel_ = false, no_median_ = false, no_smooth_ = false,
       no_check_ = false;
  Target target_ = best_target();
  int threads_ = 0;
  std::uint32_t max_megabytes_ = 4096;
  std::optional<std::string> output_, depth_output_, surface_output_, json_output_, page_;
  std::pair<std::string, std::string> rectified_output_;
  std::vector<const CLI::Option*> options_;  // repeated in the command line of the report
};

}  // namespace glassbox::views
