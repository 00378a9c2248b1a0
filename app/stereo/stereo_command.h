// glassbox stereo SCENE: reports what two eyes see of a scene, what disturbs them, and what to
// change.
#pragma once

#include <optional>
#include <string>

#include "app/stereo/findings.h"
#include "app/stereo/stereo_picture.h"
#include "app/stereo/text.h"
#include "cli/options/cli_fwd.h"
#include "cli/options/engine_options.h"
#include "cli/options/picture_options.h"

namespace glassbox::app {

class StereoCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();
  Result<void> check_options() const;
  std::string command_line() const;
  Result<void> write_outputs(const Scene& scene, const StereoFindings& found,
                             const StereoWords& words) const;

  std::string scene_;
  PictureOptions picture_;
  AnaglyphOptions anaglyph_;
  StereoQuestion question_;
  EngineOptions engine_;
  std::optional<std::string> html_output_, json_output_;
  // the report's options, which a repeated command line needs
  std::vector<const CLI::Option*> options_;
};

}  // namespace glassbox::app
