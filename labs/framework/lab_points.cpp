#include "labs/framework/lab_points.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "labs/framework/sources.h"

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

auto refused(const fs::path& file, const std::string& cause) {
  return fail(file.string(), cause,
              "write entries in the form {\"points\": 100, \"tasks\": {\"5.1\": 15}, \"checks\": "
              "{}, \"hidden\": {}}");
}

bool is_weight(const OrderedJson& json) {
  return json.is_number() && json.get<double>() >= 0 && json.get<double>() <= 1e6;
}

// Whether `json` has no entries but the five known ones, each of the right type.
bool has_shape(const OrderedJson& json) {
  if (!json.is_object()) return false;
  for (const auto& [name, value] : json.items()) {
    if (name == "points") {
      if (!is_weight(value)) return false;
    } else if (name == "tasks" || name == "checks" || name == "hidden") {
      if (!value.is_object() || !std::all_of(value.begin(), value.end(), is_weight)) return false;
    } else if (name == "whole") {
      const auto is_name = [](const OrderedJson& each) { return each.is_string(); };
      if (!value.is_array() || !std::all_of(value.begin(), value.end(), is_name)) return false;
    } else {
      return false;
    }
  }
  return true;
}

Task* find_task(Lab& lab, const std::string& id) {
  for (Task& task : lab.tasks) {
    if (task.id == id) return &task;
  }
  return nullptr;
}

void set_tasks(const OrderedJson& json, LabPoints& lab_points) {
  if (!json.contains("tasks")) return;
  for (const auto& [id, points] : json["tasks"].items()) {
    if (Task* task = find_task(lab_points.lab, id)) {
      task->points = points.get<double>();
    } else {
      lab_points.warnings.push_back(fmt::format("points.json: the lab has no task {}", id));
    }
  }
  for (const Task& task : lab_points.lab.tasks) {
    if (!json["tasks"].contains(task.id))
      lab_points.warnings.push_back(
          fmt::format("points.json: there is no entry for task {}, which keeps its {:g} points",
                      task.id, task.points));
  }
}

// The visible check called `name`; null if there is none, which adds a warning.
Check* find_check(LabPoints& lab_points, const std::string& name) {
  for (Check& check : lab_points.lab.checks) {
    if (check.name == name && !check.hidden) return &check;
  }
  lab_points.warnings.push_back(
      fmt::format("points.json: the lab has no visible check \"{}\"", name));
  return nullptr;
}

void set_checks(const OrderedJson& json, LabPoints& lab_points) {
  if (json.contains("checks")) {
    for (const auto& [name, weight] : json["checks"].items()) {
      if (Check* check = find_check(lab_points, name)) check->weight = weight.get<double>();
    }
  }
  if (json.contains("whole")) {
    for (const OrderedJson& name : json["whole"]) {
      if (Check* check = find_check(lab_points, name.get<std::string>()))
        check->all_or_nothing = true;
    }
  }
}

void set_hidden(const OrderedJson& json, LabPoints& lab_points) {
  if (!json.contains("hidden")) return;
  for (const auto& [id, weight] : json["hidden"].items()) {
    const auto is_of_task = [&, &task = id](const Check& check) {
      return check.hidden && check.task == task;
    };
    auto& checks = lab_points.lab.checks;
    const auto count = std::count_if(checks.begin(), checks.end(), is_of_task);
    if (count == 0)
      lab_points.warnings.push_back(fmt::format("points.json: task {} has no hidden check", id));
    for (Check& check : checks) {
      if (is_of_task(check)) check.weight = weight.get<double>() / double(count);
    }
  }
}

void compare_sums(const OrderedJson& json, LabPoints& lab_points) {
  double sum = 0;
  for (const Task& task : lab_points.lab.tasks) {
    sum += task.points;
    double weights = 0;
    for (const Check& check : lab_points.lab.checks)
      weights += check.task == task.id ? check.weight : 0;
    if (weights == 0 && task.points > 0)
      lab_points.warnings.push_back(
          fmt::format("points.json: no check of task {} has a weight above 0, so nobody can get "
                      "its {:g} points",
                      task.id, task.points));
  }
  const double stated = json.value("points", sum);
  // compared with a tolerance because the numbers are decimal fractions
  if (std::abs(sum - stated) > 1e-9 * stated)
    lab_points.warnings.push_back(
        fmt::format("points.json: the points of the tasks add up to {:g}, but \"points\" is {:g}",
                    sum, stated));
}

}  // namespace

Result<LabPoints> read_lab_points(const Lab& lab, const fs::path& file) {
  LabPoints lab_points{lab, {}};
  std::error_code error;
  if (!fs::exists(file, error)) return lab_points;
  const auto text = read_text_file(file);
  if (!text) return tl::unexpected(text.error());
  const OrderedJson json = OrderedJson::parse(*text, nullptr, false);
  if (json.is_discarded()) return refused(file, "is not valid JSON");
  if (!has_shape(json))
    return refused(file,
                   "has an entry other than points, tasks, checks, hidden and whole, or one of the "
                   "wrong type");
  set_tasks(json, lab_points);
  set_checks(json, lab_points);
  set_hidden(json, lab_points);
  compare_sums(json, lab_points);
  return lab_points;
}

double points_of_case(const Lab& lab, const Check& check, std::size_t cases) {
  double weights = 0, points = 0;
  for (const Check& each : lab.checks) weights += each.task == check.task ? each.weight : 0;
  for (const Task& task : lab.tasks) points += task.id == check.task ? task.points : 0;
  return weights > 0 && cases > 0 ? points * check.weight / weights / double(cases) : 0;
}

}  // namespace glassbox::labs
