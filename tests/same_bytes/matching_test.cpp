// The disparities that `views match` finds in two pictures: in rendered pairs, and in unrealistic
// pictures.
#include "tests/same_bytes/configurations.h"
#include "tests/same_bytes/generated_pair.h"
#include "views/matching/calibration.h"
#include "views/matching/match.h"
#include "views/matching/rendered_pair.h"
#include "views/matching/surface.h"

#include <glassbox/render/renderer.h>

namespace glassbox {
namespace {

using test::Configuration;
using test::GeneratedPair;
using test::RunResult;
using views::MatchingCost;
using views::MatchSettings;

template <class T>
T one_of(std::initializer_list<T> values, Random& random) {
  return values.begin()[random.integer(0, std::int64_t(values.size()) - 1)];
}

MatchSettings any_settings(Random& random) {
  const auto one_in = [&](int n) { return random.integer(1, n) == 1; };
  MatchSettings settings;
  settings.range.first = int(random.integer(-12, 6));
  settings.range.last = settings.range.first + int(random.integer(0, 33));
  settings.cost = one_of({MatchingCost::kSad, MatchingCost::kSsd, MatchingCost::kNcc,
                          MatchingCost::kZncc, MatchingCost::kCensus, MatchingCost::kAdCensus},
                         random);
  settings.window =
      views::is_correlation(settings.cost) ? one_of({3, 7}, random) : one_of({1, 1, 3, 5}, random);
  settings.adaptive = one_of({0, 0, 1, 2}, random);
  settings.paths = one_of({0, 2, 4, 8, 16}, random);
  settings.single_sweep = one_in(3);
  settings.subpixel = !one_in(4);
  if (one_in(3)) settings.left_right.reset();
  settings.confidence = one_in(3) ? 0.05f : 0.0f;
  settings.planes = one_in(4) ? 2 : 0;
  settings.speckle = one_in(4) ? 5 : 0;
  settings.median = !one_in(3);
  settings.smooth = !one_in(3);
  settings.vote = !one_in(3);
  settings.fill = !one_in(3);
  settings.keep_sums = one_in(4);
  return settings;
}

struct TwoPictures {
  Image<Rgba8> left, right;
};

// Noise of few or many colours; some of its pixels show nothing.
TwoPictures any_pictures(Random& random) {
  const int width = int(random.integer(1, 70)), height = int(random.integer(1, 30));
  const int step = one_of({1, 16, 100}, random);
  TwoPictures pictures{Image<Rgba8>(width, height), Image<Rgba8>(width, height)};
  for (Image<Rgba8>* picture : {&pictures.left, &pictures.right}) {
    for (Rgba8& pixel : picture->pixels) {
      const std::uint64_t bits = random.bits();
      const auto byte = [&](int at) { return std::uint8_t(int(bits >> at & 255) / step * step); };
      pixel = {byte(0), byte(8), byte(16), std::uint8_t((bits >> 24) % 16 == 0 ? 0 : 255)};
    }
  }
  return pictures;
}

TwoPictures drawn(const GeneratedPair& pair) {
  const test::GeneratedCase& c = pair.scene;
  Renderer renderer(c.scene, c.settings.transfer, EngineKind::kStaged);
  StereoRendering eyes = renderer.render_pair(c.view, pair.eyes, {c.settings});
  return {std::move(eyes.left.color), std::move(eyes.right.color)};
}

// Returns how many pixels have a disparity.
std::size_t check_match(std::uint64_t seed) {
  Random random(seed);
  MatchSettings settings = any_settings(random);
  const auto pair = test::generate_pair(seed, 60);
  const TwoPictures pictures = seed % 2 == 0 && pair ? drawn(*pair) : any_pictures(random);
  const views::Calibration calibration{100, 0.1, 20};
  std::size_t answered = 0;
  test::check_same_result(seed, [&](const Configuration& configuration) {
    settings.target = configuration.target;
    settings.threads = configuration.threads;
    const auto match = views::match_pictures(pictures.left, pictures.right, settings);
    RunResult made;
    if (!match) {
      made.add("refusal", match.error().message());
      return made;
    }
    answered = std::size_t(std::ranges::count_if(
        match->disparity.pixels, [](float disparity) { return std::isfinite(disparity); }));
    made.add("disparity", match->disparity);
    made.add("confidence", match->confidence);
    made.add("doubts", match->invalid_reasons);
    made.add("sums", match->sums.costs);
    made.add("depths", views::depths_of(match->disparity, calibration));
    made.add("surface", views::encode_ply(
                            views::surface_of(pictures.left, match->disparity, calibration), ""));
    return made;
  });
  return answered;
}

// Tests the pair that `views match --scene` draws, and its true disparities.
std::size_t check_rendered_pair(std::uint64_t seed) {
  const auto pair = test::generate_pair(seed, 90);
  if (!pair) return 0;
  const test::GeneratedCase& c = pair->scene;
  test::check_same_result(seed, [&](const Configuration&) {
    const auto rendered = views::rendered_pair(c.scene, c.view, pair->eyes, c.settings);
    RunResult made;
    if (!rendered) {
      made.add("refusal", rendered.error().message());
      return made;
    }
    made.add("left", rendered->left);
    made.add("right", rendered->right);
    made.add("truth", rendered->truth.disparity);
    made.add("what both see", rendered->truth.is_visible);
    made.add("texture", rendered->is_textured);
    return made;
  });
  return 1;
}

TEST_CASE("disparities have the same bytes in every way, whatever is asked for", "[matching]") {
  CHECK(test::sum_over_seeds(20 / test::kCaseDivisor, check_match) > 5000 / test::kCaseDivisor);
}

TEST_CASE("the pair that is drawn to be matched has the same bytes in every way", "[matching]") {
  CHECK(test::sum_over_seeds(20 / test::kCaseDivisor, check_rendered_pair) >
        10 / test::kCaseDivisor);
}

TEST_CASE("a thousand matches", "[.same-bytes]") {
  CHECK(test::sum_over_seeds(1000, check_match) > 0);
  CHECK(test::sum_over_seeds(300, check_rendered_pair) > 0);
}

}  // namespace
}  // namespace glassbox
