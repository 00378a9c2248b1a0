// glassbox lab list: the labs, their tasks and points.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace glassbox::app {

std::string labs_text();
nlohmann::ordered_json labs_json();

}  // namespace glassbox::app
