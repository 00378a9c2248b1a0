#include "labs/commands/list.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/program_name.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

double points_of(const labs::Lab& lab) {
  double points = 0;
  for (const labs::Task& task : lab.tasks) points += task.points;
  return points;
}

}  // namespace

nlohmann::ordered_json labs_json() {
  auto all = nlohmann::ordered_json::array();
  for (const labs::Lab& lab : labs::all_labs()) {
    auto tasks = nlohmann::ordered_json::array();
    for (const labs::Task& task : lab.tasks)
      tasks.push_back({{"id", task.id}, {"title", task.title}, {"points", task.points}});
    all.push_back({{"number", lab.number},
                   {"folder", lab.folder},
                   {"title", lab.title},
                   {"points", points_of(lab)},
                   {"tasks", std::move(tasks)}});
  }
  return all;
}

std::string labs_text() {
  std::string text;
  for (const labs::Lab& lab : labs::all_labs()) {
    text += fmt::format("{:<4}{} ({:g} points)\n", lab.number, lab.title, points_of(lab));
    for (const labs::Task& task : lab.tasks)
      text += fmt::format("    {:<5}{:<58}{:>6g}\n", task.id, task.title, task.points);
  }
  if (text.empty()) text = "No lab is built into this program.\n";
  return text + fmt::format("\n{} lab start NUMBER FOLDER begins one.\n", program_name());
}

}  // namespace glassbox::labs
