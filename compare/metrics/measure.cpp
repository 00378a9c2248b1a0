#include <glassbox/compare/metrics/errors.h>
#include <glassbox/compare/metrics/flip.h>
#include <glassbox/compare/metrics/metric.h>
#include <glassbox/compare/metrics/samples.h>
#include <glassbox/compare/metrics/ssim.h>

namespace glassbox {
namespace {

constexpr auto kNothingCompared = "there is no pixel to compare";

// The reason why SSIM cannot be computed for these pictures; empty if it can.
std::string why_no_ssim(const PicturePair& pair) {
  if (has_floats(pair.reference))
    return "SSIM needs samples with a largest value (white), which floats do not have";
  if (pair.reference.width < kSsimWindow || pair.reference.height < kSsimWindow) {
    return "SSIM looks at windows of 11 x 11 pixels; the picture is smaller";
  }
  return {};
}

std::string why_no_flip(const PicturePair& pair) {
  if (has_floats(pair.reference))
    return "FLIP needs samples with a largest value (white), which floats do not have";
  return pair.selection.compared_pixels() == 0 ? kNothingCompared : "";
}

bool holds(const Limit& limit, double value) {
  switch (limit.kind) {
    case LimitKind::kBelow:
      return value < limit.value;
    case LimitKind::kAtMost:
      return value <= limit.value;
    case LimitKind::kAbove:
      return value > limit.value;
    case LimitKind::kAtLeast:
      return value >= limit.value;
  }
  return false;
}

// The metric values of one pair: each family is computed once, when it is first needed.
class Measurement {
public:
  explicit Measurement(const PicturePair& pair) : pair_(pair) {}

  MetricValue value_of(const std::string& name) {
    if (name.starts_with("ssim.")) return of_ssim(name);
    if (name.starts_with("flip.")) return of_flip(name);
    return of_errors(name);
  }

private:
  MetricValue of_errors(const std::string& name) {
    if (!errors_) errors_ = sample_errors(pair_);
    if (errors_->samples == 0) return undefined(name, kNothingCompared);
    if (name == "absmax") return defined(name, errors_->absmax);
    if (name == "rmse") return defined(name, errors_->rmse);
    if (name != "psnr") return undefined(name, "there is no such metric");
    if (errors_->peak == 0 && errors_->rmse > 0) {
      return undefined(name, "the reference has no peak: no finite sample in it differs from 0");
    }
    return defined(name, psnr(*errors_));
  }

  MetricValue of_ssim(const std::string& name) {
    if (const std::string why = why_no_ssim(pair_); !why.empty()) return undefined(name, why);
    if (!ssim_) ssim_ = ssim(pair_);
    if (ssim_->windows == 0)
      return undefined(name, "no SSIM window has its centre among the compared pixels");
    if (name == "ssim.mean") return defined(name, ssim_->mean);
    if (name == "ssim.min") return defined(name, ssim_->min);
    return undefined(name, "there is no such metric");
  }

  MetricValue of_flip(const std::string& name) {
    if (const std::string why = why_no_flip(pair_); !why.empty()) return undefined(name, why);
    if (!flip_) flip_ = flip(pair_);
    if (name == "flip.mean") return defined(name, flip_->mean);
    if (name == "flip.median") return defined(name, flip_->median);
    if (name == "flip.p95") return defined(name, flip_->p95);
    if (name == "flip.max") return defined(name, flip_->max);
    return undefined(name, "there is no such metric");
  }

  static MetricValue defined(const std::string& name, double value) {
    return {.name = name, .value = value};
  }
  static MetricValue undefined(const std::string& name, std::string why) {
    return {.name = name, .why_not = std::move(why)};
  }

  const PicturePair& pair_;
  std::optional<SampleErrors> errors_;
  std::optional<SsimValues> ssim_;
  std::optional<FlipErrors> flip_;
};

}  // namespace

std::vector<MetricValue> measure_metrics(const PicturePair& pair,
                                         const std::vector<MetricRequest>& requests) {
  Measurement measurement(pair);
  std::vector<MetricValue> values;
  for (const MetricRequest& request : requests) {
    MetricValue value = measurement.value_of(request.name);
    value.limit = request.limit;
    if (value.limit) value.passes = value.value && holds(*value.limit, *value.value);
    values.push_back(std::move(value));
  }
  return values;
}

}  // namespace glassbox
