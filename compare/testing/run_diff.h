// Runs `glassbox diff` as a program of its own.
#pragma once

#include <string>
#include <vector>

namespace glassbox::golden {

struct DiffRun {
  // 0: the pictures are the same, or within the tolerance; 1: they differ; 2: one of them cannot be
  // read; -1: the program could not be started, or did not end by itself.
  int exit_code = -1;
  std::string text;  // what the program printed, with a line feed at its end; why, for -1
};

// `program` is a path, or a name that is looked for in PATH.
DiffRun run_diff(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace glassbox::golden
