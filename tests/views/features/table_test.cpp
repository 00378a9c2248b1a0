// Measures detectors and descriptors: the tables of docs/views.md. They are no tests, because they
// measure time, and because some of their pictures are not part of the project.
#include <tests/support/catch.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/views/features/generated_pictures.h"
#include "views/features/features.h"
#include "views/features/match_features.h"
#include "views/files/camera_file.h"
#include "views/two_view/residual.h"
#include "views/two_view/triangulation.h"

#include <glassbox/base/processor_time.h>
#include <glassbox/images/read.h>

namespace glassbox::views {
namespace {

// What is known of a pair: whether a match is right, and whether a left point has a corner of the
// right picture beside it; nothing where the truth is unknown.
struct JudgedPair {
  Image<Rgba8> left, right;
  std::function<std::optional<bool>(const Match&)> is_right;
  bool has_places = true;  // false: only the line of a match is known
};

struct Measured {
  int pairs = 0, matches = 0, right = 0;
  double ms = 0, repeated = 0;
};

// The share of the left features beside which the right picture has a feature, where that is known.
double repeatability(const JudgedPair& pair, const FeatureSet& left, const FeatureSet& right) {
  int known = 0, repeated = 0;
  for (const Feature& l : left.features) {
    bool is_known = false, is_repeated = false;
    for (const Feature& r : right.features) {
      const auto verdict = pair.is_right({{l.x, l.y}, {r.x, r.y}});
      is_known = is_known || verdict;
      is_repeated = is_repeated || verdict.value_or(false);
    }
    known += is_known;
    repeated += is_repeated;
  }
  return double(repeated) / std::max(known, 1);
}

void measure(const JudgedPair& pair, const FeatureSettings& settings, const MatchRules& rules,
             Measured& measured) {
  const double start = processor_ms();
  const FeatureSet left = features_of(pair.left, settings),
                   right = features_of(pair.right, settings);
  const auto matches = match_features(left, right, rules);
  measured.ms += processor_ms() - start;
  ++measured.pairs;
  if (pair.has_places) measured.repeated += repeatability(pair, left, right);
  for (const Match& match : positions_of(left, right, matches)) {
    const auto verdict = pair.is_right(match);
    measured.matches += verdict.has_value();
    measured.right += verdict.value_or(false);
  }
}

constexpr double kTableWithin = 3;  // px

JudgedPair judged(const test::KnownPair& known) {
  return {known.left, known.right, [known](const Match& match) -> std::optional<bool> {
            const auto truth = known.in_right(match.left);
            if (!known.is_inside(truth, kFeatureMargin)) return {};
            return (truth - match.right).norm() <= kTableWithin;
          }};
}

// A folder of the Middlebury pairs of 2003: im2.ppm, im6.ppm and the left disparities, times 4.
JudgedPair rectified_pair(const std::filesystem::path& folder) {
  const auto disparities = read_image(folder / "disp2.pgm");
  REQUIRE(disparities);
  return {*read_image(folder / "im2.ppm"), *read_image(folder / "im6.ppm"),
          [truth = *disparities](const Match& match) -> std::optional<bool> {
            const auto code = truth.at(int(match.left.x()), int(match.left.y())).r;
            if (code == 0) return {};
            const Eigen::Vector2d place = match.left - Eigen::Vector2d(code / 4.0, 0);
            return (place - match.right).norm() <= kTableWithin;
          }};
}

std::vector<JudgedPair> ring_pairs(const std::filesystem::path& folder) {
  std::ifstream file(folder / "templeSR_par.txt");
  const auto cameras = parse_cameras(std::string(std::istreambuf_iterator<char>(file), {}));
  REQUIRE(cameras);
  std::vector<JudgedPair> pairs;
  for (std::size_t i = 0; i + 1 < cameras->size(); ++i) {
    const auto &l = (*cameras)[i], &r = (*cameras)[i + 1];
    const Matrix3d f =
        fundamental_of({l.camera.intrinsic, r.camera.intrinsic, relative_pose(l.camera, r.camera)});
    pairs.push_back({*read_image(folder / l.picture), *read_image(folder / r.picture),
                     [f](const Match& match) -> std::optional<bool> {
                       return std::abs(sampson_distance(f, match)) <= kTableWithin / 2;
                     },
                     false});
  }
  return pairs;
}

struct NamedPairs {
  std::string name;
  std::vector<JudgedPair> pairs;
};

std::vector<NamedPairs> generated() {
  std::vector<std::pair<std::string, test::PictureChange>> changes;
  const auto add = [&](const std::string& name, double degrees, double scale) {
    test::PictureChange change;
    change.degrees = degrees;
    change.scale = scale;
    change.shift = {4.3, -2.7};
    change.noise = 4;
    changes.emplace_back(name, change);
  };
  add("shifted", 0, 1);
  for (const int degrees : {10, 30, 90, 180}) add(fmt::format("turned by {}", degrees), degrees, 1);
  for (const double scale : {1.1, 1.5, 2.0}) add(fmt::format("scaled by {:g}", scale), 0, scale);
  add("turned by 40, scaled by 1.5", 40, 1.5);
  changes.push_back(changes.front());
  changes.back().first = "darker: 0.5 x + 20";
  changes.back().second.gain = 0.5;
  changes.back().second.offset = 20;
  changes.push_back(changes.front());
  changes.back().first = "noise of 12 grey levels";
  changes.back().second.noise = 12;
  std::vector<NamedPairs> all;
  for (const auto& [name, change] : changes) {
    all.push_back({name, {}});
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      all.back().pairs.push_back(judged(test::known_pair(seed, 400, 300, change)));
    }
  }
  return all;
}

void print_table(const std::vector<NamedPairs>& all, const MatchRules& rules) {
  for (const NamedPairs& named : all) {
    for (const Detector detector : kDetectors) {
      std::string line = fmt::format("| {} | {} |", named.name, name_of(detector));
      for (const Description description : kDescriptions) {
        Measured sum;
        for (const JudgedPair& pair : named.pairs) {
          measure(pair, {detector, description, 1000}, rules, sum);
        }
        line +=
            fmt::format(" {:.0f} % | {} of {}, {:.0f} % | {:.0f} |", 100 * sum.repeated / sum.pairs,
                        sum.right / sum.pairs, sum.matches / sum.pairs,
                        100.0 * sum.right / std::max(sum.matches, 1), sum.ms / sum.pairs);
      }
      fmt::print("{}\n", line);
    }
  }
}

// test_views "[.features]" prints the table of generated pictures: for each descriptor, the share
// of corners that come back, right matches of all matches, and the processor time in ms; with
// STEREO=FOLDER also those of the folders teddy, cones and templeSparseRing in it.
TEST_CASE("how many corners come back, and how many matches are right", "[.features]") {
  print_table(generated(), {});
  const char* folder = std::getenv("STEREO");
  if (folder == nullptr) return;
  const std::filesystem::path stereo(folder);
  print_table({{"teddy", {rectified_pair(stereo / "teddy")}},
               {"cones", {rectified_pair(stereo / "cones")}},
               {"temple", ring_pairs(stereo / "multiview" / "templeSparseRing")}},
              {});
}

}  // namespace
}  // namespace glassbox::views
