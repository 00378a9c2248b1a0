// Measures a scene to recommend a way of drawing it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/options/picture_options.h"
#include "cli/report/progress.h"
#include "study/bench/statistics.h"
#include "study/recommend/candidates.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::study {

// A budget, all candidates for it, and the recommended candidate; no recommended one if no
// candidate is accurate enough.
struct BudgetResult {
  study::Budget budget;
  study::Comparison comparison;
  std::optional<std::size_t> chosen;
};

// All recommended options used together for one picture.
struct CombinedOptions {
  std::vector<std::string> options;   // options of glassbox render
  study::Quartiles ns;                // time of a frame with one thread
  std::optional<double> color_error;  // set if there is a budget for colour errors
};

struct Recommendation {
  std::string scene, machine, compiler;
  Size size;
  std::vector<BudgetResult> budget_results;
  CombinedOptions combined;
  std::string command;  // the command line that draws with these options

  bool meets_all() const;
};

// Finds a recommendation for each budget and measures only what this needs. `words` are the scene
// and the options that determine the view.
Result<Recommendation> recommend(const Scene& scene, const PictureOptions& picture,
                                 const std::vector<study::Budget>& budgets,
                                 const std::vector<std::string>& words, Progress& progress);

std::string recommendation_text(const Recommendation& recommendation);
// The recommendation as JSON. docs/study.md describes the fields.
nlohmann::ordered_json recommendation_json(const Recommendation& recommendation);

}  // namespace glassbox::study
