// Options that the picture asked for has no use for.
#pragma once

#include <string>
#include <vector>

#include "app/options/cli_fwd.h"
#include "app/options/picture_options.h"

namespace glassbox::app {

// A note on standard error for each of them: the same words are right for another picture, so they are no error.
void tell_of_ignored(const PictureOptions& picture);

// Options of a command that are of no use for `why`.
struct IgnoredOptions {
  bool are_ignored = false;
  std::vector<std::string> names;
  std::string why;
};
// The same note for those of them that were given.
void tell_of_ignored(const CLI::App& command, const std::vector<IgnoredOptions>& all);

}  // namespace glassbox::app
