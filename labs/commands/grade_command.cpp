#include "labs/commands/grade_command.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <thread>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/arguments.h"
#include "cli/options/choices.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/scratch_directory.h"
#include "labs/commands/find_lab.h"
#include "labs/commands/grade_files.h"
#include "labs/framework/digest.h"
#include "labs/framework/lab_points.h"
#include "labs/framework/varied_inputs.h"
#include "labs/grading/autograder.h"
#include "labs/grading/class_overview.h"
#include "labs/grading/grade.h"
#include "labs/grading/grade_class.h"
#include "labs/grading/outside_lab.h"
#include "labs/grading/program_digest.h"
#include "labs/grading/results.h"
#include "labs/grading/roster.h"
#include "labs/grading/submission.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;
using namespace labs::grading;

// What a student reads about other files with the submission's name in the folder of the class.
std::string note_of_others(const std::vector<std::string>& also) {
  constexpr std::size_t kLongestName = 120;
  std::string note;
  for (const std::string& other : also)
    note +=
        fmt::format("{}{}", note.empty() ? "There is also " : ", ", printable(other, kLongestName));
  if (note.empty()) return {};
  return note +
         ", which is not graded: a folder is taken before an archive, and an archive before a .cpp "
         "file.\n";
}

}  // namespace

void LabGradeCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command =
      *lab.add_subcommand("grade", "grades the submissions of a class, or one submission");
  command.footer(
      "Examples:\n"
      "  glassbox lab grade submissions/ --lab 5 -o results/\n"
      "  glassbox lab grade submissions/ --lab 5 --roster students.csv -o results/\n"
      "  glassbox lab grade submissions/ann --lab 5 --one -o results/ann/results.json\n"
      "  glassbox lab grade submissions/ --lab-dir ~/labs/40-fog -o results/\n\n"
      "The folder of a class has one folder for each submission, with student.cpp in it. Every "
      "submission is\n"
      "compiled, and every check is run, in a sandbox and in a process of its own. docs/grading.md "
      "explains\n"
      "the limits, the files that are written, Gradescope, GitHub Classroom, Slurm and GNU "
      "parallel.");
  command
      .add_option("SUBMISSIONS", submissions_, "the folder of a class; with --one, one submission")
      ->required();
  command
      .add_option("-o,--output", files_.output,
                  "the folder of the results; with --one, the file results.json")
      ->type_name("DIR|FILE")
      ->required();
  command.add_option(
      "--lab", lab_,
      "the number of the lab; not needed if a submission is a folder made by `lab start`");
  add_lab_dir(command, lab_dir_)->excludes("--lab");
  command.add_flag("--one", one_,
                   "SUBMISSIONS is one submission; several such commands may run at the same time");
  const auto add_roster = [this](CLI::App& to) {
    return to
        .add_option("--roster", roster_,
                    "a CSV file with a line for each student, which begins with the name of the "
                    "submission: class.csv and index.html then have one row for each student")
        ->type_name("FILE");
  };
  add_roster(command)->excludes("--one");
  auto* vary = command.add_flag(
      "--vary", vary_,
      "give each submission its own inputs for the hidden checks, computed from its name");
  auto* named = command.add_option(
      "--name", name_,
      "with --one and --vary: the submission's name; by default that of its folder or file");
  named->needs(vary);
  command
      .add_option("--metadata", metadata_,
                  "with --one and --vary: Gradescope's submission_metadata.json; the submission's "
                  "name is made of the submitters in it")
      ->type_name("FILE")
      ->needs(vary)
      ->excludes(named);
  command.add_flag("--visible", visible_,
                   "run the visible checks only; the results then have no hidden check, and their "
                   "points are those of the visible ones");
  command.add_flag(
      "--resume", resume_,
      "skip a submission that has a result, unless it, the lab or glassbox has changed since");
  command
      .add_option("--classroom", files_.classroom,
                  "with --one: also write the result as JSON for GitHub Classroom")
      ->type_name("FILE");
  command
      .add_option("--junit", files_.junit, "with --one: also write the visible checks as JUnit XML")
      ->type_name("FILE");
  command
      .add_option("--vpl", files_.vpl,
                  "with --one: also write the visible checks for Moodle's Virtual Programming Lab")
      ->type_name("FILE");
  command
      .add_option(
          "--jobs", jobs_,
          "number of submissions graded at the same time; by default one for each processor")
      ->check(CLI::Range(1, 1024));
  command
      .add_option("--time-limit", seconds_, "time limit of each check, in seconds; by default 10")
      ->check(number_between(0.1, 3600));
  command
      .add_option("--total-time", total_seconds_,
                  "time limit of all checks of a submission together, in seconds; by default 300")
      ->check(number_between(1, 86400));
  command
      .add_option("--memory-limit", memory_mib_,
                  "memory limit of each check, in MiB; by default 512")
      ->check(CLI::Range(std::size_t(64), std::size_t(1) << 20));
  add_choice(command, "--sandbox", confinement_,
             choices_of({Confinement::kBubblewrap, Confinement::kLandlock, Confinement::kLimits}),
             "use this sandbox, or refuse to run if it does not work; by default the strongest one "
             "that works on this machine");
  command
      .add_option(
          "--kit", kit_,
          "with --one: keep in this directory the compiled files that all submissions of a lab "
          "share")
      ->type_name("DIR");
  // run_class() gives it to the processes that it starts; --help does not show it.
  command.add_option("--also", also_, "another file of the same student, which is not graded")
      ->group("");
  command.callback([this, &exit_code] { exit_code = run(); });

  CLI::App& collect = *lab.add_subcommand(
      "collect", "makes class.csv and index.html from results that were made with --one");
  collect.footer(
      "Examples:\n"
      "  glassbox lab collect results/\n"
      "  glassbox lab collect results/ --roster students.csv");
  collect
      .add_option("RESULTS", collected_,
                  "a folder with one folder for each submission, with results.json in it")
      ->required();
  add_roster(collect);
  collect.callback([this, &exit_code] { exit_code = run_collect(collected_, {}); });
}

