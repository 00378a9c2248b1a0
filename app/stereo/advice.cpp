#include "app/stereo/verdicts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include <glassbox/base/elementary.h>
#include <glassbox/pipeline/stereo/parallax_budget.h>

namespace glassbox::app {

namespace {

// Rounds a positive number down to three significant digits.
double rounded_down(double value) {
  const double unit = power_of_ten(int(std::floor(logarithm_10(value))) - 2);
  return std::floor(value / unit) * unit;
}

// The number as the value of an option. It has six digits, which is enough for results of
// rounded_down.
std::string option_number(double value) {
  return std::isinf(value) ? "inf" : fmt::format("{:g}", value);
}

// The parallax budget, with one more limit behind the window: on the display, parallax must not
// exceed the distance between the pupils.
ParallaxBudget display_budget(const StereoFindings& found) {
  const double pupils_px = kPupilDistanceMm / found.criteria.display.width_mm *
                           double(found.chosen.centre.viewport.width());
  return {found.depth.budget.in_front_px, std::min(found.depth.budget.behind_px, pupils_px)};
}

struct Eyes {
  double separation = 0, window = 0;
};

// The largest separation that the budget allows with this window, but no more than the current
// separation or a thirtieth of the window's distance, whichever is larger. None if the budget
// allows no separation, or if the camera cannot have this window.
std::optional<Eyes> eyes_for(const StereoFindings& found, double window) {
  const View& centre = found.chosen.centre;
  if (!(window > 0) || std::isinf(window)) return {};
  // A failure at this tiny separation means that the window itself is not possible.
  if (!check_pair(centre, {window * 1e-9, window})) return {};
  const double at_most =
      std::max(found.chosen.eyes.pair.half_separation, window / kWindowsPerSeparation / 2);
  const double half =
      largest_half_separation(centre, window, *found.depth.seen, display_budget(found), at_most);
  if (!(half > 0)) return {};
  return Eyes{rounded_down(2 * half), window};
}

// Eyes with the current window, rounded to six digits as on the command line; with the unrounded
// window if the rounded one is not possible.
std::optional<Eyes> eyes_for_same_window(const StereoFindings& found) {
  const double window = found.chosen.eyes.pair.window;
  const auto same = eyes_for(found, std::strtod(option_number(window).c_str(), nullptr));
  return same ? same : eyes_for(found, window);
}

// Eyes with the window at this distance, rounded down to three digits; with the unrounded window if
// eyes_for() finds none for the rounded one.
std::optional<Eyes> eyes_before(const StereoFindings& found, double distance) {
  if (!(distance > 0) || std::isinf(distance)) return {};
  const auto rounded = eyes_for(found, rounded_down(distance));
  return rounded ? rounded : eyes_for(found, distance);
}

// Eyes with the window at which the nearest and the farthest visible depth both have the largest
// parallax that the budget allows.
std::optional<Eyes> best_eyes(const StereoFindings& found) {
  return eyes_before(found,
                     best_window(found.chosen.centre, *found.depth.seen, display_budget(found)));
}

std::vector<std::string> options_of(const Eyes& eyes) {
  return {"--eye-separation", option_number(eyes.separation), "--window",
          option_number(eyes.window)};
}

double largest_parallax_percent(const StereoFindings& found, const Eyes& eyes) {
  const StereoPair pair{eyes.separation / 2, eyes.window};
  const auto percent = [&](double distance) {
    return std::abs(parallax_at(found.chosen.centre, pair, distance).percent);
  };
  return std::max(percent(found.depth.seen->nearest), percent(found.depth.seen->farthest));
}

// ---- depth ----

void advise_on_cuts(const Scene& scene, const StereoFindings& found, std::vector<Advice>& all) {
  const auto& cuts = found.depth.violations.found;
  if (cuts.empty()) return;
  const auto nearest = std::ranges::min_element(cuts, {}, &WindowViolation::nearest);
  const std::string what =
      fmt::format("({}, at {:.4g})", names_of_cut(scene, *nearest), nearest->nearest);
  const auto eyes = eyes_before(found, nearest->nearest);
  if (!eyes) {
    all.push_back(
        {"Move the camera: the edges cut something directly in front of it " + what + ".", {}});
    return;
  }
  all.push_back(
      {fmt::format("Move the window to the nearest thing that an edge cuts {}: then nothing that "
                   "is cut is in front of it, and the visible parallax is at most {:.2f} %. Or "
                   "move the camera, so that the edges cut nothing near.",
                   what, largest_parallax_percent(found, *eyes)),
       options_of(*eyes)});
}

void advise_on_budget(const StereoFindings& found, std::vector<Advice>& all) {
  const double current_separation = 2 * found.chosen.eyes.pair.half_separation;
  const auto same = eyes_for_same_window(found);
  const auto best = best_eyes(found);
  const bool broken =
      found.depth.share_beyond_budget() > 0 || found.depth.farthest_displayed.diverges;
  if (!broken) {
    constexpr double kMuchMore = 2;
    if (!same || same->separation < kMuchMore * current_separation) return;
    all.push_back(
        {fmt::format("More depth is possible: the eyes may be {:.4g} apart instead of {:.4g}.",
                     same->separation, current_separation),
         options_of(*same)});
    return;
  }
  if (same) {
    all.push_back({fmt::format("Move the eyes closer together: if they are {:.4g} apart instead of "
                               "{:.4g} and the window stays, the parallax is within the budget.",
                               same->separation, current_separation),
                   options_of(*same)});
  }
  if (!best || (same && best->separation <= 1.05 * same->separation)) return;
  all.push_back(
      {fmt::format("{} the window to {:.4g}, where the nearest and the farthest surface have the "
                   "largest allowed parallax: then the eyes may be {:.4g} apart.",
                   same ? "Or move" : "Move", best->window, best->separation),
       options_of(*best)});
}

// ---- colour ----

void advise_on_colour(const StereoFindings& found, std::vector<Advice>& all) {
  const ColourFindings& colour = found.colour;
  if (!colour.suggestion) return;
  const double now = colour.mean_rivalry;
  // the method with the least rivalry among those that keep colours
  const MethodFindings* best = nullptr;
  for (const MethodFindings& method : colour.methods) {
    const bool grey =
        method.method == AnaglyphMethod::kTrue || method.method == AnaglyphMethod::kGrey;
    if (!grey && (best == nullptr || method.rivalry < best->rivalry)) best = &method;
  }
  if (best != nullptr && best->rivalry < now) {
    all.push_back({fmt::format("Use another anaglyph method: {} changes the mean rivalry from "
                               "{:.3f} to {:.3f} and keeps some colour.",
                               name_of(best->method), now, best->rivalry),
                   {"--anaglyph", std::string(name_of(best->method))}});
  }
  const Compromise& chosen = colour.suggestion->chosen;
  all.push_back(
      {fmt::format(
           "Or move the colours towards grey and white: with glassbox render's --desaturate {:.2f} "
           "--brighten {:.2f}, the {} anaglyph has a mean rivalry of {:.3f}, and its colours "
           "change by {:.1f} on average (CIEDE2000){}.",
           chosen.recolour.desaturate, chosen.recolour.brighten, name_of(found.criteria.method),
           chosen.rivalry, chosen.difference,
           colour.suggestion->meets_target ? "" : "; not even a grey picture has less rivalry"),
       {}});
}

void advise_on_content(const StereoFindings& found, std::vector<Advice>& all) {
  constexpr double kLittle = 0.01;  // fraction of the picture
  if (found.information.share >= kLittle) return;
  all.push_back(
      {"The eyes see depth at few places of this picture: add upright edges, thin objects and "
       "textures of many sizes, in front of the window and behind it.",
       {}});
}

}  // namespace

std::vector<Advice> advise(const Scene& scene, const StereoFindings& found) {
  std::vector<Advice> all;
  if (!found.depth.seen) {
    return {
        {"Ask glassbox why what keeps the scene out of the picture; --camera none puts all of it "
         "in view.",
         {}}};
  }
  if (found.rendering.passes == 1) {
    auto eyes = eyes_for_same_window(found);
    if (!eyes) eyes = best_eyes(found);
    if (eyes)
      all.push_back({"Move the eyes apart: with these options the parallax is within the budget.",
                     options_of(*eyes)});
    advise_on_colour(found, all);
    return all;
  }
  if (found.pair_order.order == EyeOrder::kSwapped) {
    all.push_back({"Swap the eyes.", {}});
  }
  advise_on_budget(found, all);
  advise_on_cuts(scene, found, all);
  advise_on_colour(found, all);
  advise_on_content(found, all);
  return all;
}

}  // namespace glassbox::app
