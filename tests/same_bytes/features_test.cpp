// The corners, descriptors and matches that `views geometry --pair` finds.
#include "tests/render/tile/generated_case.h"
#include "tests/same_bytes/configurations.h"
#include "tests/views/features/generated_pictures.h"
#include "views/features/match_features.h"

namespace glassbox {
namespace {

using test::Configuration;
using test::RunResult;

// Returns the number of matches.
std::size_t check_features(std::uint64_t seed) {
  Random random(seed);
  test::PictureChange change;
  change.degrees = random.between(-30, 30);
  change.scale = random.between(0.8, 1.2);
  change.noise = random.between(0, 5);
  const int width = int(random.integer(1, 200));
  const int height = int(random.integer(1, 150));
  const test::KnownPair pair = test::known_pair(seed, width, height, change);
  views::FeatureSettings settings;
  settings.detector = views::kDetectors[random.integer(0, 1)];
  settings.description = views::kDescriptions[random.integer(0, 2)];
  settings.count = int(random.integer(1, 300));
  std::size_t found = 0;
  test::check_same_result(seed, [&](const Configuration&) {
    const views::FeatureSet left = views::features_of(pair.left, settings);
    const views::FeatureSet right = views::features_of(pair.right, settings);
    const auto matches = views::match_features(left, right, {0.9, true});
    found = matches.size();
    RunResult made;
    made.add_number("corners", left.corners);
    for (const views::Feature& feature : left.features) {
      made.add("a feature",
               std::vector{feature.x, feature.y, feature.scale, feature.angle, feature.strength});
    }
    std::visit(
        [&](const auto& descriptors) {
          for (const auto& one : descriptors)
            made.add("a descriptor", std::as_bytes(std::span(one)));
        },
        left.descriptors);
    for (const views::FeatureMatch& match : matches) {
      made.add("a match", std::vector{match.left, match.right});
      made.add("its distance", std::vector{match.distance, match.ratio});
    }
    return made;
  });
  return found;
}

TEST_CASE("corners, descriptors and matches have the same bytes in every way", "[features]") {
  CHECK(test::sum_over_seeds(20 / test::kCaseDivisor, check_features) > 100 / test::kCaseDivisor);
}

TEST_CASE("the features of a thousand pairs", "[.same-bytes]") {
  CHECK(test::sum_over_seeds(1000, check_features) > 0);
}

}  // namespace
}  // namespace glassbox
