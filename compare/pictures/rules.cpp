#include <glassbox/compare/pictures/rules.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace glassbox {

namespace {

bool has_tolerance(const Sidecar& sidecar) {
  return !sidecar.tolerance.empty() || has_limit(sidecar.metrics);
}

}  // namespace

bool has_limit(const std::vector<MetricRequest>& metrics) {
  return std::any_of(metrics.begin(), metrics.end(),
                     [](const MetricRequest& metric) { return metric.limit.has_value(); });
}

ComparisonRules combine_rules(const CompareOptions& options, const std::optional<Sidecar>& sidecar,
                              std::vector<std::string>& notes) {
  ComparisonRules rules;
  rules.options = options;
  if (!sidecar) return rules;
  rules.sidecar_path = sidecar->path;
  rules.options.ignore.insert(rules.options.ignore.end(), sidecar->ignore.begin(),
                              sidecar->ignore.end());
  if (rules.options.mask.empty()) rules.options.mask = sidecar->mask;
  if (!options.tolerance.empty() || has_limit(options.metrics)) {
    if (has_tolerance(*sidecar)) {
      notes.push_back("the tolerance of " + sidecar->path +
                      " is not used, because another one is given");
    }
    return rules;
  }
  rules.tolerance_of_sidecar = has_tolerance(*sidecar);
  rules.reason = sidecar->reason;
  rules.options.tolerance = sidecar->tolerance;
  rules.options.metrics.insert(rules.options.metrics.end(), sidecar->metrics.begin(),
                               sidecar->metrics.end());
  return rules;
}

std::string tolerance_text(const CompareOptions& options, bool sizes_differ) {
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (options.tolerance.fuzzy) add(to_string(*options.tolerance.fuzzy));
  if (options.tolerance.max_ulp) add(fmt::format("{} ulps", *options.tolerance.max_ulp));
  const auto& [threshold, moved_edges] = options.tolerance.set_aside;
  if (threshold) add(fmt::format("threshold {}", *threshold));
  if (options.tolerance.max_differing) {
    add("at most " + to_string(*options.tolerance.max_differing) + " differing pixels");
  }
  if (moved_edges) add("moved edges are ignored");
  for (const MetricRequest& metric : options.metrics) {
    if (metric.limit) add(to_string(metric));
  }
  if (sizes_differ && options.ignore_size) add("different sizes are ignored");
  return text;
}

std::string stale_tolerance_text(const ComparisonRules& rules, const Differences& found) {
  if (!rules.tolerance_of_sidecar) return {};
  const auto& fuzzy = rules.options.tolerance.fuzzy;
  const auto& max_ulp = rules.options.tolerance.max_ulp;
  const auto& most = rules.options.tolerance.max_differing;
  if (!found.has_any()) {
    const bool leaves_out = !rules.options.ignore.empty() || !rules.options.mask.empty();
    return "stale: the tolerance of " + rules.sidecar_path + " is not needed: delete " +
           (leaves_out ? "its lines" : "the file");
  }
  std::vector<std::string> enough;
  if (fuzzy && (found.largest < fuzzy->max_difference.highest ||
                found.differing < fuzzy->total_pixels.highest)) {
    enough.push_back(to_string(lasting_fuzzy(found)));
  }
  if (max_ulp && found.largest < *max_ulp) {
    enough.push_back(fmt::format("max-ulp: {}", found.largest));
  }
  if (most && tightest_like(*most, found) != *most) {
    enough.push_back("max-differing: " + to_string(tightest_like(*most, found)));
  }
  if (rules.options.tolerance.set_aside.moved_edges && found.moved_edges.pixels == 0) {
    enough.push_back("no ignore-antialiasing");
  }
  if (enough.empty()) return {};
  return "stale: " + rules.sidecar_path + " allows more than is needed; enough is " +
         fmt::format("{}", fmt::join(enough, " and "));
}

}  // namespace glassbox
