// What other services read, made of results.json. Of hidden checks there is nothing in them but a name where it is needed.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace glassbox::labs::grading {

// JUnit's XML, as continuous integration reads it: a test case for each visible check.
std::string junit_xml(const nlohmann::ordered_json& results);

// What Moodle's Virtual Programming Lab reads from an evaluation (https://vpl.dis.ulpgc.es, "Evaluation output"): a comment for each
// visible check, and their points as a grade out of `most`.
std::string vpl_text(const nlohmann::ordered_json& results, double most);

}  // namespace glassbox::labs::grading
