#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "cli/report/exit_codes.h"
#include "cli/report/table.h"
#include "cli/report/text_layout.h"
#include "study/commands/bench/report.h"
#include "study/commands/scene/curve_report.h"
#include "study/experiment/timing.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

namespace glassbox::study {

namespace {

std::string note_of(const CurvePoint& point) {
  std::string note = point.standing ? name_of(*point.standing) : "";
  if (point.disturbed > 0) note += (note.empty() ? "" : ", ") + std::string("disturbed");
  return note;
}

TimeUnit unit_of(const study::Curve& curve) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const CurvePoint& point : curve.points) shortest = std::min(shortest, point.ns.median);
  return glassbox::time_unit(shortest);
}

std::string table_of(const std::vector<const CurvePoint*>& points, const TimeUnit& unit) {
  std::vector<Row> rows{{"", "RMS/255", "largest", "wrong", "FLIP", "depth error",
                         fmt::format("{}/frame", unit.name), "quartiles", ""}};
  for (const CurvePoint* point : points) {
    const auto time = [&](double ns) { return three_digits(ns / unit.ns); };
    rows.push_back({name_of(point->variant), fmt::format("{:.3g}", 255 * point->error.rms),
                    fmt::to_string(point->error.largest),
                    fmt::format("{:.3g} %", 100 * point->error.wrong),
                    fmt::format("{:.3g}", point->error.flip),
                    fmt::format("{:.2g}", point->depth_error), time(point->ns.median),
                    time(point->ns.lower) + " .. " + time(point->ns.upper), note_of(*point)});
  }
  return table(rows, 1);
}

std::vector<const CurvePoint*> changed_alone(const study::Curve& curve) {
  std::vector<const CurvePoint*> found;
  for (const CurvePoint& point : curve.points) {
    if (point.variant.knob != Knob::kSeveral) found.push_back(&point);
  }
  return found;
}

// The points of the Pareto front, the fastest first.
std::vector<const CurvePoint*> pareto_front(const study::Curve& curve) {
  std::vector<const CurvePoint*> found;
  for (const CurvePoint& point : curve.points) {
    if (point.standing == Standing::kFront) found.push_back(&point);
  }
  std::ranges::sort(found, {}, [](const CurvePoint* point) { return point->ns.median; });
  return found;
}

std::string second_eyes_text(const SecondEyes& eyes) {
  std::string text = "\nA second eye (render --stereo ... --second-eye)\n";
  if (!eyes.left_out.empty()) return text + wrapped("  ", "left out: " + eyes.left_out);
  const views::SecondEyeError& one = eyes.warped.front();
  const auto percent = [&](std::size_t count) {
    return fmt::format("{:.3g} %", 100 * double(count) / double(one.pixels));
  };
  const auto times = [&](double ms) { return fmt::format("{:.2f}", ms / one.one_eye_ms); };
  std::vector<Row> rows{{"", "RMS/255", "largest", "wrong", "filled", "ms/pair", "times one eye"}};
  rows.push_back({"drawn", "0", "0", "0 %", "0 %", fmt::format("{:.3g}", one.both_drawn_ms),
                  times(one.both_drawn_ms)});
  for (const views::SecondEyeError& eye : eyes.warped) {
    rows.push_back({fmt::format("warp:{}", eye.layers), fmt::format("{:.3g}", eye.warped.rms),
                    fmt::to_string(eye.warped.largest), percent(eye.warped.wrong),
                    percent(eye.holes), fmt::format("{:.3g}", eye.both_warped_ms),
                    times(eye.both_warped_ms)});
  }
  rows.push_back({"the left eye's picture for both eyes", fmt::format("{:.3g}", one.left.rms),
                  fmt::to_string(one.left.largest), percent(one.left.wrong), "",
                  fmt::format("{:.3g}", one.one_eye_ms), "1.00"});
  text += table(rows, 1);
  return text +
         wrapped(
             "  ",
             fmt::format("the eyes are {:.4g} apart, with the window at {:.4g}; errors are "
                         "differences from the drawn picture of the right eye, over its {} pixels",
                         2 * eyes.pair.half_separation, eyes.pair.window, one.pixels));
}

}  // namespace

std::string curve_text(const CurveReport& report) {
  const study::Curve& curve = report.curve;
  const TimeUnit unit = unit_of(curve);
  std::string text = wrapped(
      "", fmt::format("{}, {} x {}; {}; {}; glassbox {}", printable(report.scene, kLongestMessage),
                      report.size.width, report.size.height, report.origin.machine,
                      report.origin.compiler, report.origin.version));
  text += wrapped(
      "", "Errors are those of the whole picture, compared with the picture " + curve.reference_is);
  text += wrapped("", fmt::format("The largest error of a position on the screen is {:.2g} px, "
                                  "over {} vertices, compared with 50 digits",
                                  curve.position_error, curve.vertices));
  text += "\nEach option alone\n" + table_of(changed_alone(curve), unit);
  const auto best = pareto_front(curve);
  text += fmt::format(
      "\nThe Pareto front (no other way is both faster and more exact): {} of {} ways with one "
      "thread, which give {} different pictures\n",
      best.size(),
      std::ranges::count_if(curve.points,
                            [](const CurvePoint& p) { return p.standing.has_value(); }),
      curve.different);
  text += table_of(best, unit);
  if (std::ranges::any_of(curve.points, [](const CurvePoint& p) { return p.disturbed > 0; }))
    text += wrapped("  ", kDisturbedMeaning);
  text += second_eyes_text(report.second_eyes);
  if (!curve.skipped.empty()) text += "\nNot varied\n";
  for (const study::SkippedKnob& each : curve.skipped)
    text += wrapped(fmt::format("  {}: ", name_of(each.knob)), each.why);
  for (const std::string& fault : curve.faults) {
    text += wrapped("\nA bug of glassbox: ", fault + " changes the picture; please report it");
  }
  return text;
}

}  // namespace glassbox::study