Result<const labs::Lab*> LabGradeCommand::find_lab(const labs::Sources& sources,
                                                   const ScratchDirectory& scratch) const {
  if (!sources.outside.empty()) {
    // The judge of an outside lab (its checks, compiled) is kept next to the kit, so that runs that
    // share the kit share the judge too.
    const auto place =
        kit_.empty() ? scratch.make_private_directory("judge") : fs::path(kit_ + ".judge");
    return place ? load_outside_lab(sources, *place) : tl::unexpected(place.error());
  }
  for (const labs::Lab& lab : labs_()) {
    if (lab_ == lab.number) return &lab;
  }
  std::string there;
  for (const labs::Lab& lab : labs_())
    there += fmt::format("{}{}", there.empty() ? "" : ", ", lab.number);
  if (lab_) return fail("--lab", fmt::format("there is no lab {}", *lab_), "the labs are " + there);
  std::vector<Submission> submissions{{"", submissions_, {}}};
  if (!one_) {
    auto listed = list_submissions(submissions_);
    if (!listed) return tl::unexpected(listed.error());
    submissions = std::move(listed->submissions);
    if (submissions.empty() && roster_.empty()) return no_submission_error(submissions_);
  }
  for (const Submission& each : submissions) {
    if (const labs::Lab* lab = lab_of_folder(labs_(), sources, each.path)) return lab;
  }
  return fail("--lab",
              "it is not known which lab this is: no submission has the student.h of a lab",
              "give --lab and the lab's number: " + there);
}

int LabGradeCommand::run() {
  const auto sources = with_lab_dir(find_sources_(), lab_dir_);
  if (!sources) return refuse(sources.error());
  const ScratchDirectory scratch;
  if (!one_) {
    const auto place = scratch.path();
    if (!place) return refuse(place.error());
    kit_ = (*place / "kit").string();
  }
  const auto lab = find_lab(*sources, scratch);
  if (!lab) return refuse(lab.error());
  return one_ ? run_one(**lab, *sources, scratch) : run_class(**lab, *sources, scratch);
}

std::uint64_t LabGradeCommand::seed_of(const labs::Lab& lab, const std::string& name) {
  return std::max<std::uint64_t>(1, labs::Digest().add(lab.folder).add(name).number());
}

