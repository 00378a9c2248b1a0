#include "tests/support/catch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/images/colour/ciede2000.h>
#include <glassbox/images/stereo/recolour.h>

#include "tests/images/stereo/pictures.h"

namespace {

using namespace glassbox;
using test::noise;
using enum AnaglyphMethod;

AnaglyphViewing seen(AnaglyphMethod method) {
  const auto how = anaglyph_viewing(method);
  REQUIRE(how);
  return *how;
}

// Returns a picture of a few strong colours and a dull one that cover unequal areas.
Image<Rgba8> patches() {
  Image<Rgba8> picture(8, 8, {120, 130, 140, 255});
  for (int x = 0; x < 8; ++x) {
    picture.at(x, 0) = {220, 30, 20, 255};
    picture.at(x, 1) = {20, 160, 40, 255};
    picture.at(x, 2) = {40, 60, 210, 255};
    picture.at(x, 3) = {230, 220, 60, 255};
  }
  return picture;
}

}  // namespace

// Computed in floats: each of the 3 sums of 3 products and the mean has an error of a few 2^-24.
TEST_CASE("recolouring is b + (1 - b) lerp(c, luma, k)") {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Linear c{float(random.unit()), float(random.unit()), float(random.unit())};
    const double k = random.unit(), b = random.unit();
    const Linear changed = recoloured(c, {k, b});
    const double grey = 0.299 * double(c[0]) + 0.587 * double(c[1]) + 0.114 * double(c[2]);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double exact = b + (1 - b) * ((1 - k) * double(c[channel]) + k * grey);
      CHECK(std::abs(double(changed[channel]) - exact) <= 1e-6);
    }
  }
}

TEST_CASE("rivalry falls by exactly (1 - k)(1 - b) for the methods that clamp nothing (S0-15)") {
  Random random(8);
  const Image<Rgba8> left = noise(16, 16, random), right = noise(16, 16, random);
  for (const AnaglyphMethod method : {kMask, kHalf, kOptimised}) {
    const AnaglyphViewing how = seen(method);
    const auto before = measure_recolour(left, right, how, {});
    REQUIRE(before);
    CHECK(before->difference == 0);
    for (const Recolour recolour : {Recolour{0.25, 0}, Recolour{0, 0.5}, Recolour{0.7, 0.2}}) {
      CAPTURE(recolour.desaturate, recolour.brighten);
      const auto after = measure_recolour(left, right, how, recolour);
      REQUIRE(after);
      const double factor = (1 - recolour.desaturate) * (1 - recolour.brighten);
      CHECK(std::abs(after->rivalry - factor * before->rivalry) <= 1e-6);
      CHECK(after->difference > 0);
    }
  }
  // Dubois clamps the noise, so the law must fail there: the measure does not fulfil it trivially.
  const AnaglyphViewing dubois = seen(kDubois);
  const double before = measure_recolour(left, right, dubois, {})->rivalry;
  CHECK(std::abs(measure_recolour(left, right, dubois, {0.5, 0})->rivalry - before / 2) > 1e-4);
}

TEST_CASE("measures are means over all pixels of both pictures") {
  const AnaglyphViewing how = seen(kMask);
  const Recolour recolour{0.5, 0.125};
  const Image<Rgba8> left(1, 1, {200, 50, 90, 255}), right(1, 1, {10, 240, 30, 255});
  const auto measured = measure_recolour(left, right, how, recolour);
  REQUIRE(measured);
  double rivalry = 0, difference = 0;
  for (const Rgba8 pixel : {left.at(0, 0), right.at(0, 0)}) {
    const Linear c = linear_of(pixel), changed = recoloured(c, recolour);
    const auto lab = [](const Linear& v) {
      return lab_of_linear(double(v[0]), double(v[1]), double(v[2]));
    };
    rivalry += Rivalry(how)(changed) / 2;
    difference += ciede2000(lab(c), lab(changed)) / 2;
  }
  CHECK(std::abs(measured->rivalry - rivalry) <= 1e-12);
  CHECK(std::abs(measured->difference - difference) <= 1e-9);
}

