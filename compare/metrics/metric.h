// Numbers for how different two pictures are: reported, and gating only where a limit is given.
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

// A list separated by commas: "absmax,psnr>40,flip.mean<0.05". "ssim" and "flip" ask for all numbers of the metric; a
// limit on them is a limit on their mean. An error names the word: an unknown name, a limit that is no finite number,
// or one in the direction that lets bad pictures pass ("psnr<40").
Result<std::vector<MetricRequest>> parse_metrics(const std::string& text);
std::string to_string(const MetricRequest& request);  // as written

struct MetricValue {
  std::string name;
  std::optional<double> value = {};  // none where the metric is not defined for these pictures
  std::string why_not = {};          // the reason then
  std::optional<Limit> limit = {};
  bool passes = true;  // its limit; a limit on a value that does not exist fails
};

// The values asked for. Pixels that the selection leaves out count nowhere; where a metric looks at neighbourhoods, the
// test has the reference's samples there.
std::vector<MetricValue> measure(const PicturePair& pair,
                                 const std::vector<MetricRequest>& requests);

}  // namespace glassbox
