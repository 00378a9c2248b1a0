#include "app/eyes_options.h"

#include <cmath>

#include "app/arguments.h"

#include <glassbox/mesh/bounds.h>
#include <glassbox/pipeline/stereo/comfort.h>

namespace glassbox::app {

namespace {

// Stereo photography's rule of one in thirty, for the window in place of the nearest thing.
constexpr double kWindowsPerSeparation = 30;

bool is_between_planes(const View& centre, double distance) {
  return distance > 0 && distance > centre.near && distance < centre.far;
}

ChosenPair with_automatic_window(const Scene& scene, const View& centre,
                                 std::optional<double> look_at) {
  if (look_at && is_between_planes(centre, *look_at)) {
    return {{0, *look_at}, "where the camera looks"};
  }
  const double middle = -(centre.eye_from_world * bounds(scene).center()).z;
  if (is_between_planes(centre, middle)) return {{0, middle}, "the scene's centre"};
  const double between = best_window(centre, {centre.near, centre.far}, {1, 1});
  return {{0, between}, "between the near and far planes"};
}

}  // namespace

void add_eyes_options(CLI::App& command, EyesOptions& eyes) {
  const std::string group = "Eyes (stereo)";
  command
      .add_option_function<std::string>(
          "--eye-separation",
          [&eyes](const std::string& text) {
            eyes.separation = parse_number("--eye-separation", text);
          },
          "from eye to eye (world units) [a thirtieth of the window's distance]")
      ->type_name("S")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--window",
          [&eyes](const std::string& text) {
            eyes.window.reset();
            if (text != "auto") eyes.window = parse_distance("--window", text);
          },
          "distance without parallax (world units along the gaze) [auto: the point looked at]")
      ->type_name("D|auto")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--seen-by",
          [&eyes](const std::string& text) {
            if (text != "left" && text != "right") {
              throw CLI::ValidationError("--seen-by", "needs left or right, not '" + text + "'");
            }
            eyes.seen_by = text == "left" ? Side::kLeft : Side::kRight;
          },
          "the picture of one eye alone")
      ->type_name("left|right")
      ->group(group);
}

Result<ChosenPair> choose_pair(const Scene& scene, const View& centre, const EyesOptions& eyes,
                               std::optional<double> look_at) {
  ChosenPair chosen = eyes.window ? ChosenPair{{0, *eyes.window}, "as given"}
                                  : with_automatic_window(scene, centre, look_at);
  if (!eyes.separation && std::isinf(chosen.pair.window)) {
    return fail("--window", "an infinite one says nothing about how far the eyes are apart",
                "give --eye-separation");
  }
  const double separation = eyes.separation.value_or(chosen.pair.window / kWindowsPerSeparation);
  chosen.pair.half_separation = separation / 2;
  return check_pair(centre, chosen.pair).map([&] { return chosen; });
}

}  // namespace glassbox::app