TEST_CASE("recoloured pictures: identity, grey, white, and alpha as it was") {
  Random random(9);
  const Image<Rgba8> picture = noise(8, 8, random);
  CHECK(*recoloured(picture, {0, 0}) == picture);
  const auto grey = recoloured(picture, {1, 0});
  const auto white = recoloured(picture, {0, 1});
  REQUIRE((grey && white));
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const Rgba8 g = grey->pixels[i];
    CHECK((g.r == g.g && g.g == g.b && g.a == picture.pixels[i].a));
    CHECK(g.r == encode_srgb(luma(linear_of(picture.pixels[i]))));
    CHECK(white->pixels[i] == Rgba8{255, 255, 255, picture.pixels[i].a});
  }
}

TEST_CASE("the suggestion meets its target at no more difference than any strengths on a grid") {
  const Image<Rgba8> picture = patches();
  for (const AnaglyphMethod method : {kMask, kDubois}) {
    const AnaglyphViewing how = seen(method);
    const double before = measure_recolour(picture, picture, how, {})->rivalry;
    for (const double share : {0.75, 0.4, 0.1}) {
      const double target = share * before;
      CAPTURE(int(method), share);
      const auto suggestion = suggest_recolour(picture, picture, how, target);
      REQUIRE(suggestion);
      CHECK(suggestion->meets_target);
      CHECK(suggestion->chosen.rivalry <= target + 1e-6);
      double least = std::numeric_limits<double>::infinity();
      for (int k = 0; k <= 40; ++k) {
        for (int b = 0; b <= 40; ++b) {
          const auto tried = measure_recolour(picture, picture, how, {k / 40.0, b / 40.0});
          if (tried->rivalry <= target) least = std::min(least, tried->difference);
        }
      }
      CHECK(suggestion->chosen.difference <= least + 1e-3);
    }
  }
}

TEST_CASE(
    "the Pareto curve goes from no change to grey: rivalry falls in even steps, difference grows") {
  Random random(12);
  const Image<Rgba8> left = noise(80, 64, random), right = patches();
  // more than 4096 colours, which are grouped
  const Image<Rgba8> pair[2] = {left, noise(80, 64, random)};
  for (const Image<Rgba8>* eye : {&pair[0], &right}) {
    const auto suggestion = suggest_recolour(*eye, *eye, seen(kMask), 0.05, 9);
    REQUIRE(suggestion);
    CHECK(suggestion->meets_target);
    CHECK(suggestion->chosen.rivalry <= 0.05 + 1e-6);
    const auto& curve = suggestion->curve;
    REQUIRE(curve.size() == 9);
    CHECK(curve.front().difference == 0);
    CHECK(curve.back().rivalry <= 1e-6);
    for (std::size_t i = 1; i < curve.size(); ++i) {
      CHECK(curve[i].difference > curve[i - 1].difference);
      const double expected = curve.front().rivalry * (8 - double(i)) / 8;
      CHECK(std::abs(curve[i].rivalry - expected) <= 2e-6);
    }
  }
}

TEST_CASE("targets at the ends: met without change, and grey where nothing more can be done") {
  const Image<Rgba8> picture = patches();
  const auto nothing = suggest_recolour(picture, picture, seen(kMask), 1);
  REQUIRE(nothing);
  CHECK(nothing->chosen.difference == 0);
  const auto grey = suggest_recolour(picture, picture, seen(kMask), 0);
  REQUIRE(grey);
  CHECK(grey->meets_target);
  CHECK(grey->chosen.recolour.desaturate >= 0.9999);
}

TEST_CASE(
    "recolouring refuses strengths outside [0, 1], eyes of different sizes and targets that are "
    "none") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Recolour wrong : {Recolour{-0.1, 0}, Recolour{0, 1.5}, Recolour{nan, 0}}) {
    CHECK_FALSE(recoloured(Image<Rgba8>(1, 1), wrong));
    CHECK_FALSE(measure_recolour({1, 1}, {1, 1}, seen(kMask), wrong));
  }
  CHECK_FALSE(measure_recolour({1, 1}, {2, 1}, seen(kMask), {}));
  CHECK_FALSE(suggest_recolour({1, 1}, {2, 1}, seen(kMask), 0.1));
  CHECK_FALSE(suggest_recolour({1, 1}, {1, 1}, seen(kMask), -1));
  CHECK_FALSE(suggest_recolour({1, 1}, {1, 1}, seen(kMask), nan));
  CHECK(suggest_recolour({}, {}, seen(kMask), 0.1)->meets_target);
}
