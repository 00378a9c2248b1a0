#include "app/lab/grade_command.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <thread>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/lab/grade_files.h"
#include "app/options/arguments.h"
#include "app/options/choices.h"
#include "app/report/exit_codes.h"
#include "app/report/output.h"
#include "app/report/scratch.h"
#include "labs/grading/class.h"
#include "labs/grading/grade.h"
#include "labs/grading/overview.h"
#include "labs/grading/results.h"
#include "labs/grading/submission.h"

#include <glassbox/base/printable.h>

namespace glassbox::app {

namespace {

namespace fs = std::filesystem;
using namespace labs::grading;

}  // namespace

void LabGradeCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command = *lab.add_subcommand("grade", "points for a class, or for one submission");
  command.footer(
      "Examples:\n"
      "  glassbox lab grade submissions/ --lab 5 -o results/\n"
      "  glassbox lab grade submissions/ann --lab 5 --one -o results/ann/results.json\n\n"
      "A class is a folder of folders, one a submission, with student.cpp in each. Every "
      "submission and every\n"
      "check of it runs in a sandbox and in a process of its own. docs/grading.md has the rest: "
      "the limits,\n"
      "the files that are written, Gradescope, GitHub Classroom, Slurm and GNU parallel.");
  command
      .add_option("SUBMISSIONS", submissions_, "the folder of a class; with --one, of a submission")
      ->required();
  command
      .add_option("-o,--output", output_,
                  "the folder of the results; with --one, the file results.json")
      ->type_name("DIR|FILE")
      ->required();
  command.add_option(
      "--lab", lab_,
      "the number of the lab; not needed where a submission is a folder of `lab start`");
  command.add_flag("--one", one_,
                   "SUBMISSIONS is one submission: nothing is shared with other gradings");
  command.add_option("--classroom", classroom_, "with --one: GitHub Classroom's JSON too")
      ->type_name("FILE");
  command.add_option("--jobs", jobs_, "submissions at a time; as many as there are processors")
      ->check(CLI::Range(1, 1024));
  command.add_option("--time-limit", seconds_, "seconds for each check; 10")
      ->check(CLI::Range(0.1, 3600.0));
  command.add_option("--memory-limit", memory_mib_, "MiB for each check; 512")
      ->check(CLI::Range(std::size_t(64), std::size_t(1) << 20));
  add_choice(command, "--sandbox", confinement_,
             choices_of({Confinement::kBubblewrap, Confinement::kLandlock, Confinement::kLimits}),
             "this one or none; the strongest that works here");
  command
      .add_option("--kit", kit_,
                  "with --one: a directory for what all submissions of a lab are compiled with")
      ->type_name("DIR");
  command.callback([this, &exit_code] { exit_code = run(); });

  CLI::App& collect = *lab.add_subcommand(
      "collect", "class.csv and index.html of results that were made one by one");
  collect.footer("Example:\n  glassbox lab collect results/");
  collect
      .add_option("RESULTS", collected_,
                  "a folder with one folder a submission, results.json in each")
      ->required();
  collect.callback([this, &exit_code] { exit_code = run_collect(collected_); });
}

Result<const labs::Lab*> LabGradeCommand::find_lab(const labs::Sources& sources) const {
  for (const labs::Lab& lab : labs_()) {
    if (lab_ == lab.number) return &lab;
  }
  std::string there;
  for (const labs::Lab& lab : labs_())
    there += fmt::format("{}{}", there.empty() ? "" : ", ", lab.number);
  if (lab_) return fail("--lab", fmt::format("there is no lab {}", *lab_), "the labs are " + there);
  std::vector<std::string> names{""};
  if (!one_) {
    const auto listed = list_submissions(submissions_);
    if (!listed) return tl::unexpected(listed.error());
    names = *listed;
  }
  for (const std::string& name : names) {
    if (const labs::Lab* lab = lab_of_folder(labs_(), sources, fs::path(submissions_) / name))
      return lab;
  }
  return fail("--lab", "which lab this is cannot be seen from student.h in the submissions",
              "give the lab's number: " + there);
}

int LabGradeCommand::run() {
  const auto sources = find_sources_();
  if (!sources) return refuse(sources.error());
  const auto lab = find_lab(*sources);
  if (!lab) return refuse(lab.error());
  return one_ ? run_one(**lab, *sources) : run_class(**lab, *sources);
}

