#include "app/explain/plan_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/explain/draw_groups.h"
#include "cli/report/stage_report.h"
#include "cli/report/text_layout.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

namespace glassbox::app {

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
  return grouped(count) + " " + inflected(count, thing);
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
    text += "\n" + wrapped("", title_of(scene, eye, groups[i]) + groups[i].way);
    text += lines_of(groups[i].decisions);
  }
  if (draws_not_shown > 0) {
    text += fmt::format("\nand {} more of {} with {}: --json has them all\n",
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
    groups.push_back({{"way", group.way},
                      {"triangles", group.triangles},
                      {"instances", std::move(instances)},
                      {"decisions", to_json(group.decisions)}});
  }
  return {{"picture", to_json(decisions(plan, eye))}, {"draws", std::move(groups)}};
}

}  // namespace glassbox::app
