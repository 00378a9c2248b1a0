// Matching of features: the rules, and how many matches are right in pictures that are turned,
// scaled, lit and disturbed in known ways.
#include <tests/support/catch.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "tests/views/features/generated_pictures.h"
#include "views/features/match_features.h"

namespace glassbox::views {
namespace {

using test::KnownPair;
using test::PictureChange;

// Features at these places, whose descriptors have as many bits set as the numbers say.
FeatureSet bits_at(const std::vector<std::array<double, 3>>& places) {
  FeatureSet set;
  std::vector<BitDescriptor> descriptors;
  for (const auto& [x, y, count] : places) {
    set.features.push_back({x, y, 1, 0, 1});
    BitDescriptor bits{};
    for (std::size_t i = 0; i < std::size_t(count); ++i) {
      bits[i / 64] |= std::uint64_t(1) << (i % 64);
    }
    descriptors.push_back(bits);
  }
  set.descriptors = std::move(descriptors);
  return set;
}

std::vector<std::pair<int, int>> numbers(const std::vector<FeatureMatch>& matches) {
  std::vector<std::pair<int, int>> result;
  for (const FeatureMatch& match : matches) result.emplace_back(match.left, match.right);
  return result;
}

using Numbers = std::vector<std::pair<int, int>>;

TEST_CASE("the nearest descriptor matches if the second nearest is clearly farther") {
  const FeatureSet left = bits_at({{50, 50, 100}});
  const FeatureSet right = bits_at({{20, 20, 120}, {60, 60, 110}, {90, 20, 60}});
  const auto matches = match_features(left, right, {0.5, true});
  REQUIRE(matches.size() == 1);
  CHECK(matches[0].right == 1);
  CHECK(matches[0].distance == 10);
  CHECK(matches[0].ratio == 0.5);
  CHECK(match_features(left, right, {0.49, true}).empty());
  // The second nearest does not count where it is the same corner, found at another scale.
  FeatureSet near = right;
  near.features[0].x = 62, near.features[0].y = 58;
  CHECK(match_features(left, near, {0.25, true}).size() == 1);
  near.features[0].x = 64;
  CHECK(match_features(left, near, {0.25, true}).empty());
  near.features[0].scale = 2;
  CHECK(match_features(left, near, {0.25, true}).size() == 1);
  // Two equal descriptors at two places tell nothing.
  const FeatureSet twice = bits_at({{20, 20, 100}, {60, 60, 100}});
  CHECK(match_features(left, twice, {0.99, true}).empty());
  CHECK(match_features(left, twice, {1, true}).size() == 1);
  // A single one has no second.
  CHECK(match_features(left, bits_at({{1, 1, 0}}), {0.01, true})[0].ratio == 0);
  CHECK(match_features(left, bits_at({}), {}).empty());
  CHECK(match_features(bits_at({}), right, {}).empty());
}

TEST_CASE("the cross check keeps a match whose left feature is the nearest of the right one") {
  const FeatureSet left = bits_at({{50, 50, 100}, {80, 80, 104}});
  const FeatureSet right = bits_at({{20, 20, 105}, {60, 60, 200}});
  CHECK(numbers(match_features(left, right, {1, true})) == Numbers{{1, 0}});
  CHECK(numbers(match_features(left, right, {1, false})) == Numbers{{0, 0}, {1, 0}});
}

TEST_CASE("only features within the search window are compared") {
  const FeatureSet left = bits_at({{50, 50, 100}});
  const FeatureSet right = bits_at({{50, 61, 100}, {59, 41, 130}});
  CHECK(numbers(match_features(left, right, {1, true})) == Numbers{{0, 0}});
  CHECK(numbers(match_features(left, right, {1, true, 10})) == Numbers{{0, 1}});
  CHECK(match_features(left, right, {1, true, 8}).empty());
}

TEST_CASE("of one point's matches at several scales the finest is kept") {
  FeatureSet left = bits_at({{50, 50, 100}, {51, 50, 20}, {90, 50, 60}});
  FeatureSet right = bits_at({{30, 30, 100}, {31, 31, 21}, {70, 30, 60}});
  left.features[0].scale = 2;
  CHECK(numbers(match_features(left, right, {1, true})) == Numbers{{1, 1}, {2, 2}});
  // Matches to two different places are two.
  right.features[1].x = 60;
  CHECK(match_features(left, right, {1, true}).size() == 3);
}

TEST_CASE("matches are those that a comparison of all pairs finds") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const auto any_set = [&] {
      std::vector<std::array<double, 3>> places;
      // 300 px apart, so that no two are at one place.
      const auto count = random.integer(0, 12);
      for (int i = 0; i < count; ++i)
        places.push_back({300.0 * i, 0, double(random.integer(0, 256))});
      return bits_at(places);
    };
    const FeatureSet left = any_set(), right = any_set();
    const double ratio = random.between(0.1, 1);
    const auto bits = [](const FeatureSet& set, std::size_t i) {
      return std::get<std::vector<BitDescriptor>>(set.descriptors)[i];
    };
    Numbers expected;
    for (std::size_t i = 0; i < left.features.size(); ++i) {
      for (std::size_t k = 0; k < right.features.size(); ++k) {
        const double own = distance(bits(left, i), bits(right, k));
        bool is_match = true;
        for (std::size_t m = 0; m < right.features.size(); ++m) {
          const double other = distance(bits(left, i), bits(right, m));
          if (m != k && !(own <= ratio * other && (other > 0 || ratio == 1))) is_match = false;
        }
        for (std::size_t m = 0; m < left.features.size(); ++m) {
          const double other = distance(bits(left, m), bits(right, k));
          if (m < i ? other <= own : other < own) is_match = false;
        }
        if (is_match) expected.emplace_back(int(i), int(k));
      }
    }
    INFO("seed " << seed);
    CHECK(numbers(match_features(left, right, {ratio, true})) == expected);
  }
}

