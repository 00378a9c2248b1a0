// Measures what a pixel with several bands loses if components are dropped (D-30).
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "study/experiment/experiment.h"
#include "study/experiments/do_not_optimize.h"
#include "views/klt/clouds.h"
#include "views/klt/transform.h"

namespace glassbox::study {
namespace d30 {

// The data that all configurations share.
struct Planet {
  views::Bands bands;
  views::Klt klt;
};
std::shared_ptr<const Planet> planet_of(int width) {
  views::Bands bands = views::make_clouds(width).bands;
  views::Klt klt = *views::klt_of(bands);
  return std::make_shared<const Planet>(Planet{std::move(bands), std::move(klt)});
}

// The step between two byte values of a component: 255 steps cover six standard deviations, three
// on each side of the mean.
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

// The mean square rounding error of values that are uniformly distributed between two steps.
double rounding_of(const views::Klt& klt, int kept) {
  double sum = 0;
  for (int k = 0; k < kept; ++k) sum += step_of(klt, k) * step_of(klt, k) / 12;
  return sum;
}

views::Bands from_components(const Planet& planet, int kept) {
  return views::reconstructed(views::components_of(planet.bands, planet.klt, kept), planet.klt,
                              planet.bands);
}
views::Bands from_bytes(const Planet& planet, int kept) {
  return views::reconstructed(
      as_bytes(views::components_of(planet.bands, planet.klt, kept), planet.klt), planet.klt,
      planet.bands);
}

// The numbers of the bands, ordered by variance, the largest first. If the bands themselves are
// kept instead of components, the mean replaces the bands that are left out.
std::vector<int> bands_by_variance(const views::Klt& klt) {
  std::vector<int> order;
  for (int b = 0; b < int(klt.mean.size()); ++b) order.push_back(b);
  std::ranges::stable_sort(order, std::greater(), [&](int b) { return klt.covariance(b, b); });
  return order;
}
views::Bands some_bands(const Planet& planet, int kept) {
  views::Bands result = planet.bands;
  const std::vector<int> order = bands_by_variance(planet.klt);
  for (std::size_t i = std::size_t(kept); i < order.size(); ++i)
    std::ranges::fill(result.bands[std::size_t(order[i])].samples, planet.klt.mean[order[i]]);
  return result;
}
double variance_without(const views::Klt& klt, int kept) {
  const std::vector<int> order = bands_by_variance(klt);
  double sum = 0;
  for (std::size_t i = std::size_t(kept); i < order.size(); ++i)
    sum += klt.covariance(order[i], order[i]);
  return sum;
}

// Storing components as bytes adds the rounding error to the loss. The sum is right within a tenth
// as long as the steps are small compared with the stored values.
std::optional<Finding> finding_of_bytes(const views::Klt& klt, int kept) {
  const double added = rounding_of(klt, kept) / klt.truncation_error(kept);
  if (added < 0.5) return std::nullopt;
  return Finding{
      "components that are stored as bytes are rounded, and this error is larger than that of the "
      "dropped components",
      1 + 0.9 * added, 1 + 1.1 * added};
}

std::vector<Configuration> configurations(Effort effort) {
  const auto planet = planet_of(effort == Effort::kFull ? 256 : 128);
  const views::Klt& klt = planet->klt;
  std::vector<Configuration> all;
  // If all components are kept, only rounding errors are left, and the theory does not predict
  // rounding errors.
  for (int kept = 1; kept < planet->bands.count(); ++kept) {
    const auto add = [&](const char* series, auto again, double predicted,
                         std::optional<Finding> finding) {
      all.push_back(
          {.series = series,
           .parameter = double(kept),
           .error = [=] { return views::mean_squared_error(planet->bands, again(*planet, kept)); },
           .predicted_error = predicted,
           .finding = std::move(finding),
           .work = [=](int) { do_not_optimize(again(*planet, kept)); },
           .items = double(planet->bands.pixels())});
    };
    add("components", from_components, klt.truncation_error(kept), std::nullopt);
    add("components in bytes", from_bytes, klt.truncation_error(kept), finding_of_bytes(klt, kept));
    add("the bands with the largest variance", some_bands, variance_without(klt, kept),
        std::nullopt);
  }
  return all;
}

}  // namespace d30

Experiment d30_klt() {
  using namespace d30;
  return {.id = "D-30",
          .name = "Components of bands: how many",
          .question = "How exactly can five bands be restored from a few numbers per pixel?",
          .axis = "components that are kept",
          .logarithmic_axis = false,
          .error = "mean squared distance of a pixel from its original",
          .error_unit = "counts^2",
          .reference = "the bands of a generated planet, ten bits each",
          .theory =
              "The error is exactly the sum of the eigenvalues of the dropped components (S1-14 in "
              "docs/references.md); for bands as they are, it is the sum of the variances of the "
              "dropped bands",
          .item = "pixel",
          .axis_is_chosen = true,
          .configurations = configurations};
}

}  // namespace glassbox::study
