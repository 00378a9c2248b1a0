// The rules for comparing one pair: the given options, and what the sidecar of the reference adds
// to them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/compare/pictures/sidecar.h>

namespace glassbox {

struct ComparisonRules {
  CompareOptions options;
  bool tolerance_of_sidecar = false;
  std::string sidecar_path;  // empty: none
  std::string reason;        // of the sidecar's tolerance
};

// Adds the sidecar's boxes to the options, and its mask if the options have no mask. The sidecar's
// tolerance is used unless the options have a tolerance; then a note is added.
ComparisonRules combine_rules(const CompareOptions& options, const std::optional<Sidecar>& sidecar,
                              std::vector<std::string>& notes);

bool has_limit(const std::vector<MetricRequest>& metrics);

// The tolerances as one would write them on the command line; empty: none. `sizes_differ`: that
// other sizes may pass is one of them.
std::string tolerance_text(const CompareOptions& options, bool sizes_differ = false);

// A sentence that says that the sidecar's tolerance allows more than these differences need; empty
// if it does not.
std::string stale_tolerance_text(const ComparisonRules& rules, const Differences& found);

}  // namespace glassbox
