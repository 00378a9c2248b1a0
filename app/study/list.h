// The experiments and what they ask.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace glassbox::app {

std::string experiments_text();
nlohmann::ordered_json experiments_json();

}  // namespace glassbox::app
