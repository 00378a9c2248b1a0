#include "app/explain/draw_groups.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace glassbox::app {

namespace {

std::string key_of(const std::string& way, const std::vector<Decision>& decisions) {
  std::string key = way;
  for (const Decision& d : decisions) key += fmt::format("\n{}{}{}", d.stage, d.needed, d.because);
  return key;
}

}  // namespace

std::vector<DrawGroup> group_draws(const Plan& plan, const PlannedEye& eye) {
  const std::vector<Draw>& draws = eye.list.draws;
  const auto triangles = [&](std::uint32_t i) { return draws[i].triangulation->triangles.size(); };
  std::vector<DrawGroup> groups;
  std::map<std::string, std::size_t> group_of;
  for (std::uint32_t i = 0; i < draws.size(); ++i) {
    const std::string way = way_of(plan.methods[i]);
    const auto [found, is_new] =
        group_of.try_emplace(key_of(way, decisions(plan, eye, i)), groups.size());
    if (is_new) groups.push_back({way, {}, {}, 0});
    DrawGroup& group = groups[found->second];
    group.draws.push_back(i);
    group.triangles += triangles(i);
  }
  for (DrawGroup& group : groups) {
    std::ranges::stable_sort(
        group.draws, [&](std::uint32_t a, std::uint32_t b) { return triangles(a) > triangles(b); });
    group.decisions = decisions(plan, eye, group.draws.front());
  }
  std::ranges::stable_sort(
      groups, [](const DrawGroup& a, const DrawGroup& b) { return a.triangles > b.triangles; });
  return groups;
}

}  // namespace glassbox::app
