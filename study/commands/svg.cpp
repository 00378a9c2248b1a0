#include "study/commands/svg.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "cli/process/process.h"
#include "cli/report/output.h"
#include "cli/report/scratch.h"
#include "study/commands/gnuplot.h"
#include "study/experiment/measures.h"
#include "study/experiment/pareto.h"

namespace glassbox::study {

namespace {

namespace fs = std::filesystem;

constexpr const char* kRemedy = "apt install gnuplot-nox, or leave --svg out";

constexpr ProcessLimits kChartLimits{.seconds = 300};  // a chart takes a second

// Runs gnuplot and prints its messages on standard error, like this program's own.
ProcessOutcome run_gnuplot(const std::string& script) {
  ProcessOutcome outcome = run_process({"gnuplot", script}, kChartLimits);
  fmt::print(stderr, "{}", outcome.said);
  return outcome;
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The path of a chart without the ending: "D-2"; for the second and third measure of an experiment
// "D-2-2" and "D-2-3".
std::string stem_of(const std::string& directory, const std::string& id, std::size_t measure) {
  return directory + "/" + id + (measure == 0 ? "" : fmt::format("-{}", measure + 1));
}

// Draws into a temporary file first, so that a chart in the directory is complete or not there.
Result<void> draw(const fs::path& scratch,
                  std::string (*commands)(const study::ExperimentResult&, const std::string&),
                  const study::ExperimentResult& result, const std::string& target) {
  const fs::path script = scratch / "commands", drawn = scratch / "chart.svg";
  std::ofstream(script, std::ios::binary) << commands(result, drawn.string());
  const ProcessOutcome outcome = run_gnuplot(script.string());
  if (outcome.timed_out) {
    return tl::unexpected(
        Error{target, "", fmt::format("gnuplot was not done after {:g} s", kChartLimits.seconds),
              "give it a machine that is less busy, or leave --svg out"});
  }
  const std::string svg = text_of(drawn);
  if (!outcome.started || outcome.status != 0 || svg.empty()) {
    return tl::unexpected(
        Error{target, "", "gnuplot could not draw it (what it says stands above)", kRemedy});
  }
  return write_text(target, svg);
}

}  // namespace

Result<void> check_gnuplot() {
  if (run_gnuplot("/dev/null").started) return {};
  return fail("--svg", "gnuplot draws these charts, and it is not installed", kRemedy);
}

Result<int> write_svg_charts(const study::StudyResults& results, const std::string& directory) {
  const Scratch scratch;
  const auto place = scratch.path();
  if (!place) return tl::unexpected(place.error());
  int written = 0;
  for (const study::ExperimentResult& experiment : results.experiments) {
    const std::vector<study::ExperimentResult> measures = study::by_measure(experiment);
    for (std::size_t i = 0; i < measures.size(); ++i) {
      const std::string stem = stem_of(directory, experiment.id, i);
      if (!study::thread_counts(measures[i]).empty()) {
        const auto done = draw(*place, time_chart_commands, measures[i], stem + "-time.svg");
        if (!done) return tl::unexpected(done.error());
        ++written;
      }
      const auto done = draw(*place, axis_chart_commands, measures[i], stem + "-axis.svg");
      if (!done) return tl::unexpected(done.error());
      ++written;
    }
  }
  return written;
}

}  // namespace glassbox::study
