#include "cli/options/eyes_options.h"

#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/arguments.h"
#include "cli/options/choices.h"

#include <glassbox/mesh/bounding_box.h>
#include <glassbox/pipeline/stereo/parallax_budget.h>
#include <glassbox/render/visible_depth_span.h>

namespace glassbox {

namespace {

bool is_between_planes(const View& centre, double distance) {
  return distance > 0 && distance > centre.near && distance < centre.far;
}

ChosenPair with_automatic_window(const Scene& scene, const View& centre,
                                 std::optional<double> look_at) {
  if (look_at && is_between_planes(centre, *look_at)) {
    return {{0, *look_at}, "where the camera looks", ""};
  }
  const double middle = -(centre.eye_from_world * bounds(scene).center()).z;
  if (is_between_planes(centre, middle)) return {{0, middle}, "the scene's centre", ""};
  const double between = best_window(centre, {centre.near, centre.far}, {1, 1});
  return {{0, between}, "between the near and far planes", ""};
}

void choose_separation(const Scene& scene, const View& centre, const RenderSettings& settings,
                       ChosenPair& chosen) {
  const double rule = chosen.pair.window / kWindowsPerSeparation;
  chosen.pair.half_separation = rule / 2;
  chosen.separation_is_from = "a thirtieth of the window's distance";
  Renderer renderer(scene, settings.transfer);
  const std::optional<DepthSpan> seen = visible_depth_span(renderer, centre, settings);
  if (!seen) return;
  const double budget = kComfortablePercent / 100 * double(centre.viewport.width());
  const double bearable =
      largest_half_separation(centre, chosen.pair.window, *seen, {budget, budget}, rule / 2);
  if (bearable >= rule / 2) return;
  chosen.pair.half_separation = bearable;
  chosen.separation_is_from = fmt::format(
      "the largest with a parallax of at most {:g} % of the width", kComfortablePercent);
}

}  // namespace

void add_eyes_options(CLI::App& command, EyesOptions& eyes) {
  const std::string group = "Eyes (stereo)";
  command
      .add_option_function<std::string>(
          "--eye-separation",
          [&eyes](const std::string& text) {
            eyes.separation.reset();
            if (text != "auto") eyes.separation = parse_number("--eye-separation", text);
          },
          "distance between the eyes (world units) [auto: comfortable, at most a thirtieth of "
          "--window]")
      ->type_name("S|auto")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--window",
          [&eyes](const std::string& text) {
            eyes.window.reset();
            if (text != "auto") eyes.window = parse_distance("--window", text);
          },
          "distance of the stereo window, where parallax is 0 (world units along the gaze) [auto: "
          "the point looked at]")
      ->type_name("D|auto")
      ->group(group);
  add_choice(command, "--seen-by", eyes.seen_by, {{"left", Side::kLeft}, {"right", Side::kRight}},
             "draw only the picture of this eye")
      ->group(group);
}

Result<ChosenPair> choose_pair(const Scene& scene, const View& centre,
                               const RenderSettings& settings, const EyesOptions& eyes,
                               std::optional<double> look_at) {
  ChosenPair chosen = eyes.window ? ChosenPair{{0, *eyes.window}, "as given", ""}
                                  : with_automatic_window(scene, centre, look_at);
  if (eyes.separation) {
    chosen.pair.half_separation = *eyes.separation / 2;
    chosen.separation_is_from = "as given";
    return check_pair(centre, chosen.pair).map([&] { return chosen; });
  }
  if (std::isinf(chosen.pair.window)) {
    return fail("--window", "no eye separation can be derived from an infinite distance",
                "give --eye-separation");
  }
  // The separation is set to a provisional value first, because with separation zero an invalid
  // window would not be noticed.
  chosen.pair.half_separation = chosen.pair.window / kWindowsPerSeparation / 2;
  if (const Result<void> ok = check_pair(centre, chosen.pair); !ok) {
    return tl::unexpected(ok.error());
  }
  choose_separation(scene, centre, settings, chosen);
  return chosen;
}

}  // namespace glassbox
