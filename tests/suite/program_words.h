// Which programs a source file starts, read from its text. This knows the ways in which this project starts programs, and no
// more of the languages than that takes.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace glassbox::test {

using Words = std::set<std::string>;

// The words of a POSIX shell script at which a command begins, without its own functions, what the shell does itself, and words
// that are put together from variables.
Words shell_words(std::string_view script);

// The programs named in calls that start one: run_program, std::system, posix_spawnp and their like, with the literals of
// variables that the calls name, and the scripts in R"sh(...)sh".
Words cpp_words(std::string_view source);

// Of find_program, and of COMMAND where the word is no variable.
Words cmake_words(std::string_view source);

// Of node's execFileSync and its like.
Words javascript_words(std::string_view source);

// Whether the source itself calls the system to become or start another program.
bool launches(std::string_view cpp_source);

}  // namespace glassbox::test
