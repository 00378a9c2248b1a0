// The commands of glassbox, grouped by subject. A program has all of them, or those of one subject,
// so that somebody who only wants to look at one picture need not wait until the rest is compiled
// (docs/building.md).
#pragma once

#include <span>

#include "app/options/cli_fwd.h"

namespace glassbox::app {

// Adds subcommands to `app`. The subcommand that is run writes its exit code to `exit_code`.
using AddCommands = void (*)(CLI::App& app, int& exit_code);

// Adds the commands about one picture: render, info, explain, step, pixel, why, trace, stereo,
// inspect, diff.
void add_picture_commands(CLI::App& app, int& exit_code);
// Each of these adds one subcommand, with the help text below it.
void add_bench_command(CLI::App& app, int& exit_code);
inline constexpr const char* kBenchHelp = "how fast it draws, against whom, and how its time grows";
void add_study_command(CLI::App& app, int& exit_code);
inline constexpr const char* kStudyHelp =
    "what accuracy costs: measured errors and times beside the theory";
void add_views_command(CLI::App& app, int& exit_code);
inline constexpr const char* kViewsHelp = "what pictures of a scene are good for";
void add_lab_command(CLI::App& app, int& exit_code);
inline constexpr const char* kLabHelp = "assignments: start one, check it, hand one out";
// Adds help, completion and man, which print what the commands added before them have. Call it
// last.
void add_help_commands(CLI::App& app, int& exit_code);

// A subcommand that is not among those about one picture.
struct Subject {
  const char* name;
  const char* help;
  AddCommands add;  // null: not compiled into this program, which only lists its name
};

// Runs the program with the words of its command line and returns the exit code.
int run_program(std::span<const Subject> subjects, int argc, char** argv);

}  // namespace glassbox::app
