// The results of the extreme cases and sweeps, and their reports.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "study/extremes/run_case.h"
#include "study/extremes/sweep.h"

namespace glassbox::study {

struct SweepResult {
  const study::Sweep& sweep;
  std::vector<study::SweepSeries> series;

  bool holds() const;  // whether every bound holds
};

struct ExtremesReport {
  std::vector<study::CaseResult> cases;
  std::vector<SweepResult> sweeps;

  bool holds() const;
};

// The report as text: a line for each case, the number of cases that hold, and a table for each
// sweep.
std::string extremes_text(const ExtremesReport& report);
// The full text about one case.
std::string case_text(const study::CaseResult& result);

nlohmann::ordered_json extremes_json(const ExtremesReport& report);

// A page that needs no other file, with the table, the curves and the pictures. `command` is the
// command line that makes the page.
std::string extremes_page(const ExtremesReport& report, const std::string& command);

const char* oracle_name(study::Oracle oracle);

}  // namespace glassbox::study
