// Compares SSIM, FLIP and the plain errors with a second computation of them:
// tests/metrics/reference/metrics.py, in double precision, with two-dimensional kernels. That
// program wrote values.txt from the same pictures, which are made here by the same formulas.
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <string>

#include <glassbox/compare/metrics/metric.h>

#include "tests/metrics/pictures.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using test::noise;
using test::picture;
using test::WholePair;

using Formula = std::function<int(int, int, int)>;

int gradient(int x, int y, int c) {
  return c == 0 ? 255 * x / 66 : c == 1 ? 255 * y / 40 : 128;
}
int blocks(int x, int y, int c) {
  return noise(x / 8, y / 8, c, 1);
}
int to_the_right(int x, int y, int c) {
  return blocks(std::max(x - 1, 0), y, c);
}
int slope(int x, int y, int) {
  return 90 + (x + y) / 2;
}
int magenta_dot(int x, int y, int c) {
  return x == 24 && y == 20 ? (c == 1 ? 0 : 255) : slope(x, y, c);
}
int grey(int x, int y, int) {
  return noise(x, y, 0, 2) / 2 + 64;
}
int deep(int x, int y, int c) {
  return 257 * gradient(x, y, c);
}
int transparent(int x, int y, int c) {
  return c == 3 ? 4 * x : blocks(x, y, c);
}
int deep_transparent(int x, int y, int c) {
  return c == 0 ? 251 * noise(x, y, c, 4) : 2000 * x;
}

// Samples that are only 0 or 255.
Formula saturated(Formula sample) {
  return [=](int x, int y, int c) { return sample(x, y, c) / 128 * 255; };
}

// `sample` with a pseudo-random change of at most `spread` up or down.
Formula speckled(Formula sample, int seed, int spread, int largest = 255) {
  return [=](int x, int y, int c) {
    const int change = noise(x, y, c, seed) % (2 * spread + 1) - spread;
    return std::min(std::max(sample(x, y, c) + change, 0), largest);
  };
}

template <class Sample>
WholePair pair_of(int width, int height, int channels, const Formula& reference,
                  const Formula& test) {
  return {picture<Sample>(width, height, channels, reference),
          picture<Sample>(width, height, channels, test)};
}

std::map<std::string, WholePair> cases() {
  using Byte = std::uint8_t;
  using Word = std::uint16_t;
  const auto constant = [](int value) { return [=](int, int, int) { return value; }; };
  const auto primary = [](int which) {
    return [=](int, int, int c) { return c == which ? 255 : 0; };
  };
  const auto random = [](int seed) {
    return [=](int x, int y, int c) { return noise(x, y, c, seed); };
  };
  std::map<std::string, WholePair> pairs;
  pairs.emplace("noise on a gradient",
                pair_of<Byte>(67, 41, 3, gradient, speckled(gradient, 5, 8)));
  pairs.emplace("blocks moved by a pixel", pair_of<Byte>(96, 64, 3, blocks, to_the_right));
  pairs.emplace("saturated blocks moved",
                pair_of<Byte>(96, 64, 3, saturated(blocks), saturated(to_the_right)));
  pairs.emplace("one magenta pixel", pair_of<Byte>(48, 40, 3, slope, magenta_dot));
  pairs.emplace("one step brighter", pair_of<Byte>(40, 30, 1, grey, [](int x, int y, int c) {
                  return grey(x, y, c) + 1;
                }));
  pairs.emplace("16 bits", pair_of<Word>(67, 41, 3, deep, speckled(deep, 6, 100, 65535)));
  pairs.emplace("alpha alone", pair_of<Byte>(64, 40, 4, transparent, [](int x, int y, int c) {
                  return c == 3 ? speckled(transparent, 3, 10)(x, y, c) : transparent(x, y, c);
                }));
  pairs.emplace(
      "grey and alpha, 16 bits",
      pair_of<Word>(33, 29, 2, deep_transparent, speckled(deep_transparent, 7, 127, 65535)));
  pairs.emplace("red and green", pair_of<Byte>(1, 1, 3, primary(0), primary(1)));
  pairs.emplace("black and white", pair_of<Byte>(20, 20, 1, constant(0), constant(255)));
  pairs.emplace("two rows", pair_of<Byte>(7, 2, 3, random(8), random(9)));
  pairs.emplace("unrelated noise", pair_of<Byte>(50, 50, 3, random(10), random(11)));
  return pairs;
}

// The largest difference to expect between a metric in single precision and one in double.
//
// FLIP, one pixel: its lightness, in [0, 1], is off by at most 4 roundings of 2^-24. A filter whose
// positive weights sum up to 1 and whose negative ones to -1 doubles that error and adds its own
// roundings, fewer than 12 of values below 1: the strength of a feature is off by at most 1.2e-6.
// The feature error is sqrt(strength / sqrt(2)), which is worst where the strength is 0: 9.2e-4.
// The colour error c becomes c^(1 - feature), whose slope |c ln c| is at most 0.37: 3.4e-4. The
// rounding of colours, and 2^-17 for the bins of the percentiles, add less than 1e-5.
//
// FLIP, the mean: roundings have either sign and a root mean square of 2^-25, so they mostly cancel
// in a filter whose weights have a root sum of squares near 0.1. A strength is typically off by
// 4e-9, which makes 2e-5 where the strength is 0, and less elsewhere.
//
// SSIM: 5e-11 for a window (ssim.h), and 2^-33 for the mean (fixed_sum.h). The other metrics are
// computed in double on both sides.
double tolerance(const std::string& metric) {
  if (metric == "flip.mean") return 2e-5;
  if (metric.starts_with("flip.")) return 3.5e-4;
  if (metric.starts_with("ssim.")) return 2e-10;
  return 1e-12;
}

}  // namespace

TEST_CASE("metrics agree with their computation in double precision from the papers", "[metrics]") {
  std::ifstream file(GLASSBOX_SOURCE_DIR "/tests/metrics/reference/values.txt");
  REQUIRE(file);
  const auto pairs = cases();
  std::map<std::string, int> values_of;
  std::string name, metric, number;
  while (std::getline(file, name, '\t') && std::getline(file, metric, '\t') &&
         std::getline(file, number)) {
    INFO(name << ", " << metric << ", computed a second time: " << number);
    REQUIRE(pairs.count(name) == 1);
    const auto requests = parse_metrics(metric);
    REQUIRE(requests);
    const MetricValue value = measure_metrics(pairs.at(name), *requests).front();
    REQUIRE(value.value);
    CHECK(std::abs(*value.value - std::stod(number)) <= tolerance(metric));
    ++values_of[name];
  }
  for (const auto& [pair, picture] : pairs) {
    INFO(pair);
    const bool has_windows = picture.reference.width >= 11 && picture.reference.height >= 11;
    CHECK(values_of[pair] == (has_windows ? 9 : 7));
  }
}