Result<std::string> LabGradeCommand::digest_of(const labs::Lab& lab, const labs::Sources& sources,
                                               const Submission& submission,
                                               const Result<SubmittedFile>& submitted) const {
  const auto kit = build_kit_fingerprint(sources, lab.folder);
  if (!kit) return kit;
  labs::Digest digest;
  digest.add(program_digest()).add(lab.folder).add(*kit);
  digest.add(submitted ? submitted->text : submitted.error().message());
  digest.add(submitted ? submitted->note : "");
  for (const std::string& other : submission.also) digest.add(other);
  if (const auto points = labs::read_text_file(sources.folder_of(lab.folder) / "points.json"))
    digest.add(*points);
  if (!sources.outside.empty()) {
    const auto judge = judge_digest(sources);
    if (!judge) return judge;
    digest.add(*judge);
  }
  digest.add(fmt::format("{} s, {} s together, {} MiB", seconds_, total_seconds_, memory_mib_));
  if (vary_) digest.add(std::to_string(seed_of(lab, submission.name)));
  if (visible_) digest.add("visible checks only");
  return digest.text();
}

int LabGradeCommand::run_one(const labs::Lab& lab, const labs::Sources& sources,
                             const ScratchDirectory& scratch) {
  if (const auto legal = check_result_files(files_); !legal) return refuse(legal.error());
  // The files are written first, so that a result exists even if a later step fails.
  if (const auto begun = begin_results(files_, unfinished_json()); !begun)
    return refuse(begun.error());
  if (!fs::exists(fs::symlink_status(submissions_)))
    return refuse({submissions_, "", "does not exist", "name the folder that holds student.cpp"});
  if (!metadata_.empty()) {
    const auto submitters = read_submitters(metadata_);
    if (!submitters) return refuse(submitters.error());
    name_ = *submitters;
  }
  if (name_.empty()) name_ = submission_name(submissions_);
  if (vary_) labs::set_inputs_seed(seed_of(lab, name_));
  const auto submitted = read_submission(submissions_);
  const auto digest = digest_of(lab, sources, {name_, submissions_, also_}, submitted);
  if (!digest) return refuse(digest.error());
  if (resume_ && is_up_to_date(files_.output, *digest)) {
    fmt::print("{} already has the result of this submission\n", files_.output);
    return kSuccess;
  }
  const auto lab_points = labs::read_lab_points(lab, sources.folder_of(lab.folder) / "points.json");
  if (!lab_points) return refuse(lab_points.error());
  const auto unfinished =
      gradescope_json(ungraded_submission(lab_points->lab, kUnfinished, !visible_), "", *digest);
  if (const auto begun = begin_results(files_, unfinished); !begun) return refuse(begun.error());
  for (const std::string& warning : lab_points->warnings) fmt::print(stderr, "{}\n", warning);
  return grade_one(lab_points->lab, sources, submitted, *digest, scratch);
}

int LabGradeCommand::grade_one(const labs::Lab& lab, const labs::Sources& sources,
                               const Result<SubmittedFile>& submitted, const std::string& digest,
                               const ScratchDirectory& scratch) {
  const auto place = scratch.path();
  if (!place) return refuse(place.error());
  auto sandbox = Sandbox::choose(*place, confinement_);
  if (!sandbox) return refuse(sandbox.error());
  auto kit =
      make_build_kit(sources, lab.folder, kit_.empty() ? *place / "kit" : fs::absolute(kit_));
  if (kit && !kit_.empty()) kit = copy_build_kit(*kit, *place / "kit");
  if (!kit) return refuse(kit.error());
  sandbox->try_view(kit->view, kit->compiler, *place);
  fmt::print(stderr, "sandbox: {}\n", sandbox->description());
  const auto build = scratch.make_private_directory("build");
  if (!build) return refuse(build.error());
  Limits limits;
  limits.seconds = seconds_;
  limits.memory_bytes = memory_mib_ * kMiB;
  const auto text =
      submitted ? Result<std::string>(submitted->text) : tl::unexpected(submitted.error());
  GradedSubmission graded = grade({.lab = lab,
                                   .sandbox = *sandbox,
                                   .kit = *kit,
                                   .build = *build,
                                   .limits = limits,
                                   .total_seconds = total_seconds_,
                                   .hidden = !visible_},
                                  text);
  graded.messages = (submitted ? submitted->note : "") + note_of_others(also_) + graded.messages;
  const auto results = gradescope_json(graded, sandbox->description(), digest);
  // an earlier result is kept, which is better than an unfinished one
  if (graded.outcome == kUnfinished) {
    fmt::print(stderr, "{}\n", results.at("output").get<std::string>());
    return kFailure;
  }
  if (const auto written = write_results(files_, results); !written) return refuse(written.error());
  fmt::print("{:.6g} of {:.6g} points\n{}", graded.result.score, graded.result.max_score,
             results.at("output").get<std::string>());
  return kSuccess;
}

