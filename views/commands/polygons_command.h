// glassbox views polygons: reconstructs the surface of a shape from calibrated pictures.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/cli_fwd.h"
#include "cli/report/progress.h"
#include "views/commands/polygons_report.h"

namespace glassbox::views {

class ViewsPolygonsCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  void add_input_options(CLI::App& command);
  void add_surface_options(CLI::App& command);
  void add_output_options(CLI::App& command);
  int run();
  Result<void> check_asked() const;
  Result<void> check_outputs() const;
  Result<void> complete_request(const views::PictureSet& set);
  Result<void> write_outputs(const PolygonsInput& input, const PolygonsReport& report) const;
  std::string command_line() const;

  PictureChoice choice_;
  std::optional<std::string> truth_;
  AskedBox box_;
  int resolution_ = 64;
  PolygonsRequest request_;
  std::optional<std::string> output_, left_out_output_, json_output_, page_;
  std::vector<const CLI::Option*> options_;
};

}  // namespace glassbox::views
