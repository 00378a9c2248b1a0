// What to say of a command line that is not understood.
#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace glassbox::app {

// One line: what is wrong, the word that was probably meant where one is near, and where help is.
std::string usage_problem(const CLI::App& program, const CLI::ParseError& error);

}  // namespace glassbox::app
