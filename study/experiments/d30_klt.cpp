// D-30: what a pixel of several bands loses with the components that are dropped.
#include <algorithm>
#include <cmath>

#include "study/experiment/experiment.h"
#include "study/experiments/consume.h"
#include "views/klt/clouds.h"
#include "views/klt/transform.h"

namespace glassbox::study {
namespace {

// Three standard deviations on both sides in 255 steps.
double step_of(const views::Klt& klt, int component) {
  return 6 * std::sqrt(klt.eigenvalues[component]) / 255;
}

views::Bands as_bytes(views::Bands components, const views::Klt& klt) {
  for (int k = 0; k < components.count(); ++k) {
    const double step = step_of(klt, k);
    for (double& sample : components.bands[std::size_t(k)].samples)
      sample = step * (std::clamp(std::floor(sample / step + 128), 0.0, 255.0) - 127.5);
  }
  return components;
}

// Of values that are spread evenly between two steps.
double rounding_of(const views::Klt& klt, int kept) {
  double sum = 0;
  for (int k = 0; k < kept; ++k) sum += step_of(klt, k) * step_of(klt, k) / 12;
  return sum;
}

double error_of(const views::Bands& bands, const views::Klt& klt, int kept, bool in_bytes) {
  views::Bands components = views::components_of(bands, klt, kept);
  if (in_bytes) components = as_bytes(std::move(components), klt);
  return views::mean_squared_error(bands, views::reconstructed(components, klt, bands));
}

// As they are, those of most variance first; the mean stands for the others.
std::vector<int> bands_by_variance(const views::Klt& klt) {
  std::vector<int> order;
  for (int b = 0; b < int(klt.mean.size()); ++b) order.push_back(b);
  std::ranges::stable_sort(order, std::greater(), [&](int b) { return klt.covariance(b, b); });
  return order;
}
views::Bands some_bands(const views::Bands& bands, const views::Klt& klt, int kept) {
  views::Bands result = bands;
  const std::vector<int> order = bands_by_variance(klt);
  for (std::size_t i = std::size_t(kept); i < order.size(); ++i)
    std::ranges::fill(result.bands[std::size_t(order[i])].samples, klt.mean[order[i]]);
  return result;
}
double variance_without(const views::Klt& klt, int kept) {
  const std::vector<int> order = bands_by_variance(klt);
  double sum = 0;
  for (std::size_t i = std::size_t(kept); i < order.size(); ++i)
    sum += klt.covariance(order[i], order[i]);
  return sum;
}

// Bytes add what rounding to them adds, within a tenth where their steps are small beside what they store.
std::optional<Finding> finding_of_bytes(const views::Klt& klt, int kept) {
  const double added = rounding_of(klt, kept) / klt.dropped(kept);
  if (added < 0.5) return std::nullopt;
  return Finding{"components in bytes are rounded: that is more than what was dropped",
                 1 + 0.9 * added, 1 + 1.1 * added};
}

std::vector<Configuration> configurations(Effort effort) {
  const views::Bands bands = views::make_clouds(effort == Effort::kFull ? 256 : 128).bands;
  const views::Klt klt = *views::klt_of(bands);
  std::vector<Configuration> all;
  // With all of them nothing but rounding is left, of which the theory says nothing.
  for (int kept = 1; kept < bands.count(); ++kept) {
    const double pixels = double(bands.pixels());
    const auto add = [&](const char* series, auto error, double predicted,
                         std::optional<Finding> finding, auto work) {
      all.push_back({.series = series,
                     .parameter = double(kept),
                     .error = error,
                     .predicted_error = predicted,
                     .finding = std::move(finding),
                     .work = [=](int) { consume(work()); },
                     .items = pixels});
    };
    const auto transform = [=](bool in_bytes) {
      return [=] { return error_of(bands, klt, kept, in_bytes); };
    };
    const auto again = [=](bool in_bytes) {
      return [=] {
        views::Bands components = views::components_of(bands, klt, kept);
        if (in_bytes) components = as_bytes(std::move(components), klt);
        return views::reconstructed(components, klt, bands);
      };
    };
    add("components", transform(false), klt.dropped(kept), std::nullopt, again(false));
    add("components in bytes", transform(true), klt.dropped(kept), finding_of_bytes(klt, kept),
        again(true));
    add(
        "the bands of most variance",
        [=] { return views::mean_squared_error(bands, some_bands(bands, klt, kept)); },
        variance_without(klt, kept), std::nullopt, [=] { return some_bands(bands, klt, kept); });
  }
  return all;
}

}  // namespace

Experiment d30_klt() {
  return {.id = "D-30",
          .name = "How many components",
          .question = "How much of five bands do a few numbers a pixel keep?",
          .axis = "components that are kept",
          .logarithmic_axis = false,
          .error = "mean squared distance of a pixel from what it was",
          .error_unit = "counts^2",
          .reference = "the bands of a generated planet, ten bits each",
          .theory =
              "the sum of the eigenvalues that were dropped, exactly (S1-14); of bands as they "
              "are, the "
              "sum of the variances of those that were dropped",
          .item = "pixel",
          .axis_is_chosen = true,
          .configurations = configurations};
}

}  // namespace glassbox::study
