// The stages of a run, what went in and what came out, for people and for machines.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <glassbox/render/statistics.h>

namespace glassbox::app {

// A table of one line per stage, in order.
std::string stage_table(const Statistics& statistics);

nlohmann::ordered_json to_json(const Statistics& statistics);

}  // namespace glassbox::app
