// What every run of the program begins and ends with.
#pragma once

#include <exception>

namespace glassbox::app {

// Before anything is opened. A closed standard stream stays closed, but no file that is opened later takes its number; a file that
// grows beyond its limit is an error in place of a signal; what a thread throws and nobody catches is told, with exit code 1.
void begin_run();

// Whether all that was printed has arrived: `exit_code`, or kBadInput and why not.
int end_run(int exit_code);

// What no command expected, in one line: the exit code.
int tell(const std::exception& error);

}  // namespace glassbox::app
