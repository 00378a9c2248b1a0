#include "views/commands/geometry.h"

#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/arguments.h"
#include "cli/options/choices.h"

#include <glassbox/base/counted.h>

namespace glassbox::views {

namespace {

constexpr int kFewestMatches = 8;

Result<void> check_corners(const GeometryInput& input, const FeatureSet& set, std::size_t side) {
  constexpr int kLeastSide = 2 * kFeatureMargin + 1;
  const Image<Rgba8>& picture = (*input.pictures)[side];
  if (std::min(picture.width, picture.height) < kLeastSide) {
    return fail("--pair",
                fmt::format("the pictures are {} x {}, but a corner needs {} x {} pixels around it",
                            picture.width, picture.height, kLeastSide, kLeastSide),
                "give larger pictures, or their matches with --matches");
  }
  if (set.corners > 0) return {};
  return tl::unexpected(Error{input.picture_names[side], "",
                              "has no corners: it shows one colour, or only smooth changes and "
                              "straight edges",
                              "give a picture with more detail, or the matches with --matches"});
}

Result<void> check_count(const FoundMatches& found) {
  const auto count = int(found.matches.size());
  if (count >= kFewestMatches) return {};
  return fail("--pair",
              fmt::format("{} found between the {} and {} corners of the pictures, but {} are "
                          "needed",
                          count == 1 ? "1 match was" : fmt::format("{} matches were", count),
                          found.corners[0], found.corners[1], kFewestMatches),
              "give pictures that show more of the same, more --features, or a larger --ratio");
}

MatchRules rules_for(const GeometryMatching& matching, const Image<Rgba8>& picture) {
  MatchRules rules = matching.rules;
  if (matching.search) {
    rules.search = *matching.search;
  } else if (matching.settings.description == Description::kNcc) {
    rules.search = picture.width / 4.0;
  }
  return rules;
}

}  // namespace

void add_matching_options(CLI::App& command, GeometryMatching& matching) {
  const std::string group = "Matches of --pair that are found";
  const std::size_t before = command.get_options().size();
  add_choice(command, "--detect", matching.settings.detector,
             choices_of({Detector::kHarris, Detector::kShiTomasi}),
             fmt::format("how corners are found [{}]", name_of(matching.settings.detector)))
      ->group(group);
  add_choice(command, "--describe", matching.settings.description,
             choices_of({Description::kNcc, Description::kOrb, Description::kSift}),
             fmt::format("what is compared of two corners: windows of grey levels, for pictures "
                         "that are not turned or scaled; bits; histograms of gradients [{}]",
                         name_of(matching.settings.description)))
      ->group(group);
  command
      .add_option(
          "--features", matching.settings.count,
          fmt::format("largest number of corners in each picture [{}]", matching.settings.count))
      ->type_name("N")
      ->group(group);
  const auto add_real = [&](const char* name, const char* type, const auto& set,
                            const std::string& help) {
    command
        .add_option_function<std::string>(
            name, [name, set](const std::string& text) { set(parse_number(name, text)); }, help)
        ->type_name(type)
        ->group(group);
  };
  add_real(
      "--ratio", "R", [&matching](double value) { matching.rules.ratio = value; },
      fmt::format("largest ratio of the distances to the nearest and the second nearest "
                  "descriptor, 0 < R <= 1; 1 is no test [{:g}]",
                  matching.rules.ratio));
  command
      .add_flag_callback(
          "--no-cross-check", [&matching] { matching.rules.cross_check = false; },
          "keep matches whose left corner is not the nearest of the right one")
      ->group(group);
  add_real(
      "--search", "PX", [&matching](double value) { matching.search = value; },
      "largest difference of x, and of y, between the corners of a match (px) [with --describe ncc "
      "a quarter of the width, else no limit]");
  const auto all = command.get_options();
  matching.options.assign(all.begin() + std::ptrdiff_t(before), all.end());
}

Result<void> check_matching(const GeometryMatching& matching) {
  constexpr int kMostFeatures = 10'000;
  const int count = matching.settings.count;
  if (count < kFewestMatches || count > kMostFeatures) {
    return fail(
        "--features",
        fmt::format("{} corners are {}", count, count < kFewestMatches ? "too few" : "too many"),
        fmt::format("give {} to {}", kFewestMatches, kMostFeatures));
  }
  if (const double ratio = matching.rules.ratio; !(ratio > 0 && ratio <= 1)) {
    return fail("--ratio", fmt::format("{:g} is not above 0 and at most 1", ratio),
                "give 0 < R <= 1, such as 0.8");
  }
  if (const double search = matching.search.value_or(1); !(search > 0 && std::isfinite(search))) {
    return fail("--search", fmt::format("{:g} px is not possible as a distance", search),
                "give a number above 0");
  }
  return {};
}

Result<void> find_matches(const GeometryMatching& matching, GeometryInput& input) {
  const auto& [left, right] = *input.pictures;
  const FeatureSet of_left = features_of(left, matching.settings);
  if (const auto legal = check_corners(input, of_left, 0); !legal) return legal;
  const FeatureSet of_right = features_of(right, matching.settings);
  if (const auto legal = check_corners(input, of_right, 1); !legal) return legal;
  FoundMatches found;
  found.settings = matching.settings;
  found.rules = rules_for(matching, left);
  found.corners = {of_left.corners, of_right.corners};
  found.matches = match_features(of_left, of_right, found.rules);
  if (const auto legal = check_count(found); !legal) return legal;
  input.matches = positions_of(of_left, of_right, found.matches);
  input.found = std::move(found);
  return {};
}

std::string matching_text(const FoundMatches& found) {
  std::string text = name_of(found.settings.description);
  if (found.rules.ratio < 1) {
    text += fmt::format(", at most {:g} times as far as the second nearest", found.rules.ratio);
  }
  if (found.rules.cross_check) text += ", each the nearest of the other";
  if (std::isfinite(found.rules.search)) {
    text += fmt::format(", moved by at most {:g} px in x and y", found.rules.search);
  }
  return text;
}

}  // namespace glassbox::views
