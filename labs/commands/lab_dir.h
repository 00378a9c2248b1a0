// --lab-dir: a lab from outside the source tree, instead of one of the program's. --lab: which of
// the program's labs a folder belongs to.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "labs/framework/sources.h"
#include "labs/grading/outside_lab.h"

namespace glassbox::labs {

inline CLI::Option* add_lab_dir(CLI::App& command, std::string& folder) {
  return command
      .add_option("--lab-dir", folder, "a lab of your own: its folder NN-name (docs/labs.md)")
      ->type_name("DIR");
}

inline CLI::Option* add_lab_name(CLI::App& command, std::string& name) {
  return command.add_option("--lab", name, "which lab a folder without lab.json is of");
}

// The sources with the lab of `folder` instead of the program's; unchanged if `folder` is empty.
inline Result<labs::Sources> with_lab_dir(Result<labs::Sources> sources,
                                          const std::string& folder) {
  if (!sources || folder.empty()) return sources;
  const auto found = labs::grading::find_outside_lab(folder);
  if (!found) return tl::unexpected(found.error());
  sources->outside = *found;
  return sources;
}

}  // namespace glassbox::labs
