// What every run of the program does first and last.
#pragma once

#include <exception>

namespace glassbox {

// Call it before any file is opened. A closed standard stream stays closed, but no file that is
// opened later gets its number. A file that grows beyond its limit becomes an error instead of a
// signal. An exception that a thread does not catch is reported, with exit code 1.
void begin_run();

// Checks that all output was really written. Returns `exit_code`, or kBadInput after printing what
// failed.
int end_run(int exit_code);

// Reports an unexpected exception in one line. Returns the exit code.
int report_exception(const std::exception& error);

}  // namespace glassbox