std::vector<std::string> LabGradeCommand::command_for_one(const labs::Lab& lab,
                                                          const Sandbox& sandbox,
                                                          const Submission& submission) const {
  const fs::path results = fs::path(files_.output) / submission.name;
  std::vector<std::string> words{"/proc/self/exe",
                                 "lab",
                                 "grade",
                                 "--one",
                                 lab_dir_.empty() ? fmt::format("--lab={}", lab.number)
                                                  : "--lab-dir=" + fs::absolute(lab_dir_).string(),
                                 "--output=" + (results / "results.json").string(),
                                 "--classroom=" + (results / "classroom.json").string(),
                                 "--junit=" + (results / "junit.xml").string(),
                                 "--time-limit",
                                 fmt::format("{}", seconds_),
                                 "--total-time",
                                 fmt::format("{}", total_seconds_),
                                 "--memory-limit",
                                 std::to_string(memory_mib_),
                                 "--sandbox",
                                 std::string(name_of(sandbox.confinement())),
                                 "--kit=" + kit_};
  if (vary_) words.insert(words.end(), {"--vary", "--name=" + submission.name});
  for (const std::string& other : submission.also) words.push_back("--also=" + other);
  if (visible_) words.push_back("--visible");
  words.insert(words.end(), {"--", submission.path.string()});
  return words;
}

int LabGradeCommand::run_class(const labs::Lab& lab, const labs::Sources& sources,
                               const ScratchDirectory& scratch) {
  const auto listed = list_submissions(submissions_);
  if (!listed) return refuse(listed.error());
  for (const std::string& skipped : listed->skipped)
    fmt::print(stderr, "skipped: {}\n", printable(skipped));
  const std::vector<Submission>& all = listed->submissions;
  if (all.empty() && roster_.empty()) return refuse(no_submission_error(submissions_).value());
  // A roster that cannot be read is refused before anything is graded.
  if (const auto enrolled = roster(); !enrolled) return refuse(enrolled.error());
  std::error_code made;
  fs::create_directories(files_.output, made);
  std::map<std::string, Submission> chosen;
  for (const Submission& each : all) {
    const fs::path results = fs::path(files_.output) / each.name;
    std::error_code error;
    fs::create_directories(results, error);
    if (error)
      return refuse({results.string(), "",
                     "the folder for results cannot be created: " + error.message(),
                     "give another folder with -o"});
    const std::string file = (results / "results.json").string();
    if (resume_) {
      const auto digest = digest_of(lab, sources, each, read_submission(each.path));
      if (!digest) return refuse(digest.error());
      if (is_up_to_date(file, *digest)) continue;
    }
    chosen.emplace(each.name, each);
    const auto begun = begin_results(
        {file, (results / "classroom.json").string(), (results / "junit.xml").string()},
        unfinished_json());
    if (!begun) return refuse(begun.error());
  }
  if (chosen.size() < all.size())
    fmt::print(stderr, "{} of {} already {} a result, and {} skipped\n", all.size() - chosen.size(),
               counted(all.size(), "submission"),
               singular_or_plural(all.size() - chosen.size(), "has", "have"),
               singular_or_plural(all.size() - chosen.size(), "is", "are"));
  const auto place = scratch.path();
  if (!place) return refuse(place.error());
  auto sandbox = Sandbox::choose(*place, confinement_);
  if (!sandbox) return refuse(sandbox.error());
  const auto lab_points = labs::read_lab_points(lab, sources.folder_of(lab.folder) / "points.json");
  if (!lab_points) return refuse(lab_points.error());
  for (const std::string& warning : lab_points->warnings) fmt::print(stderr, "{}\n", warning);
  const auto kit = make_build_kit(sources, lab.folder, kit_);
  if (!kit) return refuse(kit.error());
  sandbox->try_view(kit->view, kit->compiler, *place);
  fmt::print(stderr, "sandbox: {}\n", sandbox->description());
  // The temporary files of the graded submissions are put here and are removed together with it.
  ::setenv("TMPDIR", place->c_str(), 1);

  ClassRequest request;
  for (const auto& [name, submission] : chosen) request.names.push_back(name);
  request.jobs =
      jobs_ > 0 ? jobs_ : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  request.command = [&](const std::string& name) {
    return command_for_one(lab, *sandbox, chosen.at(name));
  };
  std::size_t done = 0;
  request.ended = [&](const std::string& name, bool fine, const std::string& printed) {
    fmt::print(stderr, "{} of {}: {}{}\n", ++done, chosen.size(), printable(name),
               fine ? "" : ": grading did not finish");
    if (!fine) fmt::print(stderr, "{}\n", printable(printed, 2000));
  };
  grade_class(request);
  const auto nothing = gradescope_json(
      ungraded_submission(lab_points->lab, kNoSubmission, !visible_), sandbox->description());
  const int collected = run_collect(files_.output, nothing);
  if (listed->skipped.empty()) return collected;
  fmt::print(stderr, "{} of {} {} skipped (see above)\n",
             counted(listed->skipped.size(), "entry", "entries"), printable(submissions_),
             singular_or_plural(listed->skipped.size(), "was", "were"));
  return std::max<int>(collected, kFailure);
}

