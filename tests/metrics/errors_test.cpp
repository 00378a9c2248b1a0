#include <glassbox/compare/metrics/errors.h>

#include <cmath>
#include <limits>

#include <glassbox/base/random.h>
#include "tests/metrics/pictures.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using test::WholePair;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

WholePair float_pair(std::vector<float> reference, std::vector<float> test) {
  const int width = int(reference.size());
  return {test::floats(width, 1, 1, std::move(reference)),
          test::floats(width, 1, 1, std::move(test))};
}

}  // namespace

TEST_CASE("the same pictures have no error and an infinite signal-to-noise ratio", "[metrics]") {
  const StoredImage image = test::noise_picture(31, 17, 4, 1);
  const SampleErrors errors = sample_errors(WholePair{image, image});
  CHECK(errors.samples == 31 * 17 * 4);
  CHECK(errors.absmax == 0);
  CHECK(errors.rmse == 0);
  CHECK(psnr(errors) == kInfinity);
}

TEST_CASE("one step on every sample is an rmse of one step", "[metrics]") {
  const auto image = [](int step) {
    return test::picture<std::uint8_t>(
        19, 23, 3, [=](int x, int y, int c) { return test::noise(x, y, c, 1) / 2 + step; });
  };
  const SampleErrors errors = sample_errors(WholePair{image(0), image(1)});
  CHECK(errors.absmax == 1 / 255.0);
  CHECK(errors.rmse == 1 / 255.0);  // sums of ones are exact
  CHECK(psnr(errors) == 20 * std::log10(1 / (1 / 255.0)));
}

TEST_CASE("16-bit samples 257 times as large have the errors of the bytes", "[metrics]") {
  const WholePair bytes{test::noise_picture(33, 20, 3, 1), test::noise_picture(33, 20, 3, 2)};
  const WholePair words{test::deepened(bytes.reference), test::deepened(bytes.test)};
  const SampleErrors a = sample_errors(bytes);
  const SampleErrors b = sample_errors(words);
  CHECK(a.absmax == b.absmax);
  // The sums are exact; only a square root and two divisions are rounded.
  CHECK(std::abs(a.rmse - b.rmse) <= 4 * 0x1p-53 * a.rmse);
}

TEST_CASE("errors do not depend on which picture is the reference", "[metrics]") {
  const WholePair pair{test::noise_picture(33, 20, 2, 1), test::noise_picture(33, 20, 2, 2)};
  CHECK(sample_errors(pair).rmse == sample_errors(pair.swapped()).rmse);
  CHECK(sample_errors(pair).absmax == sample_errors(pair.swapped()).absmax);
}

TEST_CASE("pixels that are left out count in no error", "[metrics]") {
  WholePair pair{test::noise_picture(16, 16, 3, 1), test::noise_picture(16, 16, 3, 1)};
  std::get<std::vector<std::uint8_t>>(pair.test.samples)[3 * (5 * 16 + 7)] ^= 0x80;
  CHECK(sample_errors(pair).absmax == 128 / 255.0);
  REQUIRE(pair.selection.exclude({7, 5, 1, 1}));
  const SampleErrors errors = sample_errors(pair);
  CHECK(errors.samples == 255 * 3);
  CHECK(errors.absmax == 0);
  CHECK(errors.rmse == 0);
}

TEST_CASE("the peak of floats is the reference's largest finite magnitude", "[metrics]") {
  const SampleErrors errors =
      sample_errors(float_pair({-8.0f, 1.0f, kInf, 2.0f}, {-8.0f, 1.0f, kInf, 4.0f}));
  CHECK(errors.peak == 8);
  CHECK(errors.absmax == 2);
  CHECK(errors.rmse == 1);  // sqrt(2^2 / 4)
  CHECK(psnr(errors) == 20 * std::log10(8.0));
}

TEST_CASE("NaN against a number and infinities that differ are infinite errors", "[metrics]") {
  for (const bool nan_equals_nan : {false, true}) {
    for (const auto& [a, b] : {std::pair{kNaN, 1.0f}, {kInf, 1.0f}, {kInf, -kInf}, {kInf, kNaN}}) {
      WholePair pair = float_pair({0.5f, a}, {0.5f, b});
      pair.nan_equals_nan = nan_equals_nan;
      INFO(a << " and " << b);
      for (const WholePair& order : {pair, pair.swapped()}) {
        CHECK(sample_errors(order).absmax == kInfinity);
        CHECK(sample_errors(order).rmse == kInfinity);
        CHECK(psnr(sample_errors(order)) == -kInfinity);
      }
    }
  }
}

TEST_CASE("NaN equals NaN only when asked, and infinity equals itself", "[metrics]") {
  WholePair pair = float_pair({kNaN, 1.0f, kInf, -kInf}, {-kNaN, 1.0f, kInf, -kInf});
  CHECK(sample_errors(pair).rmse == kInfinity);
  pair.nan_equals_nan = true;
  CHECK(sample_errors(pair).absmax == 0);
  CHECK(sample_errors(pair).rmse == 0);
}

TEST_CASE("the largest floats do not overflow the sum", "[metrics]") {
  constexpr float kLargest = std::numeric_limits<float>::max();
  const SampleErrors errors =
      sample_errors(float_pair({kLargest, kLargest}, {-kLargest, -kLargest}));
  CHECK(errors.rmse == 2 * double(kLargest));
}
