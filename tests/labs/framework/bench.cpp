#include "tests/labs/framework/bench.h"

#include <unistd.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "cli/process/process.h"
#include "labs/framework/lab_points.h"
#include "labs/framework/run_in_parallel.h"

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;

// Returns the lab's kit. Kits of earlier versions of the lab are removed.
grading::BuildKit cached_build_kit(const Sources& sources, const std::string& lab) {
  const auto fingerprint = grading::build_kit_fingerprint(sources, lab);
  REQUIRE(fingerprint);
  const fs::path place = fs::path(KEPT) / fmt::format("{}-{}", lab, *fingerprint);
  std::error_code error;
  for (fs::directory_iterator entry(KEPT, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path other = entry->path();
    std::error_code ignored;
    if (other != place && other.filename().string().starts_with(lab))
      fs::remove_all(other, ignored);
  }
  const auto kit = grading::make_build_kit(sources, lab, place);
  REQUIRE(kit);
  return *kit;
}

// Returns a folder that is removed with its contents when the tests end.
const fs::path& scratch() {
  struct Folder {
    fs::path path = fs::temp_directory_path() / fmt::format("glassbox-benches-{}", getpid());
    Folder() { fs::create_directories(path); }
    ~Folder() {
      std::error_code error;
      fs::remove_all(path, error);
    }
  };
  static const Folder folder;
  return folder.path;
}

}  // namespace

Bench& Bench::for_lab(const Lab& lab) {
  static std::map<std::string, std::unique_ptr<Bench>> all;
  auto& bench = all[lab.folder];
  if (!bench) bench.reset(new Bench(lab));
  return *bench;
}

Bench::Bench(const Lab& lab) : sources_(find_sources().value()) {
  INFO("lab " << lab.folder);
  const auto lab_points = read_lab_points(lab, sources_.folder_of(lab.folder) / "points.json");
  REQUIRE(lab_points);
  lab_ = lab_points->lab;
  solution_ = solution_text(sources_, lab.folder).value();
  kit_ = cached_build_kit(sources_, lab.folder);
  folder_ = scratch() / lab.folder;
  fs::create_directories(folder_);
  cases_ = all_cases();
}

Bench::AllCases Bench::all_cases() const {
  AllCases cases(lab_.checks.size());
  run_in_parallel(cases.size(), [&](std::size_t i) { cases[i] = lab_.checks[i].cases(); });
  return cases;
}

BenchProgram Bench::linked(const fs::path& object, bool hidden) {
  std::vector<std::string> objects{object.string()};
  for (const fs::path& each :
       kit_.objects(hidden ? grading::CheckSelection::kAll : grading::CheckSelection::kVisible))
    objects.push_back(each.string());
  const BenchProgram made{folder_ / fmt::format("runner-{}", ++programs_), hidden};
  const auto outcome = run_process(grading::link_command(kit_, objects, made.path.string(), {}),
                                   {300, 0, std::size_t(1) << 20});
  INFO(outcome.printed);
  REQUIRE(fs::exists(made.path));
  return made;
}

BenchProgram Bench::program(const std::string& student, bool hidden) {
  const auto made = try_program(student, hidden);
  INFO((made ? "" : made.error().message()));
  REQUIRE(made);
  return *made;
}

Result<BenchProgram> Bench::try_program(const std::string& student, bool hidden) {
  if (objects_.count(student) == 0) {
    const fs::path object = folder_ / fmt::format("student-{}.o", objects_.size());
    const fs::path source = folder_ / "student.cpp";
    REQUIRE(write_if_changed(source, student));
    const auto compiled = grading::compile_lab_file(kit_.compiler, source, {kit_.include}, object);
    if (!compiled) return tl::unexpected(compiled.error());
    objects_[student] = object;
  }
  return linked(objects_.at(student), hidden);
}

const Check* Bench::first_wrong(Runner& runner, const BenchProgram& program,
                                const std::string& task, Checks which) const {
  std::vector<std::size_t> order(cases_.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto is_other = [&](std::size_t i) { return lab_.checks[i].task != task; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(lab_.checks[a].generated, is_other(a)) <
           std::pair(lab_.checks[b].generated, is_other(b));
  });
  if (which == Checks::kOfTask) std::erase_if(order, is_other);
  for (const std::size_t i : order) {
    const Check& check = lab_.checks[i];
    RunLimits limits;
    limits.seconds = 600;  // of a busy machine; LimitedRunner ends a program before
    const auto answers = run_check(runner, program.path, check.name, cases_[i].size(), limits);
    if (judge_check(check, cases_[i], answers, 1).right < cases_[i].size()) return &check;
  }
  return nullptr;
}

BenchProgram Bench::starter(bool hidden) {
  return linked(kit_.starter, hidden);
}

LabResult Bench::check_with_new_cases(const BenchProgram& program, Inputs inputs) const {
  return check(program, all_cases(), inputs);
}

LabResult Bench::check(const BenchProgram& program, const AllCases& cases, Inputs inputs) const {
  std::vector<CheckResult> results(cases.size());
  run_in_parallel(cases.size(), [&](std::size_t i) {
    const Check& check = lab_.checks[i];
    if (check.hidden && !program.hidden) return;
    if (check.generated && inputs == Inputs::kCases) return;
    RunLimits limits;
    limits.seconds = 60;  // enough for a machine that is compiling at the same time
    LocalRunner runner;
    const auto answers = run_check(runner, program.path, check.name, cases[i].size(), limits);
    results[i] =
        judge_check(check, cases[i], answers, points_of_case(lab_, check, cases[i].size()));
  });
  std::erase_if(results, [](const CheckResult& each) { return each.name.empty(); });
  return sum_up(lab_, std::move(results));
}

RunOutcome LimitedRunner::run(const RunRequest& request) {
  if (has_failed_) return {};
  RunRequest limited = request;
  limited.program = "/usr/bin/env";
  limited.arguments = {variable_,         "prlimit",  "--cpu=5",
                       "--as=2000000000", "--core=0", request.program.string()};
  limited.arguments.insert(limited.arguments.end(), request.arguments.begin(),
                           request.arguments.end());
  const RunOutcome outcome = LocalRunner().run(limited);
  has_failed_ = outcome.ending != RunOutcome::Ending::kExit;
  return outcome;
}

std::string failures(const LabResult& result) {
  std::string text;
  for (const CheckResult& check : result.checks) {
    if (!check.first) continue;
    text += fmt::format("{} ({}, {}): {} {}", check.name, check.task, check.stage,
                        verdict_name(check.verdict), check.first->text);
    if (const auto& found = check.first->divergence)
      text += fmt::format(" case {} {} {} expected {} actual {} bound {} {}", check.first->index,
                          found->field, found->element, found->expected, found->actual,
                          found->bound, found->explanation);
    for (const std::string& slip : check.slips) text += " slip " + slip;
    text += "\n";
  }
  return text;
}

}  // namespace glassbox::labs
