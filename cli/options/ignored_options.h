// Notes about options that have no effect on the picture.
#pragma once

#include <string>
#include <vector>

#include "cli/options/cli_fwd.h"
#include "cli/options/picture_options.h"

namespace glassbox {

// Prints a note on standard error for each option that has no effect. It is no error, because the
// same options may be useful for another picture.
void print_ignored_options(const PictureOptions& picture);

// Options of a command that have no effect, for the reason `why`.
struct IgnoredOptions {
  bool are_ignored = false;
  std::vector<std::string> names;
  std::string why;
};
// Prints the note for those options in `all` that the user has given.
void print_ignored_options(const CLI::App& command, const std::vector<IgnoredOptions>& all);

}  // namespace glassbox
