#include "study/recommend/candidates.h"

#include <tuple>

namespace glassbox::study {

std::optional<std::size_t> cheapest(const std::vector<Candidate>& candidates, double limit) {
  const auto fits = [&](const Candidate& each) { return each.ns && each.error < limit; };
  const Candidate* fastest = nullptr;
  for (const Candidate& each : candidates) {
    if (fits(each) && (fastest == nullptr || each.ns->median < fastest->ns->median))
      fastest = &each;
  }
  if (fastest == nullptr) return std::nullopt;
  std::optional<std::size_t> best;
  const auto rank = [](const Candidate& each) { return std::tuple(!each.in_render, each.error); };
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& each = candidates[i];
    if (!fits(each) || each.ns->lower > fastest->ns->upper) continue;
    if (!best || rank(each) < rank(candidates[*best])) best = i;
  }
  return best;
}

}  // namespace glassbox::study
