// Numbers that say how different two pictures are. They are reported; only a number with a limit
// changes whether the pictures pass.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

enum class LimitKind : std::uint8_t { kBelow, kAtMost, kAbove, kAtLeast };

struct Limit {
  LimitKind kind = LimitKind::kBelow;
  double value = 0;
};

// One number of a metric: "absmax", "rmse", "psnr", "ssim.mean", "flip.max" ...
struct MetricRequest {
  std::string name;
  std::optional<Limit> limit;
};

// Parses a list separated by commas: "absmax,psnr>40,flip.mean<0.05". "ssim" and "flip" request all
// numbers of the metric; a limit on them is a limit on their mean. An error names the word: an
// unknown name, a limit that is not a finite number, or a limit in the direction that lets bad
// pictures pass ("psnr<40").
Result<std::vector<MetricRequest>> parse_metrics(const std::string& text);
std::string to_string(const MetricRequest& request);  // as the user wrote it

struct MetricValue {
  std::string name;
  std::optional<double> value = {};  // none if the metric is not defined for these pictures
  std::string why_not = {};          // the reason if there is no value
  std::optional<Limit> limit = {};
  bool passes = true;  // whether the value is within its limit; a limit on a missing value fails
};

// The requested values. Pixels that the selection leaves out are not counted; where a metric uses
// neighbourhoods, the test picture has the reference's samples at these pixels.
std::vector<MetricValue> measure_metrics(const PicturePair& pair,
                                         const std::vector<MetricRequest>& requests);

}  // namespace glassbox
