// glassbox study scene: measures error against time for every way to draw the user's own scene.
#pragma once

#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"
#include "cli/options/picture_options.h"
#include "study/commands/scene/curve_report.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

class StudySceneCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  Result<void> check_options() const;
  Result<CurveReport> measure(const Scene& scene, Progress& progress) const;
  SecondEyes measure_second_eyes(const Scene& scene, Progress& progress) const;
  Result<void> write_outputs(const CurveReport& report) const;
  std::string command() const;
  int run() const;

  std::string scene_;
  PictureOptions picture_;
  bool quick_ = false;
  int threads_ = 0;  // the largest number of threads; 0: all
  std::optional<std::string> json_output_, csv_output_, page_;
};

}  // namespace glassbox::study
