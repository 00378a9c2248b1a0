#include "app/why/matrix_suspicions.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

#include "cli/report/text_layout.h"

#include <glassbox/mesh/bounding_box.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox::app {

namespace {

// The corners of the scene's bounding box and its middle, in the space that the model matrix starts
// from; nothing if the scene is empty or the matrix has no inverse.
std::vector<CheckedPoint> points_of_box(const Scene& scene, const GivenMatrix& model) {
  const Box<World> box = bounds(scene);
  const auto object_from_world = affine::inverse(model.m);
  if (box.empty() || !object_from_world) return {};
  std::vector<CheckedPoint> points;
  const auto add = [&](const Point<World, double>& p) {
    points.push_back({*object_from_world * glm::dvec4(p.x, p.y, p.z, 1), std::nullopt});
  };
  for (int i = 0; i < 8; ++i) add(box.corner(i));
  add(box.center());
  return points;
}

}  // namespace

MatrixSuspicions suspect_matrices(const Scene& scene, const PictureOptions& picture) {
  MatrixSuspicions found;
  if (!picture.matrices.projection.given) return found;
  MatrixSetup setup = setup_of(picture.matrices).setup;
  setup.picture = glm::ivec2(picture.size.width, picture.size.height);
  std::ranges::copy_if(check_matrices(setup), std::back_inserter(found.alarms),
                       [](const Finding& one) { return one.severity == Severity::kAlarm; });
  const std::vector<CheckedPoint> points = points_of_box(scene, setup.model);
  if (points.empty()) return found;
  const Viewport window =
      window_rectangle(setup.dialect, 0, 0, float(picture.size.width), float(picture.size.height));
  found.conventions = check_conventions(setup, window, points);
  return found;
}

std::string suspicions_text(const MatrixSuspicions& found) {
  std::string text;
  for (const Finding& alarm : found.alarms) {
    const std::string place = *alarm.matrix == '\0' ? "" : std::string(alarm.matrix) + ": ";
    text += wrapped("  MATRIX ", place + alarm.cause);
    if (!alarm.remedy.empty()) text += wrapped("      -> ", alarm.remedy);
  }
  if (found.conventions.alternatives.empty()) return text;
  const Alternative& likeliest = found.conventions.alternatives.front();
  text += wrapped("  LIKELY ",
                  fmt::format("{}: then {} of {} points of the scene's bounding box are in the "
                              "picture, not {}",
                              likeliest.what, likeliest.points, found.conventions.points,
                              found.conventions.visible));
  for (const std::string& reason : likeliest.reasons) text += wrapped("      because ", reason);
  return text + wrapped("      -> ", likeliest.remedy);
}

nlohmann::ordered_json suspicions_json(const MatrixSuspicions& found) {
  nlohmann::ordered_json json{{"alarms", nlohmann::ordered_json::array()},
                              {"points", found.conventions.points},
                              {"visible", found.conventions.visible},
                              {"alternatives", nlohmann::ordered_json::array()}};
  for (const Finding& alarm : found.alarms) {
    json["alarms"].push_back(
        {{"matrix", alarm.matrix}, {"cause", alarm.cause}, {"remedy", alarm.remedy}});
  }
  for (const Alternative& one : found.conventions.alternatives) {
    json["alternatives"].push_back(
        {{"id", one.id}, {"what", one.what}, {"remedy", one.remedy}, {"points", one.points}});
  }
  return json;
}

}  // namespace glassbox::app
