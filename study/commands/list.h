// glassbox study list: the experiments, and the question that each answers.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace glassbox::study {

std::string experiments_text();
nlohmann::ordered_json experiments_json();

}  // namespace glassbox::study
