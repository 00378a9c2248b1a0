// The commands of glassbox by subject. A program has all of them, or those of one subject: so that
// somebody who wants to look at one picture need not wait until the rest is compiled
// (docs/building.md).
#pragma once

#include <span>

#include "app/options/cli_fwd.h"

namespace glassbox::app {

// Adds subcommands to `app`, which write the exit code of the one that is run to `exit_code`.
using AddCommands = void (*)(CLI::App& app, int& exit_code);

// What looks at one picture: render, info, explain, step, pixel, why, trace, stereo, inspect, diff.
void add_picture_commands(CLI::App& app, int& exit_code);
// The others have one subcommand each, with this help.
void add_bench_command(CLI::App& app, int& exit_code);
inline constexpr const char* kBenchHelp = "how fast it draws, against whom, and how its time grows";
void add_study_command(CLI::App& app, int& exit_code);
inline constexpr const char* kStudyHelp =
    "what accuracy costs: measured errors and times beside the theory";
void add_views_command(CLI::App& app, int& exit_code);
inline constexpr const char* kViewsHelp = "what pictures of a scene are good for";
void add_lab_command(CLI::App& app, int& exit_code);
inline constexpr const char* kLabHelp = "assignments: start one, check it, hand one out";
// help, completion and man: they print what the commands before them have added.
void add_help_commands(CLI::App& app, int& exit_code);

// A subcommand beyond those of one picture, as a program has it.
struct Subject {
  const char* name;
  const char* help;
  AddCommands add;  // null: the program only knows its name
};

// Runs the program with the words of its command line. The exit code.
int run_program(std::span<const Subject> subjects, int argc, char** argv);

}  // namespace glassbox::app
