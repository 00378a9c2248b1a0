// glassbox views geometry: computes the cameras of two pictures from the matches between them
// (S2-02 to S2-12).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/options/cli_fwd.h"
#include "cli/report/progress.h"
#include "views/commands/geometry_files.h"
#include "views/commands/geometry_report.h"
#include "views/commands/geometry_scene.h"
#include "views/commands/rectified_pair.h"

#include <glassbox/base/error.h>

namespace glassbox::views {

class ViewsGeometryCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  void add_question_options(CLI::App& command);
  void add_output_options(CLI::App& command);
  Result<void> check_sources() const;
  Result<void> check_question() const;
  Result<void> check_outputs() const;
  Result<GeometryInput> input(Progress& progress);
  Result<void> write_scene(const SceneGeometry& made) const;
  std::string command_line() const;
  Result<std::optional<RectifiedPair>> rectified_pair(const GeometryInput& input,
                                                      const GeometryReport& report) const;
  Result<void> write_report(const GeometryInput& input, const GeometryReport& report,
                            const std::optional<RectifiedPair>& rectified) const;
  int run();

  GeometryFiles files_;
  GeometryScene scene_;
  GeometryQuestion question_;
  bool sigma_given_ = false;
  std::pair<std::string, std::string> pair_output_, rectified_output_;
  std::optional<std::string> matches_output_, cameras_output_, page_, json_output_;
  std::vector<const CLI::Option*> options_;  // repeated in the command line of the report
};

}  // namespace glassbox::views
