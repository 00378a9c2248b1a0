// glassbox study collect DIRECTORY: joins the result files of a study that was measured in parts.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/add_command.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "study/commands/commands.h"
#include "study/experiment/collect.h"
#include "study/experiment/result_file.h"
#include "study/experiment/theory.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

namespace glassbox::study {

class StudyCollectCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;

  std::string directory_, output_;
  bool any_machine_ = false;
};

namespace {

namespace fs = std::filesystem;

// Reads every .json file in the directory, in the order of the names.
Result<std::vector<study::PartFile>> read_parts(const std::string& directory) {
  std::error_code error;
  std::vector<std::string> paths;
  for (fs::directory_iterator at(directory, error), end; !error && at != end; at.increment(error)) {
    if (at->path().extension() == ".json") paths.push_back(at->path().string());
  }
  if (error) {
    return tl::unexpected(Error{directory, "", "cannot be read: " + error.message(),
                                "name the directory of the parts"});
  }
  if (paths.empty()) {
    return tl::unexpected(
        Error{directory, "", "has no .json file",
              "name the directory that has the files of study run --part K/N --json"});
  }
  std::ranges::sort(paths);
  std::vector<study::PartFile> parts;
  for (const std::string& path : paths) {
    Result<study::StudyResults> results = study::read_results(path);
    if (!results) return tl::unexpected(results.error());
    parts.push_back({path, std::move(*results)});
  }
  return parts;
}

}  // namespace

void StudyCollectCommand::add_to(CLI::App& study, int& exit_code) {
  CLI::App& command = *study.add_subcommand(
      "collect", "joins the parts of a run that were measured with study run --part");
  command.footer(
      "Examples:\n"
      "  glassbox study run --part 1/4 --json parts/1.json\n"
      "  glassbox study collect parts -o results.json\n"
      "  glassbox study report --from results.json -o report.html\n\n"
      "All parts must be there. They must be from one build, and measured on machines of one "
      "kind.");
  command.add_option("DIRECTORY", directory_, "the directory whose .json files are the parts")
      ->required();
  command.add_option("-o,--output", output_, "the joined results, as a file of one run")
      ->type_name("FILE")
      ->required();
  command.add_flag(
      "--any-machine", any_machine_,
      "also join parts from different machines: their errors are comparable, their times are not");
  command.callback([this, &exit_code] { exit_code = run(); });
}

int StudyCollectCommand::run() const {
  if (const auto legal = check_outputs({output_}); !legal) return refuse(legal.error());
  const auto parts = read_parts(directory_);
  if (!parts) return refuse(parts.error());
  const auto joined = study::join_parts(*parts, any_machine_);
  if (!joined) return refuse(joined.error());
  if (const auto written = study::write_results(output_, *joined); !written) {
    return refuse(written.error());
  }
  fmt::print("{}: {} of {}\n", printable(output_),
             counted(joined->experiments.size(), "experiment"), counted(parts->size(), "part"));
  const auto unexplained = [](const study::ExperimentResult& each) {
    return study::count_unexplained(each) > 0;
  };
  return std::ranges::any_of(joined->experiments, unexplained) ? kFailure : kSuccess;
}

void add_collect_command(CLI::App& study, int& exit_code) {
  add_command<StudyCollectCommand>(study, exit_code);
}

}  // namespace glassbox::study
