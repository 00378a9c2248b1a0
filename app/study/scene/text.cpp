#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "app/bench/text.h"
#include "app/report/exit_codes.h"
#include "app/report/table.h"
#include "app/report/text_layout.h"
#include "app/study/scene/curve_report.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

namespace glassbox::app {

namespace {

using study::CurvePoint;
using study::Knob;
using study::Standing;

std::string note_of(const CurvePoint& point) {
  std::string note = point.standing ? name_of(*point.standing) : "";
  if (point.disturbed > 0) note += (note.empty() ? "" : ", ") + std::string("disturbed");
  return note;
}

TimeUnit unit_of(const study::Curve& curve) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const CurvePoint& point : curve.points) shortest = std::min(shortest, point.ns.median);
  return time_unit(shortest);
}

std::string table_of(const std::vector<const CurvePoint*>& points, const TimeUnit& unit) {
  std::vector<Row> rows{{"", "RMS/255", "largest", "wrong", "FLIP", "depth error",
                         fmt::format("{}/frame", unit.name), "quartiles", ""}};
  for (const CurvePoint* point : points) {
    const auto time = [&](double ns) { return three_digits(ns / unit.ns); };
    rows.push_back({name_of(point->way), fmt::format("{:.3g}", 255 * point->error.rms),
                    fmt::to_string(point->error.largest),
                    fmt::format("{:.3g} %", 100 * point->error.wrong),
                    fmt::format("{:.3g}", point->error.flip),
                    fmt::format("{:.2g}", point->depth_error), time(point->ns.median),
                    time(point->ns.lower) + " .. " + time(point->ns.upper), note_of(*point)});
  }
  return table(rows, 1);
}

std::vector<const CurvePoint*> singles(const study::Curve& curve) {
  std::vector<const CurvePoint*> found;
  for (const CurvePoint& point : curve.points) {
    if (point.way.knob != Knob::kSeveral) found.push_back(&point);
  }
  return found;
}

// The fastest first.
std::vector<const CurvePoint*> front(const study::Curve& curve) {
  std::vector<const CurvePoint*> found;
  for (const CurvePoint& point : curve.points) {
    if (point.standing == Standing::kFront) found.push_back(&point);
  }
  std::ranges::sort(found, {}, [](const CurvePoint* point) { return point->ns.median; });
  return found;
}

}  // namespace

std::string curve_text(const CurveReport& report) {
  const study::Curve& curve = report.curve;
  const TimeUnit unit = unit_of(curve);
  std::string text = wrapped(
      "", fmt::format("{}, {} x {}; {}; {}; glassbox {}", printable(report.scene, kLongestMessage),
                      report.size.width, report.size.height, report.origin.machine,
                      report.origin.compiler, report.origin.version));
  text += wrapped("", "Errors are those of the whole picture, against it " + curve.reference_is);
  text += wrapped("", fmt::format("Positions are off by {:.2g} px at most, of {} vertices against "
                                  "50 digits",
                                  curve.position_error, curve.vertices));
  text += "\nEach knob alone\n" + table_of(singles(curve), unit);
  const auto best = front(curve);
  text += fmt::format("\nThe front: {} of {} ways with one thread, {} pictures\n", best.size(),
                      std::ranges::count_if(
                          curve.points, [](const CurvePoint& p) { return p.standing.has_value(); }),
                      curve.different);
  text += table_of(best, unit);
  if (!curve.left_out.empty()) text += "\nLeft out\n";
  for (const study::NotTurned& each : curve.left_out)
    text += wrapped(fmt::format("  {}: ", name_of(each.knob)), each.why);
  for (const std::string& fault : curve.faults) {
    text += wrapped("\nA fault of glassbox: ", fault + " makes another picture; please report it");
  }
  return text;
}

}  // namespace glassbox::app
