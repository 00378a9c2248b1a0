#include "app/stereo/report.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/report/text_layout.h"

namespace glassbox::app {

namespace {

std::string eyes_line(const StereoFindings& found) {
  const ChosenPair& eyes = found.chosen.eyes;
  return fmt::format("eyes {:.6g} apart ({}), window at {:.6g} ({})\n",
                     2 * eyes.pair.half_separation, eyes.separation_is_from, eyes.pair.window,
                     eyes.window_is_at);
}

std::string parallax_table(const StereoFindings& found) {
  std::string text = fmt::format("  {:<16}{:>12}{:>15}{:>14}{:>14}{:>12}\n", "", "distance",
                                 "parallax", "of the width", "on a display", "angle");
  for (const ParallaxRow& row : parallax_rows(found)) {
    text += fmt::format("  {:<16}{:>12.6g}{:>12.2f} px{:>12.2f} %{:>11.1f} mm{:>8.2f} deg\n",
                        row.name, row.parallax.distance, row.parallax.px, row.parallax.percent,
                        row.displayed.mm, row.displayed.degrees);
  }
  if (!found.chosen.centre.perspective) {
    text += wrapped("  ",
                    "A parallel projection: both views are oblique, and parallax grows linearly "
                    "with depth, without limit.");
  }
  return text;
}

const char* sign_of(Level level) {
  constexpr const char* kSigns[] = {"ok", "!", "!!", ""};
  return kSigns[std::size_t(level)];
}

std::string verdict_lines(const std::vector<Verdict>& verdicts) {
  std::string text;
  for (const Verdict& verdict : verdicts) {
    text +=
        wrapped(fmt::format("  {:<3}{:<19}", sign_of(verdict.level), verdict.about), verdict.text);
  }
  return text;
}

std::string advice_lines(const std::vector<Advice>& advice) {
  if (advice.empty()) return "nothing to change\n";
  std::string text = "what to change\n";
  for (const Advice& one : advice) {
    text += wrapped("  - ", one.text);
    if (one.options.empty()) continue;
    text += fmt::format("      {}\n", fmt::join(one.options, " "));
  }
  return text;
}

}  // namespace

std::vector<ParallaxRow> parallax_rows(const StereoFindings& found) {
  const DepthFindings& depth = found.depth;
  std::vector<ParallaxRow> rows;
  const auto add = [&](const char* name, const Parallax& parallax) {
    rows.push_back({name, parallax, displayed_parallax(parallax, found.criteria.display)});
  };
  add("near plane", depth.planes.near);
  if (depth.seen) add("nearest seen", depth.nearest);
  add("window", depth.planes.window);
  if (depth.seen) add("farthest seen", depth.farthest);
  add("far plane", depth.planes.far);
  std::ranges::stable_sort(rows, {}, [](const ParallaxRow& row) { return row.parallax.distance; });
  return rows;
}

std::string stereo_text(const StereoFindings& found, const StereoWords& words) {
  return eyes_line(found) + parallax_table(found) + "\n" + verdict_lines(words.verdicts) + "\n" +
         advice_lines(words.advice);
}

}  // namespace glassbox::app
