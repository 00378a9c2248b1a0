// The stages of a run, what went in and what came out, for people and for machines.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/render/engine/statistics.h>
#include <glassbox/render/renderer.h>

namespace glassbox::app {

// A table of one line per stage, in order, of what the engine counts (docs/engines.md).
std::string stage_table(const Statistics& statistics, EngineKind engine);

// How long the stages took.
std::string time_table(const Statistics& statistics);

// 1234567 -> "1,234,567".
std::string grouped(std::uint64_t n);

nlohmann::ordered_json to_json(const Statistics& statistics);

}  // namespace glassbox::app
