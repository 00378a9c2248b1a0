// The file in which a long run keeps what it has: whole after every experiment, so that it may be stopped at any time.
#pragma once

#include <string>

#include <glassbox/base/error.h>

#include "study/experiment/results.h"

namespace glassbox::study {

Result<StudyResults> read_results(const std::string& path);
Result<void> write_results(const std::string& path, const StudyResults& results);

// What the file has, to go on from: nothing where there is no file, an error where its results have another origin.
Result<StudyResults> resume(const std::string& path, const Origin& origin);

// "the machine is 'A' there and 'B' here"; empty where both are the same.
std::string first_difference(const Origin& there, const Origin& here);

// Null where the results do not have the experiment.
const ExperimentResult* find_result(const StudyResults& results, const std::string& id);

}  // namespace glassbox::study
