#include "study/recommend/candidates.h"

#include <algorithm>

namespace glassbox::study {

std::optional<std::size_t> cheapest(const std::vector<Candidate>& candidates, double limit) {
  const auto is_accurate = [&](const Candidate& each) { return each.ns && each.error < limit; };
  const bool any_in_render = std::ranges::any_of(
      candidates, [&](const Candidate& each) { return each.in_render && is_accurate(each); });
  const auto fits = [&](const Candidate& each) {
    return is_accurate(each) && each.in_render == any_in_render;
  };
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

}  // namespace glassbox::study
