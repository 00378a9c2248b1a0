// glassbox bench: how fast glassbox draws compared with another renderer, and how its time grows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/cli_fwd.h"
#include "cli/report/progress.h"
#include "study/commands/bench/bench_scene.h"
#include "study/commands/bench/report.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

class BenchCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  enum class Peer { kMesa, kOpencv };

  void add_measure_options(CLI::App& command);
  void add_engine_options(CLI::App& command);
  int run();
  Result<void> check_options() const;
  study::MeasureOptions measure_options(int threads) const;
  Result<void> measure_scene(const std::string& name, BenchReport& report,
                             Progress& progress) const;
  Result<void> measure_scenes(BenchReport& report, Progress& progress) const;
  void measure_scaling(BenchReport& report, Progress& progress) const;
  int run_matching();
  Result<void> write_outputs(const BenchReport& report) const;

  std::vector<std::string> scenes_;
  std::optional<Peer> against_;
  study::EngineOptions engine_;
  std::vector<int> threads_;
  int frames_ = 9;
  BenchDrawing drawing_;
  const CLI::Option* size_option_ = nullptr;
  std::optional<study::ScaledBy> scaling_;
  double most_ = 0;
  bool floor_ = false;
  std::optional<std::string> json_output_, html_output_;
};

// A second process that draws with the other renderer (the peer). It is started by `glassbox bench`
// only, not by users.
class BenchPeerCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  std::string scene_;
  BenchDrawing drawing_;
};

}  // namespace glassbox::study
