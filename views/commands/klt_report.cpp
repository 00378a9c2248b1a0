#include "views/commands/klt_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/exit_codes.h"

#include <glassbox/base/printable.h>
#include <glassbox/base/rounding.h>

namespace glassbox::views {

namespace {

using Json = nlohmann::ordered_json;

double correlation_with(const std::vector<double>& a, const std::vector<double>& b) {
  const auto mean_of = [](const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / double(values.size());
  };
  const double mean_a = mean_of(a), mean_b = mean_of(b);
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return aa > 0 && bb > 0 ? std::abs(ab) / std::sqrt(aa * bb) : 0;
}

double share(double part, double all) {
  return all > 0 ? part / all : 0;
}

// The number of eigenvalues in the group that begins with `first`: those that rounding could
// exchange with it.
int group_size(const KltReport& report, int first) {
  return int(std::ranges::count(report.groups, first));
}

}  // namespace

bool KltReport::holds() const {
  return std::abs(error - klt.dropped(kept)) <= bound;
}

Result<KltReport> report_klt(const KltInput& input, int kept) {
  auto klt = views::klt_of(input.bands);
  if (!klt) return tl::unexpected(klt.error());
  KltReport report;
  report.klt = std::move(*klt);
  report.kept = kept;
  report.components = views::components_of(input.bands, report.klt, kept);
  report.again = views::reconstructed(report.components, report.klt, input.bands);
  report.error = views::mean_squared_error(input.bands, report.again);
  report.bound = views::identity_bound(input.bands, report.klt, kept);
  report.correlation = views::largest_correlation(report.components);
  report.groups = views::groups_of(report.klt.eigenvalues,
                                   2 * views::eigenvalue_bound(input.bands, report.klt));
  if (!input.opacity.empty()) {
    report.truth = correlation_with(report.components.bands.front().samples, input.opacity);
    report.truth_of_band = 0;
    for (const views::Band& band : input.bands.bands)
      report.truth_of_band =
          std::max(*report.truth_of_band, correlation_with(band.samples, input.opacity));
  }
  return report;
}

std::string klt_text(const KltInput& input, const KltReport& report) {
  const views::Klt& klt = report.klt;
  const double trace = klt.trace();
  std::string text =
      fmt::format("{}: {} bands of {} x {}\n\n{:<10}{:>12}{:>9}{:>14}   {}\n",
                  printable(input.source, kLongestMessage), input.bands.count(), input.bands.width,
                  input.bands.height, "component", "eigenvalue", "share", "MSE without", "mostly");
  for (Eigen::Index i = 0; i < klt.eigenvalues.size(); ++i) {
    Eigen::Index most = 0;
    klt.vectors.col(i).cwiseAbs().maxCoeff(&most);
    text += fmt::format("{:<10}{:>12.6g}{:>7.2f} %{:>14.6g}   {}\n", i + 1, klt.eigenvalues[i],
                        100 * share(klt.eigenvalues[i], trace), klt.dropped(int(i) + 1),
                        printable(input.bands.bands[std::size_t(most)].name));
  }
  if (report.kept == input.bands.count()) {
    text += fmt::format("\nAll {} components are kept: the bands come back{}.\n", report.kept,
                        report.holds() ? ", but for rounding" : " OTHERWISE");
  } else {
    text += fmt::format(
        "\n{} of {} components keep {:.2f} % of the variance; the mean square error of a pixel is "
        "{:.6g},\n{} the sum of the eigenvalues that were dropped.\n",
        report.kept, input.bands.count(), 100 * (1 - share(klt.dropped(report.kept), trace)),
        report.error, report.holds() ? "which is" : "WHICH IS NOT");
  }
  for (int i = 0; i < int(report.groups.size()); ++i) {
    const int size = group_size(report, i);
    if (size < 2) continue;
    text += fmt::format(
        "Components {} to {} have one eigenvalue: only the space that they span is determined.\n",
        i + 1, i + size);
  }
  if (report.truth) {
    text += fmt::format(
        "Correlation with the clouds that were generated: component 1 {:.4f}, the best band "
        "{:.4f}.\n",
        *report.truth, *report.truth_of_band);
  }
  return text;
}

Json klt_json(const KltInput& input, const KltReport& report) {
  const views::Klt& klt = report.klt;
  Json json{{"source", input.source},
            {"width", input.bands.width},
            {"height", input.bands.height},
            {"bands", Json::array()},
            {"kept", report.kept},
            {"trace", klt.trace()},
            {"mse", report.error},
            {"dropped", klt.dropped(report.kept)},
            {"bound", report.bound},
            {"holds", report.holds()},
            {"largest_correlation", report.correlation},
            {"components", Json::array()}};
  for (int b = 0; b < input.bands.count(); ++b) {
    json["bands"].push_back({{"name", printable(input.bands.bands[std::size_t(b)].name)},
                             {"mean", klt.mean[b]},
                             {"variance", klt.covariance(b, b)}});
  }
  for (int i = 0; i < input.bands.count(); ++i) {
    Json vector = Json::array();
    for (int b = 0; b < input.bands.count(); ++b) vector.push_back(klt.vectors(b, i));
    json["components"].push_back({{"eigenvalue", klt.eigenvalues[i]},
                                  {"share", share(klt.eigenvalues[i], klt.trace())},
                                  {"mse_without", klt.dropped(i + 1)},
                                  {"group", report.groups[std::size_t(i)] + 1},
                                  {"vector", vector}});
  }
  if (report.truth) {
    json["clouds"] = {{"component", *report.truth}, {"best_band", *report.truth_of_band}};
  }
  return json;
}

}  // namespace glassbox::views
