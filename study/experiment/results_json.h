// Results as JSON and back, to the last digit. docs/study.md describes the fields.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/base/error.h>

#include "study/experiment/results.h"

namespace glassbox::study {

// Numbers that JSON does not have stand as "infinity", "-infinity" and "nan".
nlohmann::ordered_json number_json(double value);

// What follows from the results (ratios, findings, standings) is written too, and not read back.
nlohmann::ordered_json results_json(const StudyResults& results);
nlohmann::ordered_json experiment_json(const ExperimentResult& result);

Result<StudyResults> results_of(const nlohmann::ordered_json& json);

}  // namespace glassbox::study
