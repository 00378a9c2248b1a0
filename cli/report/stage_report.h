// The stages of a run, with what went in and what came out, as text and as JSON.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/render/engine/statistics.h>
#include <glassbox/render/renderer.h>

namespace glassbox {

// A table with one line per stage, in order, of the engine's counts (docs/engines.md).
std::string stage_table(const Statistics& statistics, EngineKind engine);

// A table of the stages' times.
std::string time_table(const Statistics& statistics);

// The number with separators: 1234567 -> "1,234,567".
std::string with_separators(std::uint64_t n);

nlohmann::ordered_json to_json(const Statistics& statistics);

}  // namespace glassbox