// ---- generated pictures ----

constexpr double kRightWithin = 3;  // px

struct Counted {
  int all = 0, right = 0;
};

Counted counted_matches(const KnownPair& pair, Description description) {
  const FeatureSettings settings{Detector::kHarris, description, 1000};
  const FeatureSet left = features_of(pair.left, settings);
  const FeatureSet right = features_of(pair.right, settings);
  Counted counted;
  for (const Match& match : positions_of(left, right, match_features(left, right, {}))) {
    const auto truth = pair.in_right(match.left);
    if (!pair.is_inside(truth, 0)) continue;
    ++counted.all;
    counted.right += (truth - match.right).norm() <= kRightWithin;
  }
  return counted;
}

PictureChange any_change(Random& random) {
  PictureChange change;
  change.degrees = random.between(0, 360);
  change.scale = random.between(1 / 1.5, 1.5);
  const double x = random.between(-15, 15);
  const double y = random.between(-15, 15);
  change.shift = {x, y};
  change.gain = random.between(0.5, 1);
  change.offset = random.between(0, 40);
  change.noise = random.between(0, 6);
  return change;
}

// The share of right matches decides how many samples RANSAC needs. With 9 in 10 a sample of 8
// matches has no outlier with the probability 0.9^8 = 0.43, with 7 in 10 with 0.7^8 = 0.06: for a
// confidence of 0.99 that are 9 and 78 samples, of the 10,000 that there may be. 50 right matches
// are six times as many as the eight-point algorithm needs.
double least_right(Description description) {
  return description == Description::kOrb ? 0.7 : 0.9;
}
constexpr int kFewestRight = 50;

