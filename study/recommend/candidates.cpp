#include "study/recommend/candidates.h"

namespace glassbox::study {

std::optional<std::size_t> fastest_candidate(const std::vector<Candidate>& candidates,
                                             double limit) {
  const auto fits = [&](const Candidate& each) { return each.ns && each.error < limit; };
  const Candidate* fastest = nullptr;
  for (const Candidate& each : candidates) {
    if (fits(each) && (fastest == nullptr || each.ns->median < fastest->ns->median))
      fastest = &each;
  }
  if (fastest == nullptr) return std::nullopt;
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& each = candidates[i];
    if (!fits(each) || each.ns->lower > fastest->ns->upper) continue;
    if (!best || each.error < candidates[*best].error) best = i;
  }
  return best;
}

std::optional<std::size_t> first_render_candidate(const std::vector<Candidate>& candidates,
                                                  double limit) {
  for (const bool in_render : {true, false}) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (candidates[i].in_render == in_render && candidates[i].error < limit) return i;
    }
  }
  return std::nullopt;
}

}  // namespace glassbox::study
