// Results in the forms that grading services read.
//
// Gradescope: https://gradescope-autograders.readthedocs.io/en/latest/specs/, "Output format".
// GitHub Classroom: what github.com/classroom-resources/autograding-grading-reporter reads, in
// base64, from a runner.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "labs/grading/grade.h"

namespace glassbox::labs::grading {

inline constexpr const char* kUnfinished = "grading did not finish";

// results.json. There is one test for each check. A hidden check is shown when grades are
// published. Nothing else that students see depends on a hidden check, so there is no total. What
// the grader knows beyond Gradescope's fields is in extra_data, which students do not see. The JSON
// does not depend on when or where it was made. `confinement` is Sandbox::description(), `digest` a
// digest of everything that the result depends on.
nlohmann::ordered_json gradescope_json(const GradedSubmission& graded,
                                       const std::string& confinement,
                                       const std::string& digest = {});

// results.json of a submission of which nothing is known yet, not even the lab.
nlohmann::ordered_json unfinished_json();

// The sum of the points in results.json.
double total_of(const nlohmann::ordered_json& results);

// The report for GitHub Classroom, made from results.json. All hidden checks together are one test,
// which has their points and none of their names: whoever reads a repository reads this report.
nlohmann::ordered_json classroom_json(const nlohmann::ordered_json& results);

// The JSON as text; bytes that are not valid UTF-8 are replaced.
std::string text_of(const nlohmann::ordered_json& json);

// The text about a check that a student reads.
std::string explanation(const CheckResult& check, const std::string& name);

}  // namespace glassbox::labs::grading
