#include "app/render/error_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/exit_codes.h"
#include "cli/report/number_json.h"
#include "cli/report/shell_line.h"
#include "cli/report/stage_report.h"
#include "cli/report/text_layout.h"
#include "views/commands/eye_error_json.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

// A quantity that a stage computes, such as the stored depth, with its error bounds.
struct Row {
  const char* stage;
  const char* number;
  const char* unit;
  const BoundSummary& bounds;
  double units = 1;  // factor from the unit of `bounds` to the printed unit
};

// A part of the run that the engine times, with the error bounds of the quantities it computes.
struct Part {
  const char* name;
  double ms;
  std::vector<Row> rows;
};

std::vector<Part> parts_of(const ErrorReport& report) {
  const PictureErrors& e = report.errors;
  const Statistics& s = report.statistics;
  constexpr double kByte = 255;
  return {{"prepare", s.prepare_ms, {}},
          {"vertices", s.vertex_ms, {}},
          {"triangles",
           s.triangle_ms,
           {{"screen", "corners on the screen", "px", e.screen},
            {"snap", "snapped corners", "px", e.snapped},
            {"snap", "corners that clipping made", "px", e.cut}}},
          {"fragments",
           s.fragment_ms,
           {{"depth", "stored depth", "of 0 to 1", e.depth},
            {"depth", "depth as a distance", "of distance", e.distance},
            {"attributes", "texture coordinates", "texels", e.texcoord},
            {"attributes", "normals", "of length", e.normal},
            {"texture", "texture samples", "1/255 light", e.texture, kByte},
            {"light", "colours after lighting", "1/255 light", e.light, kByte},
            {"encoding", "stored bytes", "1/255", e.stored},
            {"picture", "bytes of the picture", "1/255", e.picture}}}};
}

// ---- where ----

// The kind of the primitive: "triangle", "line" or "point". In a wireframe picture an edge is
// reported as its triangle.
const char* kind_of(const BoundPlace& place) {
  if (!place.line || *place.line == LineKind::kEdge) return "triangle";
  return *place.line == LineKind::kLine ? "line" : "point";
}

std::string place_text(const BoundPlace& place) {
  if (place.x >= 0) return fmt::format("pixel {},{}", place.x, place.y);
  const std::string whose = fmt::format("{} {}", kind_of(place), place.number);
  if (!place.corner || (place.line && *place.line == LineKind::kPoint)) return whose;
  return fmt::format("{}, {} {}", whose, place.line ? "end" : "corner", *place.corner);
}

// The command that shows the place stage by stage.
std::string command_for(const ErrorReport& report, const BoundPlace& place) {
  if (report.scene == "-") return {};
  if (place.x >= 0) {
    return shell_line({{"pixel", report.scene},
                       report.picture,
                       {"--at", fmt::format("{},{}", place.x, place.y)}});
  }
  if (place.line && *place.line != LineKind::kEdge) return {};  // `step` examines triangles only
  return shell_line(
      {{"step", report.scene}, report.picture, {"--triangle", fmt::format("{}", place.number)}});
}

Json place_json(const ErrorReport& report, const BoundPlace& place) {
  Json json{{kind_of(place), place.number}};
  if (place.corner) json[place.line ? "end" : "corner"] = *place.corner;
  if (place.x >= 0) json["pixel"] = {place.x, place.y};
  const std::string command = command_for(report, place);
  if (!command.empty()) json["command"] = command;
  return json;
}

// ---- decisions that may be wrong, and what is left out ----

struct UncertainDecision {
  const char* key;
  std::uint64_t count;
  const char* one;
  const char* many;
};

std::vector<UncertainDecision> uncertain_decisions(const PictureErrors& e) {
  return {{"vertices_snapped_elsewhere", e.vertices_snapped_elsewhere,
           "vertex may snap to another grid point with exact numbers",
           "vertices may snap to another grid point with exact numbers"},
          {"fragments_near_edge", e.fragments_near_edge,
           "fragment is so near an edge that the exact triangle may miss it",
           "fragments are so near an edge that the exact triangle may miss them"},
          {"fragments_as_deep", e.fragments_as_deep,
           "depth test may be decided differently with exact depths",
           "depth tests may be decided differently with exact depths"},
          {"fragments_at_cutoff", e.fragments_at_cutoff,
           "fragment has an alpha so near the cutoff that exact alpha may be on the other side",
           "fragments have an alpha so near the cutoff that exact alpha may be on the other side"},
          {"pixels_undecided", e.pixels_undecided,
           "pixel shows the result of such a decision; the bound of its bytes is for the decision "
           "as it was made",
           "pixels show the result of such decisions; the bounds of their bytes are for the "
           "decisions as they were made"}};
}

std::vector<std::string> limitations(const ErrorReport& report) {
  std::vector<std::string> notes;
  if (samples_drawn(report.settings) > 1) {
    notes.push_back(fmt::format(
        "the {} samples per pixel: all numbers are for pixel centres, as with --samples 1",
        report.settings.samples));
  }
  if (report.settings.show != Show::kColor) {
    notes.push_back("colours: the picture shows another quantity (--show)");
  }
  notes.push_back("pixels just outside an edge, which the exact triangle may cover");
  return notes;
}

// ---- text ----

