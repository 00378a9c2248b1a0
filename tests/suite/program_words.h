// Finds which programs a source file starts, from its text. It knows the ways in which this project
// starts programs, and only as much of the languages as that needs.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace glassbox::test {

using Words = std::set<std::string>;

// Returns the words of a POSIX shell script at which a command begins, except the script's own
// functions, the shell's built-in commands, and words that are put together from variables.
Words shell_words(std::string_view script);

// Returns the programs named in calls that start one: run_program, std::system, posix_spawnp and
// similar functions. It includes the literals of variables that the calls name, and the scripts in
// R"sh(...)sh".
Words cpp_words(std::string_view source);

// Returns the programs of find_program, and of COMMAND where the next word is not a variable.
Words cmake_words(std::string_view source);

// Returns the programs of node's execFileSync and similar functions.
Words javascript_words(std::string_view source);

// Whether the source itself makes a system call that replaces its process or starts another
// program.
bool launches(std::string_view cpp_source);

}  // namespace glassbox::test
