// What `glassbox diff` was asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/cli_fwd.h"

#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/compare/report/heat_map_file.h>

namespace glassbox::app {

struct DiffRequest {
  std::string reference, test;  // two pictures or two directories
  CompareOptions options;
  std::vector<const CLI::Option*> comparing;  // the options that can change a verdict

  // The reports. "-" is standard output, except for `heat` and `page`.
  std::optional<std::string> heat, page, json, junit, markdown;
  bool page_files = false;  // the page's pictures are files beside it
  HeatMapKind heat_of = HeatMapKind::kSteps;
  bool github = false;

  bool approve_all = false;
  std::vector<std::string> approve_patterns;
  std::optional<std::string> approve_list;  // a file, or "-" for standard input

  bool approves() const { return approve_all || !approve_patterns.empty() || approve_list; }
  // Whether nothing else may be printed, because a report goes to standard output.
  bool is_silent() const { return json == "-" || junit == "-" || markdown == "-"; }
};

// Adds diff's options, which fill in the request.
void add_diff_options(CLI::App& command, DiffRequest& request);

// The command line that makes the same comparison again.
std::string diff_command_line(const DiffRequest& request);

}  // namespace glassbox::app
