// What is measured on a scene to recommend a way to draw it, and the recommendation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/options/picture_options.h"
#include "app/report/progress.h"
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

struct Recommendation {
  std::string scene, machine, compiler;
  Size size;
  std::vector<Judged> judged;
  std::string command;  // draws with what is recommended

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
