// glassbox diff REFERENCE TEST: whether two pictures, or two directories of them, are the same.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/cli_fwd.h"

#include <glassbox/base/error.h>
#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/compare/pictures/pairing.h>
#include <glassbox/compare/report/heat.h>

namespace glassbox::app {

class DiffCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();
  Result<Pairing> pair_up() const;
  Result<void> check_output_paths(const Pairing& pairing) const;
  std::vector<Comparison> compare(const Pairing& pairing) const;
  Result<void> write_reports(const std::vector<Comparison>& comparisons) const;
  Result<void> write_heat_maps(const std::vector<Comparison>& comparisons) const;
  void print(const std::vector<Comparison>& comparisons, const Pairing& pairing) const;
  int approve_all(const std::vector<Comparison>& comparisons) const;
  std::string command_line() const;
  bool silent() const;  // a report goes to standard output, so nothing else may

  std::string reference_, test_;
  bool directories_ = false;
  CompareOptions options_;
  std::optional<std::string> heat_, page_, json_, junit_;
  HeatOf heat_of_ = HeatOf::kSteps;
  bool approve_ = false;
  bool suggest_ = false;
  std::vector<const CLI::Option*> comparing_;  // the options that can change the verdict
};

}  // namespace glassbox::app
