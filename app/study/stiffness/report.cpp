#include "app/study/stiffness/report.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/report/number_json.h"
#include "app/report/shell_line.h"
#include "app/report/text_layout.h"
#include "app/report/value_text.h"
#include "stiffness_page.h"  // made by html/embed.cmake

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/html/blob.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;
using study::StiffNumber;
using study::StiffPlace;

// ---- where ----

std::string name_of_mesh(const Scene& scene, std::uint32_t instance) {
  const std::uint32_t mesh = scene.instances[instance].mesh;
  const std::string& name = scene.meshes[mesh].name;
  return name.empty() ? fmt::format("mesh {}", mesh) : "'" + printable(name) + "'";
}

std::string place_text(const Scene& scene, const StiffPlace& place) {
  std::string text =
      fmt::format("triangle {} of {}", place.triangle, name_of_mesh(scene, place.instance));
  if (place.corner) text += fmt::format(", corner {} (vertex {})", *place.corner, *place.position);
  if (place.x >= 0) text += fmt::format(", pixel {},{}", place.x, place.y);
  return text;
}

std::vector<std::string> words_for(const StiffPlace& place) {
  if (place.x >= 0) return {"--at", fmt::format("{},{}", place.x, place.y)};
  std::vector<std::string> words{"--triangle", fmt::format("{}", place.triangle)};
  if (place.corner) {
    words.push_back("--vertex");
    words.push_back(fmt::format("{}", *place.corner));
  }
  return words;
}

// What shows the place; empty for standard input.
std::string command_for(const StiffnessReport& report, const StiffPlace& place) {
  if (report.scene == "-") return {};
  return shell_line(
      {{place.x >= 0 ? "pixel" : "step", report.scene}, report.picture, words_for(place)});
}

// ---- text ----

// Conditions may really be infinite: far over near.
std::string condition_text(double value) {
  return std::isinf(value) ? "infinite" : fmt::format("{:.4g}", value);
}

std::string pixels_text(const StiffNumber& number) {
  return number.pixels ? number_or_unknown(*number.pixels) + " px" : "";
}

std::string errors_text(const StiffNumber& number) {
  if (!std::isfinite(number.bound)) return "errors without a bound";
  return "errors of up to " + (number.pixels ? pixels_text(number)
                                             : number_or_unknown(number.bound) + " " + number.unit);
}

std::string doubt_text(std::uint64_t tests) {
  if (tests == 0) return "no depth test of this picture depends on it";
  return fmt::format("{} of this picture may go the other way", counted(tests, "depth test"));
}

std::string number_lines(const Scene& scene, const StiffnessReport& report,
                         const StiffNumber& number) {
  const std::string bound =
      std::isfinite(number.bound) ? number_or_unknown(number.bound) + " " + number.unit : "none";
  std::string text =
      fmt::format("{}{:<34}{:>12}{:>24}{:>14}\n", number.passes() ? "! " : "  ", number.name,
                  condition_text(number.condition), bound, pixels_text(number));
  text += wrapped("      bound  ", number.formula + " (" + number.source + ")");
  if (number.place) {
    text += wrapped("      worst  ", place_text(scene, *number.place));
    const std::string command = command_for(report, *number.place);
    if (!command.empty()) text += "             " + command + "\n";
  }
  if (number.tests_in_doubt) {
    text += wrapped("      seen   ", doubt_text(*number.tests_in_doubt));
  }
  return text + wrapped("      to do  ", number.advice);
}

// ---- JSON ----

Json place_json(const Scene& scene, const StiffnessReport& report, const StiffPlace& place) {
  const std::uint32_t mesh = scene.instances[place.instance].mesh;
  Json json{{"instance", place.instance},
            {"mesh", mesh},
            {"mesh_name", scene.meshes[mesh].name},
            {"triangle", place.triangle}};
  if (place.corner) json["corner"] = *place.corner;
  if (place.position) json["vertex"] = *place.position;
  if (place.x >= 0) json["pixel"] = {place.x, place.y};
  json["text"] = place_text(scene, place);
  json["command"] = command_for(report, place);
  return json;
}

Json number_json(const Scene& scene, const StiffnessReport& report, const StiffNumber& number) {
  Json json{{"key", number.key},
            {"name", number.name},
            {"condition", finite_json(number.condition)},
            {"bound", finite_json(number.bound)},
            {"unit", number.unit}};
  json["pixels"] = number.pixels ? finite_json(*number.pixels) : Json(nullptr);
  json["passes"] = number.passes();
  json["formula"] = number.formula;
  json["source"] = number.source;
  json["worst"] = number.place ? place_json(scene, report, *number.place) : Json(nullptr);
  if (number.tests_in_doubt) {
    json["tests_in_doubt"] = *number.tests_in_doubt;
    json["seen"] = doubt_text(*number.tests_in_doubt);
  }
  json["advice"] = number.advice;
  return json;
}

}  // namespace

std::optional<Vector<World, double>> up_of(const Scene& scene, const CameraOptions& options) {
  const bool has_place = options.eye || options.look_at;
  const bool has_pose = options.camera ? *options.camera != "none" : !scene.cameras.empty();
  if (has_pose && !has_place && !options.up) return {};
  const std::array<double, 3> up = options.up.value_or(std::array<double, 3>{0, 1, 0});
  return Vector<World, double>(up[0], up[1], up[2]);
}

std::string stiffness_text(const Scene& scene, const StiffnessReport& report) {
  std::string text = fmt::format("{}, {} x {}: what decides how exact this view is\n",
                                 printable(report.scene, 1000), report.width, report.height);
  text += fmt::format("  {:<34}{:>12}{:>24}{:>14}\n", "", "condition", "bound", "on the screen");
  for (const StiffNumber& number : report.found.numbers) {
    text += number_lines(scene, report, number);
  }
  if (report.found.numbers.empty()) text += "  nothing of the scene is in this picture\n";
  text += "left out\n";
  for (const std::string& one : report.found.left_out) text += wrapped("  ", one);
  return text;
}

Json stiffness_json(const Scene& scene, const StiffnessReport& report) {
  Json numbers = Json::array();
  for (const StiffNumber& number : report.found.numbers) {
    numbers.push_back(number_json(scene, report, number));
  }
  return {{"schema", "glassbox-stiffness/1"},
          {"scene", report.scene},
          {"width", report.width},
          {"height", report.height},
          {"numbers", std::move(numbers)},
          {"left_out", report.found.left_out}};
}

std::string stiffness_page(const Scene& scene, const StiffnessReport& report,
                           const std::string& command) {
  Json manifest = stiffness_json(scene, report);
  manifest["program"] = "glassbox " GLASSBOX_VERSION;
  manifest["command"] = command;
  return assemble_page(kStiffnessPage, "glassbox study stiffness",
                       json_block("manifest", manifest));
}

std::vector<std::string> stiffness_warnings(const Scene& scene, const study::Stiffness& found) {
  std::vector<std::string> lines;
  for (const StiffNumber& number : found.numbers) {
    if (!number.passes()) continue;
    std::string line = fmt::format("warning: {} is {}: {}", number.name,
                                   condition_text(number.condition), errors_text(number));
    if (number.tests_in_doubt) line += ", " + doubt_text(*number.tests_in_doubt) + ", worst";
    if (number.place) line += " at " + place_text(scene, *number.place);
    lines.push_back(line + "; " + number.advice);
  }
  return lines;
}

}  // namespace glassbox::app
