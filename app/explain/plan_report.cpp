#include "app/explain/plan_report.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/stage_report.h"
#include "cli/report/text_layout.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/render/plan/decisions.h>

namespace glassbox::app {

// Draws of a plan that are reported together, because the same decisions were made for them.
struct DrawGroup {
  std::string method;                // drawn in SIMD lanes, drawn by the staged code, or not drawn
  std::vector<Decision> decisions;   // with the numbers of the largest draw of the group
  std::vector<std::uint32_t> draws;  // indices into the draw list, the largest first
  std::uint64_t triangles = 0;
};

namespace {

std::string key_of(const std::string& method, const std::vector<Decision>& decisions) {
  std::string key = method;
  for (const Decision& d : decisions) key += fmt::format("\n{}{}{}", d.stage, d.needed, d.because);
  return key;
}

}  // namespace

// Returns the groups, the one with the most triangles first. Groups with equally many triangles are
// in the order of their first draws.
std::vector<DrawGroup> group_draws(const Plan& plan, const PlannedEye& eye) {
  const std::vector<Draw>& draws = eye.list.draws;
  const auto triangles = [&](std::uint32_t i) { return draws[i].triangulation->triangles.size(); };
  std::vector<DrawGroup> groups;
  std::map<std::string, std::size_t> group_of;
  for (std::uint32_t i = 0; i < draws.size(); ++i) {
    const std::string method = describe_method(plan.methods[i]);
    const auto [found, is_new] =
        group_of.try_emplace(key_of(method, decisions(plan, eye, i)), groups.size());
    if (is_new) groups.push_back({method, {}, {}, 0});
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

namespace {

constexpr std::size_t kShownGroups = 5;
constexpr std::size_t kLongName = 40;

std::string line_of(const Decision& d) {
  const std::string first =
      fmt::format("  {:<9} {:<24}", d.needed ? "needed" : "left out", d.stage);
  return wrapped(first, d.because + (d.numbers.empty() ? "" : "; " + d.numbers));
}

// One line per decision, the stages that are left out first.
std::string lines_of(const std::vector<Decision>& decisions) {
  std::string text;
  for (const bool needed : {false, true}) {
    for (const Decision& d : decisions) {
      if (d.needed == needed) text += line_of(d);
    }
  }
  return text;
}

std::string counted_with_separators(std::uint64_t count, const std::string& thing) {
  return with_separators(count) + " " + singular_or_plural(count, thing);
}

const std::string& name_of(const Scene& scene, const Draw& draw) {
  return scene.nodes[scene.instances[draw.instance].node].name;
}

std::string title_of(const Scene& scene, const PlannedEye& eye, const DrawGroup& group) {
  const Draw& largest = eye.list.draws[group.draws.front()];
  const std::string name = printable(name_of(scene, largest), kLongName);
  std::string title = counted_with_separators(group.draws.size(), "draw");
  if (!name.empty()) title += (group.draws.size() == 1 ? ", " : ", the largest ") + name;
  return title + ", " + counted_with_separators(group.triangles, "triangle") + ": ";
}

}  // namespace

std::string plan_text(const Scene& scene, const Plan& plan, const PlannedEye& eye) {
  std::string text = "the picture\n" + lines_of(decisions(plan, eye));
  const std::vector<DrawGroup> groups = group_draws(plan, eye);
  std::uint64_t draws_not_shown = 0, triangles_not_shown = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (i >= kShownGroups) {
      draws_not_shown += groups[i].draws.size();
      triangles_not_shown += groups[i].triangles;
      continue;
    }
    text += "\n" + wrapped("", title_of(scene, eye, groups[i]) + groups[i].method);
    text += lines_of(groups[i].decisions);
  }
  if (draws_not_shown > 0) {
    text += fmt::format("\nand {} more, which have {} with {}: --json lists them all\n",
                        counted_with_separators(groups.size() - kShownGroups, "group"),
                        counted_with_separators(draws_not_shown, "draw"),
                        counted_with_separators(triangles_not_shown, "triangle"));
  }
  return text;
}

namespace {

nlohmann::ordered_json to_json(const std::vector<Decision>& decisions) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Decision& d : decisions) {
    json.push_back({{"stage", d.stage}, {"needed", d.needed}, {"because", d.because}});
    if (!d.numbers.empty()) json.back()["numbers"] = d.numbers;
  }
  return json;
}

}  // namespace

nlohmann::ordered_json to_json(const Plan& plan, const PlannedEye& eye) {
  nlohmann::ordered_json groups = nlohmann::ordered_json::array();
  for (const DrawGroup& group : group_draws(plan, eye)) {
    nlohmann::ordered_json instances = nlohmann::ordered_json::array();
    for (const std::uint32_t i : group.draws) instances.push_back(eye.list.draws[i].instance);
    groups.push_back({{"way", group.method},
                      {"triangles", group.triangles},
                      {"instances", std::move(instances)},
                      {"decisions", to_json(group.decisions)}});
  }
  return {{"picture", to_json(decisions(plan, eye))}, {"draws", std::move(groups)}};
}

void plan_pictures(const PictureJob& job, const TileOptions& options, PlannedPictures& planned) {
  PlannedPicture picture;
  plan_picture(job.scene, job.prepared, job.eyes, options.planner, options.plan, picture);
  for (std::size_t i = 0; i < picture.plans.size(); ++i) {
    planned.texts.push_back(plan_text(job.scene, picture.plans[i], picture.eyes[i]));
    planned.json.push_back(to_json(picture.plans[i], picture.eyes[i]));
  }
}

PlanningEngine::PlanningEngine(const TileOptions& options, PlannedPictures& planned)
    : options_(options), engine_(options), planned_(planned) {}

PairCullCounts PlanningEngine::draw(const PictureJob& job) {
  plan_pictures(job, options_, planned_);
  engine_.render(job.scene, job.prepared, job.eyes);
  engine_.render(job.scene, job.prepared, job.eyes, &planned_.report);
  return {};
}

}  // namespace glassbox::app
