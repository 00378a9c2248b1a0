// What is measured on a scene to recommend a way to draw it, and the recommendation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/options/picture_options.h"
#include "app/report/progress.h"
#include "study/bench/statistics.h"
#include "study/recommend/candidates.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::app {

// One budget, all candidates for it, and the one that is recommended: none where none is accurate enough.
struct Judged {
  study::Budget budget;
  study::Comparison comparison;
  std::optional<std::size_t> chosen;
};

// All that is recommended, in one picture.
struct Together {
  std::vector<std::string> options;   // of glassbox render
  study::Quartiles ns;                // of a frame, with one thread
  std::optional<double> color_error;  // where there is a budget for it
};

struct Recommendation {
  std::string scene, machine, compiler;
  Size size;
  std::vector<Judged> judged;
  Together together;
  std::string command;  // draws so

  bool meets_all() const;
};

// Measures what the budgets ask for, and nothing else. `words` are the scene and the options that decide on the view.
Result<Recommendation> recommend(const Scene& scene, const PictureOptions& picture,
                                 const std::vector<study::Budget>& budgets,
                                 const std::vector<std::string>& words, Progress& progress);

std::string recommendation_text(const Recommendation& recommendation);
// docs/study.md has the fields.
nlohmann::ordered_json recommendation_json(const Recommendation& recommendation);

}  // namespace glassbox::app
