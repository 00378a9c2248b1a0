// The message for a command line that cannot be parsed.
#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace glassbox {

// One line: what is wrong, the word that was probably meant if there is a similar one, and the
// command for help.
std::string usage_error_message(const CLI::App& program, const CLI::ParseError& error);

}  // namespace glassbox