Result<Roster> LabGradeCommand::roster() const {
  return roster_.empty() ? Roster{} : read_roster(roster_);
}

// Makes the rows those of the roster. Says who is missing and whose submission is nobody's.
bool LabGradeCommand::apply_roster(std::vector<ClassRow>& rows, const Roster& roster,
                                   const nlohmann::ordered_json& lab) {
  RowsOfRoster found = rows_of_roster(roster, std::move(rows), lab);
  rows = std::move(found.rows);
  const auto say = [](const std::string& begin, const std::vector<std::string>& names) {
    constexpr std::size_t kLongestName = 40;
    fmt::print(stderr, "{}:\n", begin);
    for (const std::string& name : names)
      fmt::print(stderr, "  {}\n", printable(name, kLongestName));
  };
  if (!found.missing.empty())
    say(fmt::format("no submission of {} on the roster", counted(found.missing.size(), "student")),
        found.missing);
  if (!found.strangers.empty())
    say(fmt::format("{} of nobody on the roster, without a row in the tables",
                    counted(found.strangers.size(), "submission")),
        found.strangers);
  return found.missing.empty() && found.strangers.empty();
}

int LabGradeCommand::run_collect(const fs::path& results,
                                 const std::optional<nlohmann::ordered_json>& lab) const {
  const auto enrolled = roster();
  if (!enrolled) return refuse(enrolled.error());
  auto rows = read_results(results);
  if (!rows) return refuse(rows.error());
  if (rows->empty() && roster_.empty())
    return refuse({results.string(), "", "holds no folder",
                   "name the folder that `lab grade` wrote, with one folder for each submission"});
  const bool complete =
      roster_.empty() || apply_roster(*rows, *enrolled, lab ? *lab : lab_of_rows(*rows));
  for (const auto& [file, text] : {std::pair{kTableOfClass, class_csv(*rows, enrolled->columns)},
                                   {kPageOfClass, class_html(*rows, enrolled->columns)}}) {
    if (const auto written = write_text((results / file).string(), text); !written)
      return refuse(written.error());
  }
  std::size_t width = 10;
  for (const ClassRow& row : *rows)
    width = std::max(width, std::min<std::size_t>(40, row.name.size()));
  std::size_t unfinished = 0;
  for (const ClassRow& row : *rows) {
    fmt::print("{:<{}}  {:>7.6g} / {:<7.6g}  {}\n", printable(row.name, 40), width,
               total_of(row.results), row.results.at("extra_data").value("max_score", 0.0),
               outcome_of(row));
    if (!row.finished) ++unfinished;
  }
  fmt::print("{} and {} have the details\n", (results / kTableOfClass).string(),
             (results / kPageOfClass).string());
  if (unfinished == 0) return complete ? kSuccess : kFailure;
  fmt::print(stderr,
             "the grading of {} of {} did not finish; run lab grade --resume to finish it\n",
             unfinished, counted(rows->size(), "submission"));
  return kFailure;
}

}  // namespace glassbox::labs
