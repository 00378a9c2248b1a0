// Joins the parts of one run, which were measured one by one on the same machine or on several.
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

// Joins all parts of one run, given in any order, into the results that a single run would have. It
// is an error, which names the file, if the parts come from different builds, efforts (quick or
// full) or numbers of parts, or if a part is missing or is there twice. Without `any_machine` it is
// also an error if the machines or the numbers of threads differ: times from different machines
// cannot be compared, errors can.
Result<StudyResults> join_parts(std::span<const PartFile> parts, bool any_machine);

}  // namespace glassbox::study
