#include "app/frames/frames_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/exit_codes.h"
#include "cli/report/number_json.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/pipeline/stereo/parallax.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

template <class ValueOf>
std::pair<double, double> range_of(const FramesReport& report, const ValueOf& value_of) {
  double low = value_of(report.frames.front()), high = low;
  for (const FrameRecord& frame : report.frames) {
    low = std::min(low, value_of(frame));
    high = std::max(high, value_of(frame));
  }
  return {low, high};
}

double separation_of(const FrameRecord& frame) {
  return 2 * frame.pair.half_separation;
}

double largest_step(const FramesReport& report) {
  double largest = 0;
  for (std::size_t i = 1; i < report.frames.size(); ++i) {
    largest = std::max(
        largest, std::abs(separation_of(report.frames[i]) - separation_of(report.frames[i - 1])));
  }
  return largest;
}

std::string eyes_text(const FramesReport& report) {
  const auto percent = [&](double px) { return 100 * px / report.size.width; };
  const auto [least, most] = range_of(report, separation_of);
  const auto [near_window, far_window] =
      range_of(report, [](const FrameRecord& f) { return f.pair.window; });
  const double in_front =
      range_of(report, [](const FrameRecord& f) { return f.in_front_px; }).second;
  const double behind = range_of(report, [](const FrameRecord& f) { return f.behind_px; }).second;
  std::string text =
      fmt::format("stereo: eyes {:.4g} to {:.4g} apart, window at {:.4g} to {:.4g}\n", least, most,
                  near_window, far_window);
  text += fmt::format("  {:<36}{:>9.2f} px{:>7.2f} % of the width (budget {:.2f} %)\n",
                      "largest parallax in front, measured", in_front, percent(in_front),
                      percent(report.budget.in_front_px));
  text += fmt::format("  {:<36}{:>9.2f} px{:>7.2f} % of the width (budget {:.2f} %)\n",
                      "largest parallax behind, measured", behind, percent(behind),
                      percent(report.budget.behind_px));
  text += fmt::format("  {:<36}{:>9.4g} (bound {:.4g})\n", "largest change of the separation",
                      largest_step(report), report.eyes->step_bound);
  return text;
}

Json eyes_json(const FramesReport& report) {
  const EyePlan& eyes = *report.eyes;
  Json empty = Json::array();
  for (const std::size_t i : eyes.empty_frames) empty.push_back(i + 1);
  return {{"budget_px", {report.budget.in_front_px, report.budget.behind_px}},
          {"separation_bound", finite_or_inf(eyes.separation_bound)},
          {"step_bound", finite_or_inf(eyes.step_bound)},
          {"largest_step", largest_step(report)},
          {"pairs_measured", eyes.measured_pairs},
          {"pairs_that_saw_more", eyes.widening_pairs},
          {"frames_that_show_nothing", empty}};
}

}  // namespace

FrameRecord record_of(const SequenceFrame& shot, const std::string& image) {
  return {shot.number, shot.time, image, {}, {}, 0, 0};
}

void measure_parallax(FrameRecord& record, const View& centre, const StereoPair& pair,
                      const std::optional<DepthSpan>& seen) {
  record.pair = pair;
  record.seen = seen;
  if (!seen) return;
  // Parallax grows with the distance, so the nearest and the farthest depth give its extremes.
  record.in_front_px = std::max(0.0, -parallax_at(centre, pair, seen->nearest).px);
  record.behind_px = std::max(0.0, parallax_at(centre, pair, seen->farthest).px);
}

std::string frames_text(const FramesReport& report) {
  const std::size_t count = report.frames.size();
  std::string text = printable(report.frames.front().image, kLongPath);
  if (count > 1) text += " to " + printable(report.frames.back().image, kLongPath);
  text += fmt::format(" ({} x {}): {}, {:.0f} ms\n", report.size.width, report.size.height,
                      counted(count, "frame"), report.total_ms);
  if (report.range.is_slice()) {
    text.insert(text.rfind(','), fmt::format(" of {}", report.range.count));
  }
  if (report.eyes) text += eyes_text(report);
  if (!report.plot.empty()) text += "  plot: " + printable(report.plot, kLongPath) + "\n";
  return text;
}

nlohmann::ordered_json frames_json(const FramesReport& report) {
  Json json{{"scene", report.scene},
            {"path", report.path.empty() ? Json("turntable") : Json(report.path)},
            {"width", report.size.width},
            {"height", report.size.height}};
  if (report.range.is_slice()) {
    json["slice"] = {
        {"first", report.range.first}, {"last", report.range.last}, {"of", report.range.count}};
  }
  if (report.eyes) json["stereo"] = eyes_json(report);
  if (!report.plot.empty()) json["plot"] = report.plot;
  Json frames = Json::array();
  for (const FrameRecord& frame : report.frames) {
    Json one{{"frame", frame.number}, {"time", frame.time}, {"image", frame.image}};
    if (report.eyes) {
      one["separation"] = separation_of(frame);
      one["window"] = finite_or_inf(frame.pair.window);
      if (frame.seen) one["seen"] = {frame.seen->nearest, frame.seen->farthest};
      one["in_front_px"] = frame.in_front_px;
      one["behind_px"] = frame.behind_px;
    }
    frames.push_back(std::move(one));
  }
  json["frames"] = std::move(frames);
  json["total_ms"] = report.total_ms;
  return json;
}

}  // namespace glassbox::app
