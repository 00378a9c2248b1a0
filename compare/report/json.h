// Comparisons as JSON. The schema is in docs/diff.md.
#pragma once

#include <span>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/compare/pictures/comparison.h>

namespace glassbox {

// Returns "same", "within-tolerance", "different", "new", "missing" or "uncompared".
const char* verdict_word(Verdict verdict);

nlohmann::ordered_json to_json(const Comparison& comparison);

// {"schema": "glassbox-diff-1", "summary": counts by verdict, "pictures": [...]}.
nlohmann::ordered_json json_report(std::span<const Comparison> comparisons);

}  // namespace glassbox
