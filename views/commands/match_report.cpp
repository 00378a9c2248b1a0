#include "views/commands/match_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/exit_codes.h"
#include "cli/report/text_layout.h"
#include "views/commands/geometry.h"
#include "views/commands/rectified_pair.h"

#include <glassbox/base/printable.h>

namespace glassbox::views {

namespace {

using Json = nlohmann::ordered_json;

struct RegionErrors {
  const char* where;  // in words
  const char* key;
  views::DisparityErrors errors;
};

Image<std::uint8_t> mask_intersection(Image<std::uint8_t> one, const Image<std::uint8_t>& other) {
  for (std::size_t i = 0; i < one.pixels.size(); ++i) one.pixels[i] &= other.pixels[i];
  return one;
}

std::vector<RegionErrors> evaluate_regions(const MatchInput& input, const Image<float>& disparity) {
  const views::StereoTruth& truth = *input.truth;
  std::vector<RegionErrors> all;
  const auto add = [&](const char* where, const char* key, const Image<std::uint8_t>& mask) {
    all.push_back({where, key, views::disparity_errors(disparity, truth.disparity, &mask)});
  };
  const Image<std::uint8_t> jumps =
      mask_intersection(views::near_discontinuity(truth.disparity), truth.is_visible);
  if (input.is_textured) {
    add("visible and textured", "visible_and_textured",
        mask_intersection(*input.is_textured, truth.is_visible));
    add("textured, at a jump", "textured_at_jumps", mask_intersection(*input.is_textured, jumps));
  }
  add("visible to both", "visible", truth.is_visible);
  add("visible, at a jump", "visible_at_jumps", jumps);
  all.push_back({"all known", "all", views::disparity_errors(disparity, truth.disparity)});
  return all;
}

// The results that are left out, with the reasons.
std::vector<OmittedItem> omitted_items(const MatchInput& input,
                                       const views::MatchSettings& settings,
                                       const views::DenseMatch& match) {
  std::vector<OmittedItem> out;
  out.push_back(
      {fmt::format("disparities below {} and above {}", settings.range.first, settings.range.last),
       "not searched, because time and memory grow with --range"});
  std::uint64_t invalid = 0;
  for (const views::InvalidReason reason : match.invalid_reasons.pixels)
    invalid += reason != views::InvalidReason::kNone;
  if (invalid > 0) {
    out.push_back({fmt::format("a match for {:.1f} % of the pixels",
                               100 * double(invalid) / double(match.invalid_reasons.pixels.size())),
                   settings.fill ? "they are uncertain, and filled with the values around them: "
                                   "--no-fill leaves them empty"
                                 : "they are uncertain, and +inf in the file"});
  }
  if (settings.planes == 0) {
    out.push_back({"slanted surfaces",
                   "a pixel's disparity is found as if the surface around it faced the camera: "
                   "--planes 1 allows slanted planes, but takes longer"});
  }
  if (views::sweeps_once(settings)) {
    out.push_back({"paths from below",
                   "the single sweep from above, which needs no cost volume, has no paths from "
                   "below: --method default has them"});
  }
  const bool is_drawn = input.is_textured.has_value();
  if (!input.truth) {
    out.push_back({"errors", input.rectification
                                 ? "the true disparities of rectified pictures are not known"
                                 : "the true disparities are not given: --truth FILE, or --scene"});
  }
  if (!input.calibration) {
    out.push_back(
        {"depth",
         is_drawn ? "both eyes are in one place: give --eye-separation"
                  : "the focal length and the baseline are not given: --calibration F,B,OFFSET"});
  }
  if (!is_drawn && !input.rectification) {
    out.push_back({"the check that corresponding points are on the same row",
                   "the pictures are assumed to be rectified: --cameras FILE rectifies them"});
  }
  return out;
}

constexpr std::array<std::pair<views::InvalidReason, const char*>, 5> kInvalidReasons{
    {{views::InvalidReason::kOccluded, "occluded"},
     {views::InvalidReason::kMismatched, "mismatched"},
     {views::InvalidReason::kUnsure, "unsure"},
     {views::InvalidReason::kOutside, "outside"},
     {views::InvalidReason::kSpeckle, "speckle"}}};

std::uint64_t count_of(const views::DenseMatch& match, views::InvalidReason reason) {
  std::uint64_t count = 0;
  for (const views::InvalidReason one : match.invalid_reasons.pixels) count += one == reason;
  return count;
}

double total_ms(const views::DenseMatch& match) {
  double total = 0;
  for (const views::MatchStep& step : match.steps) total += step.milliseconds;
  return total;
}

// The error of depth that follows from an error of disparity: the derivative of the depth Z by the
// disparity is -Z^2/(f B), with the focal length f in px and the distance B between the cameras
// (S2-13).
struct DepthFacts {
  double median = 0;     // over the pixels that have a depth
  double per_tenth = 0;  // error at the median depth for 0.1 px of disparity
};
std::optional<DepthFacts> depth_facts(const MatchInput& input, const views::DenseMatch& match) {
  if (!input.calibration) return {};
  auto depths = views::depths_of(match.disparity, *input.calibration).pixels;
  std::erase_if(depths, [](float depth) { return !std::isfinite(depth); });
  if (depths.empty()) return {};
  const auto middle = depths.begin() + std::ptrdiff_t(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  const double z = double(*middle);
  return DepthFacts{
      z, 0.1 * z * z / (input.calibration->focal_px * std::abs(input.calibration->baseline))};
}

std::string errors_text(const MatchInput& input, const Image<float>& disparity) {
  std::string text =
      fmt::format("{:<22}{:>9}{:>9}{:>9}{:>9}{:>9}{:>11}{:>11}\n", "off by more than, %", "0.5 px",
                  "1 px", "2 px", "4 px", "RMS px", "of good px", "density %");
  for (const RegionErrors& region : evaluate_regions(input, disparity)) {
    const views::DisparityErrors& errors = region.errors;
    if (errors.known == 0) continue;  // without known pixels there are no percentages
    text += fmt::format("{:<22}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>11.3f}{:>11.1f}\n",
                        region.where, errors.bad_percent[0], errors.bad_percent[1],
                        errors.bad_percent[2], errors.bad_percent[3], errors.rms, errors.rms_good,
                        errors.density_percent);
  }
  return text + fmt::format(
                    "visible: {}.\nA pixel without disparity counts as off by more than each "
                    "limit.\ngood: pixels that are off by 1 px at most\n",
                    input.visible_by);
}

}  // namespace

std::string match_text(const MatchInput& input, const views::MatchSettings& settings,
                       const views::DenseMatch& match) {
  std::string text = fmt::format("{}\ndisparities {} to {}, {}, {} paths, {} MB of volumes\n",
                                 printable(input.description, kLongPath), settings.range.first,
                                 settings.range.last, views::name_of(settings.cost), settings.paths,
                                 (match.bytes + (1u << 20) - 1) >> 20);
  std::string names;
  for (const auto& [reason, name] : kInvalidReasons) {
    const double share =
        100 * double(count_of(match, reason)) / double(match.invalid_reasons.pixels.size());
    names += fmt::format("{}{} {:.1f} %", names.empty() ? "" : ", ", name, share);
  }
  text += fmt::format("uncertain: {}{}\n", names, settings.fill ? " (filled)" : "");
  std::string steps;
  for (const views::MatchStep& step : match.steps) {
    steps += fmt::format("{}{} {:.1f}", steps.empty() ? "" : ", ", step.name, step.milliseconds);
  }
  text += fmt::format("{:.1f} ms on {}: {}\n", total_ms(match), name_of(settings.target), steps);
  if (const auto depth = depth_facts(input, match)) {
    text += fmt::format(
        "the median depth is {:.4g}; there 0.1 px of disparity is {:.2g} of depth, Z^2 0.1/(f B)\n",
        depth->median, depth->per_tenth);
  }
  if (input.rectification) text += "\n" + rectification_text(*input.rectification);
  if (input.truth) text += "\n" + errors_text(input, match.disparity);
  text += "\nleft out\n";
  for (const OmittedItem& one : omitted_items(input, settings, match)) {
    text += wrapped("  - ", one.what + ": " + one.why);
  }
  return text;
}

Json match_json(const MatchInput& input, const views::MatchSettings& settings,
                const views::DenseMatch& match) {
  Json json{{"pair", input.description},
            {"width", match.disparity.width},
            {"height", match.disparity.height},
            {"range", {settings.range.first, settings.range.last}},
            {"cost", views::name_of(settings.cost)},
            {"paths", settings.paths},
            {"planes", settings.planes},
            {"volume_bytes", match.bytes},
            {"target", name_of(settings.target)}};
  for (const auto& [reason, name] : kInvalidReasons)
    json["in_doubt"][name] = count_of(match, reason);
  json["ms"] = total_ms(match);
  for (const views::MatchStep& step : match.steps) json["steps_ms"][step.name] = step.milliseconds;
  if (const auto depth = depth_facts(input, match)) {
    json["depth"] = {{"median", depth->median}, {"error_of_a_tenth_px", depth->per_tenth}};
  }
  if (input.rectification) json["rectification"] = rectification_json(*input.rectification);
  for (const OmittedItem& one : omitted_items(input, settings, match)) {
    json["left_out"].push_back({{"what", one.what}, {"why", one.why}});
  }
  if (!input.truth) return json;
  json["visible_by"] = input.visible_by;
  for (const RegionErrors& region : evaluate_regions(input, match.disparity)) {
    const views::DisparityErrors& errors = region.errors;
    Json one{{"pixels", errors.known}};
    for (std::size_t i = 0; i < views::kBadAt.size(); ++i) {
      one["bad_percent"][fmt::format("{:g}", views::kBadAt[i])] = errors.bad_percent[i];
    }
    one["rms_px"] = errors.rms;
    one["rms_good_px"] = errors.rms_good;
    one["density_percent"] = errors.density_percent;
    json["errors"][region.key] = one;
  }
  return json;
}

}  // namespace glassbox::views