int LabGradeCommand::run_one(const labs::Lab& lab, const labs::Sources& sources) {
  // First of all, so that there are results whatever happens from here on.
  if (const auto written = write_results(output_, classroom_, unfinished_json()); !written)
    return refuse(written.error());
  if (!fs::is_directory(submissions_))
    return refuse({submissions_, "", "is no folder", "name the folder that holds student.cpp"});
  const auto unfinished = gradescope_json(nothing_yet(lab, kUnfinished), "");
  if (const auto written = write_results(output_, classroom_, unfinished); !written)
    return refuse(written.error());
  const Scratch scratch;
  const auto place = scratch.path();
  if (!place) return refuse(place.error());
  const auto sandbox = Sandbox::choose(*place, confinement_);
  if (!sandbox) return refuse(sandbox.error());
  fmt::print(stderr, "sandbox: {}\n", sandbox->in_force());
  auto kit = make_kit(sources, lab.folder, kit_.empty() ? *place / "kit" : fs::absolute(kit_));
  if (kit && !kit_.empty()) kit = copy_kit(*kit, *place / "kit");
  if (!kit) return refuse(kit.error());
  const auto build = scratch.own("build");
  if (!build) return refuse(build.error());
  Limits limits;
  limits.seconds = seconds_;
  limits.memory_bytes = memory_mib_ * kMiB;
  const Graded graded = grade(lab, submissions_, *sandbox, *kit, *build, limits);
  const auto results = gradescope_json(graded, sandbox->in_force());
  if (const auto written = write_results(output_, classroom_, results); !written)
    return refuse(written.error());
  fmt::print("{}", results.at("output").get<std::string>());
  return graded.outcome == kUnfinished ? kFailure : kSuccess;
}

std::vector<std::string> LabGradeCommand::command_for_one(const labs::Lab& lab,
                                                          const Sandbox& sandbox,
                                                          const std::string& name) const {
  const fs::path results = fs::path(output_) / name;
  return {"/proc/self/exe",
          "lab",
          "grade",
          "--one",
          "--lab",
          std::to_string(lab.number),
          "--output=" + (results / "results.json").string(),
          "--classroom=" + (results / "classroom.json").string(),
          "--time-limit",
          fmt::format("{}", seconds_),
          "--memory-limit",
          std::to_string(memory_mib_),
          "--sandbox",
          std::string(name_of(sandbox.confinement())),
          "--kit=" + kit_,
          "--",
          (fs::path(submissions_) / name).string()};
}

int LabGradeCommand::run_class(const labs::Lab& lab, const labs::Sources& sources) {
  const auto names = list_submissions(submissions_);
  if (!names) return refuse(names.error());
  for (const std::string& name : *names) {
    const fs::path results = fs::path(output_) / name;
    std::error_code error;
    fs::create_directories(results, error);
    if (error) return refuse({results.string(), "", error.message(), "choose another -o"});
    const auto written = write_results((results / "results.json").string(),
                                       (results / "classroom.json").string(), unfinished_json());
    if (!written) return refuse(written.error());
  }
  const Scratch scratch;
  const auto place = scratch.path();
  if (!place) return refuse(place.error());
  const auto sandbox = Sandbox::choose(*place, confinement_);
  if (!sandbox) return refuse(sandbox.error());
  fmt::print(stderr, "sandbox: {}\n", sandbox->in_force());
  kit_ = (*place / "kit").string();
  if (const auto kit = make_kit(sources, lab.folder, kit_); !kit) return refuse(kit.error());
  // What each makes on the way lies in here, and goes with it.
  ::setenv("TMPDIR", place->c_str(), 1);

  ClassRequest request;
  request.names = *names;
  request.jobs =
      jobs_ > 0 ? jobs_ : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  request.command = [&](const std::string& name) { return command_for_one(lab, *sandbox, name); };
  std::size_t done = 0, unfinished = 0;
  request.ended = [&](const std::string& name, bool fine, const std::string& said) {
    fmt::print(stderr, "{} of {}: {}{}\n", ++done, names->size(), printable(name),
               fine ? "" : ": grading did not finish");
    if (fine) return;
    ++unfinished;
    fmt::print(stderr, "{}\n", printable(said, 2000));
  };
  grade_class(request);
  const int collected = run_collect(output_);
  if (collected != kSuccess) return collected;
  return unfinished > 0 ? kFailure : kSuccess;
}

int LabGradeCommand::run_collect(const fs::path& results) const {
  const auto rows = read_results(results);
  if (!rows) return refuse(rows.error());
  for (const auto& [file, text] :
       {std::pair{"class.csv", class_csv(*rows)}, {"index.html", class_html(*rows)}}) {
    if (const auto written = write_text((results / file).string(), text); !written)
      return refuse(written.error());
  }
  std::size_t width = 10;
  for (const Row& row : *rows) width = std::max(width, std::min<std::size_t>(40, row.name.size()));
  for (const Row& row : *rows) {
    const auto& extra = row.results.at("extra_data");
    fmt::print("{:<{}}  {:>7.6g} / {:<7.6g}  {}\n", printable(row.name, 40), width,
               row.results.at("score").get<double>(), extra.value("max_score", 0.0),
               extra.at("outcome").get<std::string>());
  }
  fmt::print("{} and {} have the details\n", (results / "class.csv").string(),
             (results / "index.html").string());
  return kSuccess;
}

}  // namespace glassbox::app
