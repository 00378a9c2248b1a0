// The results of `glassbox views klt`, and their reports.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "views/klt/transform.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::views {

struct KltInput {
  std::string source;
  views::Bands bands;
  // Only for the generated planet: a picture of its ground, and the true opacity of its clouds.
  std::optional<Image<Rgba8>> ground;
  std::vector<double> opacity;
};

struct KltReport {
  views::Klt klt;
  int kept = 0;
  views::Bands components;     // the kept components
  views::Bands reconstructed;  // the bands reconstructed from the kept components
  // For each eigenvalue, the index of the first one in its group: rounding could exchange the
  // eigenvalues of a group.
  std::vector<int> groups;
  double error = 0;        // mean square distance between the pixels and the reconstructed ones
  double bound = 0;        // upper bound of |error - sum of the dropped eigenvalues|
  double correlation = 0;  // largest covariance of two components / trace
  // The absolute value of the correlation with the clouds' opacity: of component 1, and the largest
  // one of a single band.
  std::optional<double> truth, best_band_truth;

  bool holds() const;
};

Result<KltReport> report_klt(const KltInput& input, int kept);

std::string klt_text(const KltInput& input, const KltReport& report);
nlohmann::ordered_json klt_json(const KltInput& input, const KltReport& report);

// The bands and their components as one HTML page that needs no other file. It reconstructs the
// bands from any number of components.
struct KltPageOrigin {
  std::string program;  // "glassbox 0.1.0"
  std::string command;  // the command line that made the page
};

// An error if there are too many samples for a browser.
Result<void> check_klt_page(std::uint64_t width, std::uint64_t height, std::uint64_t bands);

// `json` is the JSON of klt_json.
Result<std::string> make_klt_page(const KltInput& input, const KltReport& report,
                                  const nlohmann::ordered_json& json, const KltPageOrigin& origin);

}  // namespace glassbox::views
