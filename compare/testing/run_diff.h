// Runs `glassbox diff` as a program of its own.
#pragma once

#include <string>
#include <vector>

namespace glassbox::golden {

struct DiffRun {
  // 0: the pictures are the same, or within the tolerance; 1: they differ; 2: the program refused
  // to compare them, for example because one of them cannot be read; -1: the program could not be
  // started, did not end by itself, or ended with another exit code.
  int exit_code = -1;
  // What the program printed, with a line feed at its end unless it is empty; for -1, why.
  std::string text;
};

// `program` is a path, or a name that is looked for in PATH.
DiffRun run_diff(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace glassbox::golden
