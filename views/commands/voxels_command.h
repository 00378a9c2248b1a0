// glassbox views voxels: reconstructs a shape as voxels from calibrated pictures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/cli_fwd.h"
#include "cli/report/progress.h"
#include "views/commands/picture_choice.h"
#include "views/commands/voxels_report.h"
#include "views/rings/picture_set.h"
#include "views/voxels/coloring.h"
#include "views/voxels/voxel_file.h"

namespace glassbox::views {

class ViewsVoxelsCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  void add_input_options(CLI::App& command);
  void add_coloring_options(CLI::App& command);
  void add_output_options(CLI::App& command);
  int run();
  Result<void> check_asked() const;
  Result<void> check_outputs() const;
  void tell_of_unused() const;
  Result<VoxelsInput> read(Progress& progress) const;
  Result<void> complete_request(const views::PictureSet& set);
  Result<void> write_outputs(const VoxelsInput& input, const VoxelsReport& report) const;
  std::string command_line() const;

  PictureChoice choice_;
  std::optional<std::string> truth_;
  AskedBox box_;
  std::optional<double> voxel_size_, total_;
  std::optional<int> resolution_;
  bool against_full_ = false;
  views::ColoringRequest request_;
  std::optional<std::string> output_, left_out_output_, json_output_, page_;
  views::VoxelShape shape_ = views::VoxelShape::kCubes;
  const CLI::App* command_ = nullptr;
  std::vector<const CLI::Option*> options_;
};

}  // namespace glassbox::views
