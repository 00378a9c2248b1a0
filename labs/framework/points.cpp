#include "labs/framework/points.h"

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
              "write {\"points\": 100, \"tasks\": {\"5.1\": 15}, \"checks\": {}, \"hidden\": {}}");
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

Task* task_called(Lab& lab, const std::string& id) {
  for (Task& task : lab.tasks) {
    if (task.id == id) return &task;
  }
  return nullptr;
}

void set_tasks(const OrderedJson& json, Shares& shares) {
  if (!json.contains("tasks")) return;
  for (const auto& [id, points] : json["tasks"].items()) {
    if (Task* task = task_called(shares.lab, id)) {
      task->points = points.get<double>();
    } else {
      shares.warnings.push_back(fmt::format("points.json: the lab has no task {}", id));
    }
  }
  for (const Task& task : shares.lab.tasks) {
    if (!json["tasks"].contains(task.id))
      shares.warnings.push_back(
          fmt::format("points.json: there is no entry for task {}, which keeps its {:g} points",
                      task.id, task.points));
  }
}

// The visible check of that name; null, with a warning, where there is none.
Check* check_called(Shares& shares, const std::string& name) {
  for (Check& check : shares.lab.checks) {
    if (check.name == name && !check.hidden) return &check;
  }
  shares.warnings.push_back(fmt::format("points.json: the lab has no visible check \"{}\"", name));
  return nullptr;
}

void set_checks(const OrderedJson& json, Shares& shares) {
  if (json.contains("checks")) {
    for (const auto& [name, weight] : json["checks"].items()) {
      if (Check* check = check_called(shares, name)) check->weight = weight.get<double>();
    }
  }
  if (json.contains("whole")) {
    for (const OrderedJson& name : json["whole"]) {
      if (Check* check = check_called(shares, name.get<std::string>())) check->whole = true;
    }
  }
}

void set_hidden(const OrderedJson& json, Shares& shares) {
  if (!json.contains("hidden")) return;
  for (const auto& [id, weight] : json["hidden"].items()) {
    const auto is_of_task = [&, &task = id](const Check& check) {
      return check.hidden && check.task == task;
    };
    auto& checks = shares.lab.checks;
    const auto count = std::count_if(checks.begin(), checks.end(), is_of_task);
    if (count == 0)
      shares.warnings.push_back(fmt::format("points.json: task {} has no hidden check", id));
    for (Check& check : checks) {
      if (is_of_task(check)) check.weight = weight.get<double>() / double(count);
    }
  }
}

void compare_sums(const OrderedJson& json, Shares& shares) {
  double sum = 0;
  for (const Task& task : shares.lab.tasks) {
    sum += task.points;
    double weights = 0;
    for (const Check& check : shares.lab.checks)
      weights += check.task == task.id ? check.weight : 0;
    if (weights == 0 && task.points > 0)
      shares.warnings.push_back(
          fmt::format("points.json: no check of task {} has a weight above 0, so nobody can get "
                      "its {:g} points",
                      task.id, task.points));
  }
  const double said = json.value("points", sum);
  // compared with a tolerance because the numbers are decimal fractions
  if (std::abs(sum - said) > 1e-9 * said)
    shares.warnings.push_back(
        fmt::format("points.json: the points of the tasks add up to {:g}, not to {:g}", sum, said));
}

}  // namespace

Result<Shares> read_shares(const Lab& lab, const fs::path& file) {
  Shares shares{lab, {}};
  std::error_code error;
  if (!fs::exists(file, error)) return shares;
  const auto text = read_text_file(file);
  if (!text) return tl::unexpected(text.error());
  const OrderedJson json = OrderedJson::parse(*text, nullptr, false);
  if (json.is_discarded()) return refused(file, "is not valid JSON");
  if (!has_shape(json))
    return refused(
        file,
        "has entries other than points, tasks, checks, hidden and whole, or of the wrong type");
  set_tasks(json, shares);
  set_checks(json, shares);
  set_hidden(json, shares);
  compare_sums(json, shares);
  return shares;
}

double points_of_case(const Lab& lab, const Check& check, std::size_t cases) {
  double weights = 0, points = 0;
  for (const Check& each : lab.checks) weights += each.task == check.task ? each.weight : 0;
  for (const Task& task : lab.tasks) points += task.id == check.task ? task.points : 0;
  return weights > 0 && cases > 0 ? points * check.weight / weights / double(cases) : 0;
}

}  // namespace glassbox::labs
