#include <cmath>
#include <limits>

#include <glassbox/compare/metrics/metric.h>

#include "tests/metrics/pictures.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using test::WholePair;

std::vector<MetricValue> measured(const WholePair& pair, const std::string& text) {
  const auto requests = parse_metrics(text);
  REQUIRE(requests);
  return measure_metrics(pair, *requests);
}

constexpr auto kAll = "absmax,rmse,psnr,ssim,flip";

WholePair shifted(int size, int step) {
  const auto image = [=](int add) {
    return test::picture<std::uint8_t>(
        size, size, 3, [=](int x, int y, int c) { return test::noise(x, y, c, 1) / 2 + add; });
  };
  return {image(0), image(step)};
}

}  // namespace

TEST_CASE("values come in the order asked for, each with its limit", "[metrics]") {
  const auto values = measured(shifted(20, 1), "flip.max<1,rmse,psnr>10,rmse<=0");
  REQUIRE(values.size() == 4);
  CHECK(values[0].name == "flip.max");
  CHECK(values[1].name == "rmse");
  CHECK(values[2].name == "psnr");
  CHECK(values[3].name == "rmse");
  CHECK(values[0].limit);
  CHECK_FALSE(values[1].limit);
  CHECK(values[0].passes);
  CHECK(values[1].passes);
  CHECK(values[2].passes);
  CHECK_FALSE(values[3].passes);
  CHECK(values[1].value == values[3].value);
}

TEST_CASE("the limit itself passes with = only", "[metrics]") {
  const WholePair pair = shifted(20, 51);  // the largest absolute error is exactly 51/255 = 0.2
  CHECK_FALSE(measured(pair, "absmax<0.2")[0].passes);
  CHECK(measured(pair, "absmax<=0.2")[0].passes);
  const WholePair same = shifted(20, 0);
  CHECK_FALSE(measured(same, "ssim.mean>1")[0].passes);
  CHECK(measured(same, "ssim.mean>=1")[0].passes);
}

TEST_CASE("a looser limit passes wherever a tighter one does", "[metrics]") {
  const WholePair pair = shifted(30, 5);
  for (const std::string name : {"absmax", "rmse", "flip.mean", "flip.p95", "flip.max"}) {
    bool passed = false;
    for (int i = 0; i <= 100; ++i) {
      const bool passes = measured(pair, name + "<" + std::to_string(i * 0.01))[0].passes;
      CHECK(passes >= passed);
      passed = passes;
    }
    CHECK(passed);
  }
  for (const std::string name : {"psnr", "ssim.mean", "ssim.min"}) {
    bool passed = false;
    for (int i = 100; i >= -10; --i) {
      const double limit = name == "psnr" ? i : i * 0.01;
      const bool passes = measured(pair, name + ">" + std::to_string(limit))[0].passes;
      CHECK(passes >= passed);
      passed = passes;
    }
    CHECK(passed);
  }
}

TEST_CASE("the same pictures pass every limit that can be passed", "[metrics]") {
  for (const MetricValue& value :
       measured(shifted(20, 0),
                "absmax<=0,rmse<=0,psnr>1e300,ssim.mean>=1,ssim.min>=1,flip.mean<=0,"
                "flip.median<=0,flip.p95<=0,flip.max<=0")) {
    INFO(value.name);
    CHECK(value.passes);
  }
}

TEST_CASE("floats have errors but neither SSIM nor FLIP, and a limit on what is not there fails",
          "[metrics]") {
  const StoredImage image = test::floats(12, 12, 1, std::vector<float>(144, 3.0f));
  for (const MetricValue& value : measured({image, image}, kAll)) {
    INFO(value.name);
    const bool perceptual = value.name.starts_with("ssim") || value.name.starts_with("flip");
    CHECK(value.value.has_value() == !perceptual);
    CHECK(value.why_not.empty() == !perceptual);
    CHECK(value.passes);
  }
  CHECK_FALSE(measured({image, image}, "ssim.mean>=0")[0].passes);
  CHECK_FALSE(measured({image, image}, "flip.mean<=1")[0].passes);
}

TEST_CASE("small pictures have every metric but SSIM", "[metrics]") {
  for (const int size : {1, 2, 10, 11}) {
    for (const MetricValue& value : measured(shifted(size, 1), kAll)) {
      INFO(size << ": " << value.name);
      CHECK(value.value.has_value() == (size >= 11 || !value.name.starts_with("ssim")));
      CHECK(value.why_not.empty() == value.value.has_value());
    }
  }
}

TEST_CASE("where no pixel is compared there is no number", "[metrics]") {
  WholePair pair = shifted(20, 1);
  REQUIRE(pair.selection.exclude({0, 0, 20, 20}));
  for (const MetricValue& value : measured(pair, kAll)) {
    INFO(value.name);
    CHECK_FALSE(value.value);
    CHECK_FALSE(value.why_not.empty());
  }
  CHECK_FALSE(measured(pair, "rmse<1")[0].passes);
}

TEST_CASE("a black float reference has no signal-to-noise ratio unless nothing differs",
          "[metrics]") {
  const StoredImage black = test::floats(2, 1, 1, {0.0f, 0.0f});
  const StoredImage other = test::floats(2, 1, 1, {0.0f, 1.0f});
  CHECK_FALSE(measured({black, other}, "psnr")[0].value);
  CHECK(measured({black, black}, "psnr")[0].value == std::numeric_limits<double>::infinity());
}

TEST_CASE("narrow pictures of the largest width and height are measured", "[metrics]") {
  for (const auto& [width, height] : {std::pair{16384, 12}, {12, 16384}}) {
    const WholePair pair{test::noise_picture(width, height, 1, 1),
                         test::noise_picture(width, height, 1, 2)};
    for (const MetricValue& value : measured(pair, kAll)) {
      INFO(value.name);
      REQUIRE(value.value);
      CHECK(std::isfinite(*value.value));
    }
  }
}
