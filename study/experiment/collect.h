// The parts of one run, measured one by one, here or on many machines, and joined.
#pragma once

#include <span>
#include <string>

#include <glassbox/base/error.h>

#include "study/experiment/results.h"

namespace glassbox::study {

struct PartFile {
  std::string path;
  StudyResults results;
};

// All parts of one run, in any order, as one run would have them. An error names the file where the parts are of several builds,
// efforts or divisions, where one is there twice or missing; and, unless `any_machine`, where they were measured on machines that
// differ, or with other numbers of threads: times of those are not comparable. (Errors are.)
Result<StudyResults> join_parts(std::span<const PartFile> parts, bool any_machine);

}  // namespace glassbox::study
