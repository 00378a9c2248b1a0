#include "app/views/match_report.h"

#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <glassbox/base/printable.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

struct Judged {
  const char* where;  // in words
  const char* key;
  views::DisparityErrors errors;
};

std::vector<Judged> judge(const MatchInput& input, const Image<float>& disparity) {
  const views::StereoTruth& truth = *input.truth;
  std::vector<Judged> all;
  if (input.is_textured) {
    Image<std::uint8_t> both = truth.is_visible;
    for (std::size_t i = 0; i < both.pixels.size(); ++i)
      both.pixels[i] &= input.is_textured->pixels[i];
    all.push_back({"visible and textured", "visible_and_textured",
                   views::evaluate(disparity, truth.disparity, &both)});
  }
  all.push_back({"visible to both", "visible",
                 views::evaluate(disparity, truth.disparity, &truth.is_visible)});
  all.push_back({"all known", "all", views::evaluate(disparity, truth.disparity)});
  return all;
}

constexpr std::array<std::pair<views::Doubt, const char*>, 5> kDoubts{
    {{views::Doubt::kOccluded, "occluded"},
     {views::Doubt::kMismatched, "mismatched"},
     {views::Doubt::kUnsure, "unsure"},
     {views::Doubt::kOutside, "outside"},
     {views::Doubt::kSpeckle, "speckle"}}};

std::uint64_t count_of(const views::DenseMatch& match, views::Doubt doubt) {
  std::uint64_t count = 0;
  for (const views::Doubt one : match.doubts.pixels) count += one == doubt;
  return count;
}

double total_ms(const views::DenseMatch& match) {
  double total = 0;
  for (const views::MatchStep& step : match.steps) total += step.milliseconds;
  return total;
}

std::string errors_text(const MatchInput& input, const Image<float>& disparity) {
  std::string text = fmt::format("{:<22}{:>9}{:>9}{:>9}{:>9}{:>9}{:>10}\n", "off by more than, %",
                                 "0.5 px", "1 px", "2 px", "4 px", "RMS px", "density %");
  for (const Judged& judged : judge(input, disparity)) {
    const views::DisparityErrors& errors = judged.errors;
    text += fmt::format("{:<22}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>10.1f}\n", judged.where,
                        errors.bad_percent[0], errors.bad_percent[1], errors.bad_percent[2],
                        errors.bad_percent[3], errors.rms, errors.density_percent);
  }
  return text +
         fmt::format("visible: {}; a pixel without disparity counts as off\n", input.visible_by);
}

}  // namespace

std::string match_text(const MatchInput& input, const views::MatchSettings& settings,
                       const views::DenseMatch& match) {
  constexpr std::size_t kLongPath = 1000;
  std::string text = fmt::format("{}\ndisparities {} to {}, {}, {} paths, {} MB of volumes\n",
                                 printable(input.about, kLongPath), settings.range.first,
                                 settings.range.last, views::name_of(settings.cost), settings.paths,
                                 (match.bytes + (1u << 20) - 1) >> 20);
  std::string doubts;
  for (const auto& [doubt, name] : kDoubts) {
    const double share = 100 * double(count_of(match, doubt)) / double(match.doubts.pixels.size());
    doubts += fmt::format("{}{} {:.1f} %", doubts.empty() ? "" : ", ", name, share);
  }
  text += fmt::format("in doubt: {}{}\n", doubts, settings.fill ? " (filled)" : "");
  std::string steps;
  for (const views::MatchStep& step : match.steps) {
    steps += fmt::format("{}{} {:.1f}", steps.empty() ? "" : ", ", step.name, step.milliseconds);
  }
  text += fmt::format("{:.1f} ms on {}: {}\n", total_ms(match), name_of(settings.target), steps);
  return input.truth ? text + "\n" + errors_text(input, match.disparity) : text;
}

Json match_json(const MatchInput& input, const views::MatchSettings& settings,
                const views::DenseMatch& match) {
  Json json{{"pair", input.about},
            {"width", match.disparity.width},
            {"height", match.disparity.height},
            {"range", {settings.range.first, settings.range.last}},
            {"cost", views::name_of(settings.cost)},
            {"paths", settings.paths},
            {"volume_bytes", match.bytes},
            {"target", name_of(settings.target)}};
  for (const auto& [doubt, name] : kDoubts) json["in_doubt"][name] = count_of(match, doubt);
  json["ms"] = total_ms(match);
  for (const views::MatchStep& step : match.steps) json["steps_ms"][step.name] = step.milliseconds;
  if (!input.truth) return json;
  json["visible_by"] = input.visible_by;
  for (const Judged& judged : judge(input, match.disparity)) {
    const views::DisparityErrors& errors = judged.errors;
    Json one{{"pixels", errors.known}};
    for (std::size_t i = 0; i < views::kBadAt.size(); ++i) {
      one["bad_percent"][fmt::format("{:g}", views::kBadAt[i])] = errors.bad_percent[i];
    }
    one["rms_px"] = errors.rms;
    one["density_percent"] = errors.density_percent;
    json["errors"][judged.key] = one;
  }
  return json;
}

}  // namespace glassbox::app
