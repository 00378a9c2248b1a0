#include <glassbox/compare/metrics/metric.h>

#include "tests/support/catch.h"

namespace {

using namespace glassbox;

// Parses the requests and returns them as text, or returns the error.
std::string parsed(const std::string& text) {
  const auto requests = parse_metrics(text);
  if (!requests) return requests.error().message();
  std::string all;
  for (const MetricRequest& request : *requests) {
    all += (all.empty() ? "" : ",") + to_string(request);
  }
  return all;
}

}  // namespace

TEST_CASE("metrics are read back as they are written", "[metrics]") {
  for (const std::string text :
       {"absmax", "rmse", "psnr", "ssim.mean", "ssim.min", "flip.mean", "flip.median", "flip.p95",
        "flip.max", "absmax,psnr>40,flip.mean<0.05", "psnr>=40.5,ssim.min>-0.25,rmse<=1e-05",
        "rmse,rmse<0.1,rmse"}) {
    CHECK(parsed(text) == text);
  }
  CHECK(parsed(" psnr > 40 ,\tflip.mean<= .05") == "psnr>40,flip.mean<=0.05");
}

TEST_CASE("a family asks for all its numbers, and its limit is one on the mean", "[metrics]") {
  CHECK(parsed("ssim") == "ssim.mean,ssim.min");
  CHECK(parsed("flip") == "flip.mean,flip.median,flip.p95,flip.max");
  CHECK(parsed("ssim>0.9") == "ssim.mean>0.9,ssim.min");
  CHECK(parsed("flip<=0.1,rmse") == "flip.mean<=0.1,flip.median,flip.p95,flip.max,rmse");
}

TEST_CASE("an unknown metric is named together with the known ones", "[metrics]") {
  for (const std::string text :
       {"mse", "flip.min", "ssim.", ".mean", "PSNR", "rmse=1", "flip mean"}) {
    INFO(parsed(text));
    CHECK(parsed("rmse," + text).find("there is no metric '" + text + "'") != std::string::npos);
    CHECK(parsed(text).find("absmax, rmse, psnr, ssim.mean, ssim.min, flip.mean, flip.median, "
                            "flip.p95, flip.max, ssim or flip") != std::string::npos);
  }
  CHECK(parsed("mse<1").find("there is no metric 'mse'") != std::string::npos);
  for (const std::string text : {"", ",", "rmse,", "rmse,,psnr", " "}) {
    CHECK(parsed(text).find("the name of a metric is missing") != std::string::npos);
  }
  CHECK(parsed("<1").find("there is no metric ''") != std::string::npos);
}

TEST_CASE("a limit that is no finite number is refused", "[metrics]") {
  for (const std::string text :
       {"rmse<", "rmse<nan", "rmse<-nan(1)", "rmse<inf", "psnr>-inf", "rmse<x", "rmse<1x",
        "rmse<1 2", "rmse<<1", "rmse<=>1", "rmse<1e999", "rmse<0x1", "rmse<+1"}) {
    INFO(parsed(text));
    CHECK(parsed(text).find("'" + text + "' has no number as its limit") != std::string::npos);
  }
}

TEST_CASE("a limit in the direction that lets bad pictures pass is refused", "[metrics]") {
  for (const std::string text : {"psnr<40", "psnr<=40", "ssim.mean<0.9", "ssim<0.9", "ssim.min<=1",
                                 "flip.mean>0.05", "flip>=0.05", "absmax>=1", "rmse>0.1"}) {
    INFO(parsed(text));
    CHECK(parsed(text).find("'" + text + "' would accept bad pictures") != std::string::npos);
  }
  CHECK(parsed("psnr<40").find("write psnr>40") != std::string::npos);
  CHECK(parsed("flip>0.05").find("write flip<0.05") != std::string::npos);
}
