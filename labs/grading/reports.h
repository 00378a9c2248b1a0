// Reports for other services, made from results.json. They contain nothing about hidden checks
// except a name where one is needed.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace glassbox::labs::grading {

// JUnit XML, as continuous integration systems read it: a test case for each visible check.
std::string junit_xml(const nlohmann::ordered_json& results);

// The text that Moodle's Virtual Programming Lab reads from an evaluation
// (https://vpl.dis.ulpgc.es, "Evaluation output"): a comment for each visible check, and their
// points as a grade out of `most`.
std::string vpl_text(const nlohmann::ordered_json& results, double most);

}  // namespace glassbox::labs::grading
