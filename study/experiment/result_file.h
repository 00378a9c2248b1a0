// The file in which a long run saves its results. It is complete after every experiment, so that
// the run may be stopped at any time.
#pragma once

#include <string>

#include <glassbox/base/error.h>

#include "study/experiment/results.h"

namespace glassbox::study {

Result<StudyResults> read_results(const std::string& path);
Result<void> write_results(const std::string& path, const StudyResults& results);

// Reads the results from which a run continues. No results if there is no file; an error if its
// results have another origin.
Result<StudyResults> resume_results(const std::string& path, const Origin& origin);

// Returns for example "the machine is 'A' in the file and 'B' now"; empty if both are the same.
std::string first_difference(const Origin& there, const Origin& here);

// Null if the results do not contain the experiment.
const ExperimentResult* find_result(const StudyResults& results, const std::string& id);

}  // namespace glassbox::study
