// The manual page, made from the same tables as the help text.
#pragma once

#include <string>

#include "cli/options/command_tree.h"

namespace glassbox {

// The page glassbox(1) in the man macros that groff and mandoc read.
std::string man_page(const CommandFacts& program, const std::string& version);

}  // namespace glassbox
