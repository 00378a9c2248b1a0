#include "study/commands/measuring.h"

#include <cstdio>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/engine_options.h"
#include "cli/report/progress.h"
#include "study/bench/machine.h"
#include "study/commands/report.h"
#include "study/experiment/result_file.h"
#include "study/experiment/study.h"

#include <glassbox/base/printable.h>

namespace glassbox::study {

namespace {

// How often each configuration is timed: more repetitions give steadier quartiles. The quick run
// uses the least number that the protocol allows.
constexpr int kFullRepetitions = 21;

Result<std::vector<const Experiment*>> choose_experiments(const std::vector<std::string>& ids) {
  const std::vector<Experiment>& all = study::experiments();
  for (const std::string& id : ids) {
    if (study::find_experiment(all, id) == nullptr) {
      return fail("", "there is no experiment " + printable(id, 100),
                  "glassbox study list shows the experiments");
    }
  }
  std::vector<const Experiment*> chosen;
  for (const Experiment& each : all) {
    bool asked = ids.empty();
    for (const std::string& id : ids) asked = asked || study::find_experiment(all, id) == &each;
    if (asked) chosen.push_back(&each);
  }
  return chosen;
}

// Parses "2/4". Throws CLI::ValidationError if that fails.
void parse_part(const std::string& text, MeasuringOptions& options) {
  int part = 0, parts = 0, end = 0;
  const bool read = std::sscanf(text.c_str(), "%d/%d%n", &part, &parts, &end) == 2 &&
                    std::size_t(end) == text.size();
  if (!read || part < 1 || part > parts || parts > study::kMaxParts) {
    throw CLI::ValidationError(
        "--part", fmt::format("needs K/N for part K of N parts, with 1 <= K <= N <= {}, not {}",
                              study::kMaxParts, in_quotes(text)));
  }
  options.part = part;
  options.parts = parts;
}

}  // namespace

void add_measuring_options(CLI::App& command, MeasuringOptions& options) {
  command.add_option("ID", options.ids, "the codes of experiments, such as D-4 [all]");
  command.add_flag("--quick", options.quick,
                   "make fewer and smaller measurements; all experiments take two minutes");
  command
      .add_option("--threads", options.threads,
                  "the largest number of threads, for experiments that use several [all]")
      ->check(CLI::Range(1, kMaxThreads))
      ->type_name("N");
  command
      .add_option("--resume", options.file,
                  "store the results in this file after each experiment; what it already contains "
                  "is not measured again")
      ->type_name("FILE");
  command
      .add_option_function<std::string>(
          "--part", [&options](const std::string& text) { parse_part(text, options); },
          "measure only every N-th experiment, beginning with the K-th; study collect joins the "
          "parts")
      ->type_name("K/N");
}

Result<study::StudyResults> measure_experiments(const MeasuringOptions& options) {
  auto chosen = choose_experiments(options.ids);
  if (!chosen) return tl::unexpected(chosen.error());
  std::vector<const Experiment*> of_part;
  for (auto i = std::size_t(options.part - 1); i < chosen->size();
       i += std::size_t(options.parts)) {
    of_part.push_back((*chosen)[i]);
  }
  const study::Effort effort = options.quick ? study::Effort::kQuick : study::Effort::kFull;
  const int threads = options.threads.value_or(study::processor_count());
  Progress progress;
  study::RunOptions run;
  run.effort = effort;
  run.repetitions = options.quick ? study::kMinRepetitions : kFullRepetitions;
  run.threads = threads;
  run.phase = [&](const std::string& what) { progress.phase(what); };
  study::Origin origin = study::current_origin(version_and_build(), effort, threads);
  origin.part = options.part;
  origin.parts = options.parts;
  return study::run_study(of_part, origin, run, options.file);
}

Result<study::StudyResults> select_results(const study::StudyResults& results,
                                           const std::vector<std::string>& ids) {
  const auto chosen = choose_experiments(ids);
  if (!chosen) return tl::unexpected(chosen.error());
  study::StudyResults some{results.origin, {}};
  for (const Experiment* experiment : *chosen) {
    const study::ExperimentResult* found = study::find_result(results, experiment->id);
    if (found == nullptr) {
      return fail("", "the results do not contain experiment " + experiment->id,
                  "measure it with study run and --resume, or leave it out");
    }
    some.experiments.push_back(*found);
  }
  return some;
}

}  // namespace glassbox::study
