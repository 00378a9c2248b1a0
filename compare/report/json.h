// Comparisons as JSON. docs/diff.md has the schema.
#pragma once

#include <span>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/compare/pictures/comparison.h>

namespace glassbox {

// "same", "within-tolerance", "different", "new", "missing", "uncompared".
const char* verdict_word(Verdict verdict);

nlohmann::ordered_json to_json(const Comparison& comparison);

// {"schema": "glassbox-diff-1", "summary": counts by verdict, "pictures": [...]}.
nlohmann::ordered_json json_report(std::span<const Comparison> comparisons);

}  // namespace glassbox
