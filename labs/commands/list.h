// glassbox lab list: the labs, their tasks and points.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace glassbox::labs {

std::string labs_text();
nlohmann::ordered_json labs_json();

}  // namespace glassbox::labs
