// What `glassbox views klt` finds, and says of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "views/klt/transform.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::app {

struct KltInput {
  std::string source;
  views::Bands bands;
  // Of the generated planet: what its ground looks like, and the clouds that there are.
  std::optional<Image<Rgba8>> ground;
  std::vector<double> opacity;
};

struct KltReport {
  views::Klt klt;
  int kept = 0;
  views::Bands components;  // those that were kept
  views::Bands again;       // the bands from them
  std::vector<int> groups;  // of eigenvalues that rounding could exchange
  double error = 0;         // mean square distance of the pixels from those that were reconstructed
  double bound = 0;         // by what it may differ from the eigenvalues that were dropped
  double correlation = 0;   // the largest of two components, as a share of the trace
  std::optional<double> truth,
      truth_of_band;  // |correlation| with the clouds: of component 1, and of the band that has most

  bool holds() const;
};

Result<KltReport> report_klt(const KltInput& input, int kept);

std::string klt_text(const KltInput& input, const KltReport& report);
nlohmann::ordered_json klt_json(const KltInput& input, const KltReport& report);

}  // namespace glassbox::app