TEST_CASE("ORB and SIFT match pictures that are turned, scaled, lit and disturbed") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Random random(seed);
    const PictureChange change = any_change(random);
    const KnownPair pair = test::known_pair(seed, 320, 240, change);
    for (const Description description : {Description::kOrb, Description::kSift}) {
      const Counted counted = counted_matches(pair, description);
      INFO("seed " << seed << ", " << name_of(description) << ": turned by " << change.degrees
                   << ", scaled by " << change.scale << ", gain " << change.gain << ", noise "
                   << change.noise << ": " << counted.right << " of " << counted.all);
      CHECK(counted.right >= least_right(description) * counted.all);
      CHECK(counted.right >= kFewestRight);
    }
  }
}

TEST_CASE("correlation matches pictures that are turned and scaled little, and no others") {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(seed);
    PictureChange change = any_change(random);
    change.degrees = random.between(-8, 8);
    change.scale = random.between(0.92, 1.08);
    const Counted counted =
        counted_matches(test::known_pair(seed, 320, 240, change), Description::kNcc);
    INFO("seed " << seed << ": turned by " << change.degrees << ", scaled by " << change.scale
                 << ": " << counted.right << " of " << counted.all);
    CHECK(counted.right >= least_right(Description::kNcc) * counted.all);
    CHECK(counted.right >= kFewestRight);
  }
  PictureChange turned;
  turned.degrees = 60;
  CHECK(counted_matches(test::known_pair(1, 320, 240, turned), Description::kNcc).right < 8);
}

TEST_CASE("the matches of a shifted picture are a quarter of a pixel off, as its corners are") {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(seed);
    PictureChange change;
    const double x = random.between(-9, 9);
    const double y = random.between(-9, 9);
    change.shift = {x, y};
    const KnownPair pair = test::known_pair(seed, 320, 240, change);
    const FeatureSettings settings{Detector::kHarris, Description::kNcc, 500};
    const FeatureSet left = features_of(pair.left, settings);
    const FeatureSet right = features_of(pair.right, settings);
    std::vector<double> errors;
    for (const Match& match : positions_of(left, right, match_features(left, right, {})))
      errors.push_back((pair.in_right(match.left) - match.right).norm());
    REQUIRE(errors.size() > 100);
    std::ranges::sort(errors);
    INFO("seed " << seed << ": median " << errors[errors.size() / 2]);
    CHECK(errors[errors.size() / 2] < 0.25);
  }
}

TEST_CASE("a picture matches itself, corner for corner") {
  const KnownPair pair = test::known_pair(5, 320, 240, {});
  for (const Description description : kDescriptions) {
    const FeatureSet set = features_of(pair.left, {Detector::kHarris, description, 400});
    const auto matches = match_features(set, set, {});
    CHECK(matches.size() > 100);
    for (const FeatureMatch& match : matches) {
      CHECK(match.distance < 1e-3);
      CHECK(match.left == match.right);
    }
  }
}

TEST_CASE("the number of corners is at most what is asked for, over all scales") {
  const KnownPair pair = test::known_pair(6, 320, 240, {});
  for (const int count : {1, 8, 50, 333}) {
    for (const Description description : kDescriptions) {
      const FeatureSet set = features_of(pair.left, {Detector::kHarris, description, count});
      CHECK(set.corners == count);
      CHECK(set.features.size() >= std::size_t(count));
      CHECK(set.features.size() <= std::size_t(2 * count));
    }
  }
  const FeatureSet set = features_of(pair.left, {Detector::kHarris, Description::kOrb, 333});
  std::set<double> scales;
  for (const Feature& feature : set.features) scales.insert(feature.scale);
  CHECK(scales.size() == std::size_t(kMostLevels));
}

TEST_CASE("pictures without corners, and tiny ones, have no features") {
  for (const int side : {1, 2, 32, 33, 34, 50}) {
    for (const Description description : kDescriptions) {
      const Image<Rgba8> flat(side, side, Rgba8{9, 9, 9, 255});
      CHECK(features_of(flat, {Detector::kHarris, description, 100}).features.empty());
    }
  }
  CHECK(features_of(Image<Rgba8>(1000, 2), {}).features.empty());
  CHECK(features_of(Image<Rgba8>(), {}).features.empty());
}

}  // namespace
}  // namespace glassbox::views