std::string row_text(const Row& row) {
  const BoundSummary& bounds = row.bounds;
  const bool any = bounds.count() > bounds.unbounded();
  std::string text = fmt::format("  {:<27}{:<13}{:>10}{:>11}  {:<26}", row.number, row.unit,
                                 any ? number_or_unknown(bounds.largest() * row.units) : "unknown",
                                 number_or_unknown(bounds.typical() * row.units),
                                 any ? place_text(bounds.place()) : "");
  if (bounds.unbounded() > 0) {
    text += fmt::format("{} of {} unknown", with_separators(bounds.unbounded()),
                        with_separators(bounds.count()));
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

std::string parts_text(const ErrorReport& report) {
  std::string text =
      fmt::format("  {:<40}{:>10}{:>11}  {}\n", "", "at most", "half below", "where");
  for (const Part& part : parts_of(report)) {
    text += fmt::format("{}, {:.1f} ms\n", part.name, part.ms);
    for (const Row& row : part.rows) {
      if (row.bounds.count() > 0) text += row_text(row);
    }
  }
  return text;
}

// The commands that show two places: the one with the largest error bound in the picture, and the
// vertex with the largest error bound.
std::string commands_text(const ErrorReport& report) {
  std::string text;
  for (const BoundSummary* bounds : {&report.errors.snapped, &report.errors.picture}) {
    if (bounds->count() == bounds->unbounded()) continue;
    const std::string command = command_for(report, bounds->place());
    if (!command.empty()) text += "  " + command + "\n";
  }
  return text.empty() ? "" : "commands that show these places\n" + text;
}

std::string uncertain_decisions_text(const PictureErrors& errors) {
  std::string text;
  for (const UncertainDecision& decision : uncertain_decisions(errors)) {
    if (decision.count > 0) {
      text += wrapped("  ", with_separators(decision.count) + " " +
                                (decision.count == 1 ? decision.one : decision.many));
    }
  }
  return text.empty() ? "" : "decisions that exact numbers might make differently\n" + text;
}

std::string limitations_text(const ErrorReport& report) {
  std::string text = "what the bounds do not cover\n";
  for (const std::string& note : limitations(report)) text += wrapped("  ", note);
  return text;
}

std::string second_eye_text(const ErrorReport& report) {
  if (!report.second_eye) return "";
  const views::SecondEyeError& eye = *report.second_eye;
  const auto percent = [&](std::size_t count) {
    return 100 * double(count) / double(std::max<std::size_t>(eye.pixels, 1));
  };
  return fmt::format(
      "the right eye warped from {} of the left one, compared with drawing it\n"
      "  {:<40}{:>9.2f} %  (the left picture in its place: {:.2f} %)\n"
      "  {:<40}{:>9.2f}    ({:.2f})\n"
      "  {:<40}{:>9}    ({})\n"
      "  {:<40}{:>9.2f} %\n"
      "  {:<40}{:>9.2f} ms\n"
      "  {:<40}{:>9.2f} ms, {:.2f} times one eye\n"
      "  {:<40}{:>9.2f} ms, {:.2f} times one eye\n",
      counted(std::uint64_t(eye.layers), "layer"), "pixels that differ by more than 8/255",
      percent(eye.warped.wrong), percent(eye.left.wrong), "root mean square, 1/255", eye.warped.rms,
      eye.left.rms, "largest, 1/255", eye.warped.largest, eye.left.largest,
      "holes, filled from behind", percent(eye.holes), "one eye", eye.one_eye_ms, "both eyes drawn",
      eye.both_drawn_ms, eye.both_drawn_ms / eye.one_eye_ms, "left eye drawn, right eye warped",
      eye.both_warped_ms, eye.both_warped_ms / eye.one_eye_ms);
}

// ---- JSON ----

Json second_eye_json(const views::SecondEyeError& eye) {
  return {{"layers", eye.layers},
          {"pixels", eye.pixels},
          {"holes", eye.holes},
          {"warped", eye_error_json(eye.warped)},
          {"left_in_its_place", eye_error_json(eye.left)},
          {"one_eye_ms", eye.one_eye_ms},
          {"both_drawn_ms", eye.both_drawn_ms},
          {"both_warped_ms", eye.both_warped_ms}};
}

Json row_json(const ErrorReport& report, const Row& row) {
  const BoundSummary& bounds = row.bounds;
  Json json{{"stage", row.stage},
            {"number", row.number},
            {"unit", row.unit},
            {"count", bounds.count()},
            {"unknown", bounds.unbounded()}};
  if (bounds.count() == 0) return json;
  json["half_below"] = finite_json(bounds.typical() * row.units);
  if (bounds.count() == bounds.unbounded()) return json;
  json["at_most"] = bounds.largest() * row.units;
  json["where"] = place_json(report, bounds.place());
  return json;
}

}  // namespace

std::string error_report_text(const ErrorReport& report) {
  return fmt::format("{}, {} x {}, {}: how far each stage's numbers may be off, and its time\n",
                     printable(report.scene, kLongPath), report.width, report.height,
                     report.engine) +
         parts_text(report) + uncertain_decisions_text(report.errors) + limitations_text(report) +
         second_eye_text(report) + commands_text(report);
}

Json error_report_json(const ErrorReport& report) {
  Json parts = Json::array();
  for (const Part& part : parts_of(report)) {
    Json rows = Json::array();
    for (const Row& row : part.rows) rows.push_back(row_json(report, row));
    parts.push_back({{"part", part.name}, {"ms", part.ms}, {"numbers", std::move(rows)}});
  }
  Json uncertain = Json::object();
  for (const UncertainDecision& decision : uncertain_decisions(report.errors))
    uncertain[decision.key] = decision.count;
  Json json{{"schema", "glassbox-report/1"},
            {"scene", report.scene},
            {"width", report.width},
            {"height", report.height},
            {"engine", report.engine},
            {"parts", std::move(parts)},
            {"might_be_otherwise", std::move(uncertain)},
            {"fragments_of_lines_and_points", report.errors.fragments_of_lines_and_points},
            {"pixels_unknown", report.errors.pixels_unbounded},
            {"left_out", limitations(report)}};
  if (report.second_eye) json["second_eye"] = second_eye_json(*report.second_eye);
  return json;
}

}  // namespace glassbox::app
