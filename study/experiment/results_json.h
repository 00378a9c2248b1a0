// Writes results as JSON and reads them back, exact to the last digit. docs/study.md describes the
// fields.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/base/error.h>

#include "study/experiment/results.h"

namespace glassbox::study {

// JSON has no infinity or NaN, so these are written as "infinity", "-infinity" and "nan".
nlohmann::ordered_json number_json(double value);

// The output also contains values that follow from the results (ratios, findings, standings); they
// are ignored when it is read back.
nlohmann::ordered_json results_json(const StudyResults& results);
nlohmann::ordered_json experiment_json(const ExperimentResult& result);

Result<StudyResults> results_of(const nlohmann::ordered_json& json);

}  // namespace glassbox::study
