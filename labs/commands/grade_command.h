// glassbox lab grade and lab collect: grades a class, or one submission of it, from student.cpp to
// points.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"
#include "cli/report/scratch_directory.h"
#include "labs/commands/grade_files.h"
#include "labs/framework/lab.h"
#include "labs/framework/sources.h"
#include "labs/grading/build_kit.h"
#include "labs/grading/class_overview.h"
#include "labs/grading/roster.h"
#include "labs/grading/sandbox.h"
#include "labs/grading/submission.h"

namespace glassbox::labs {

class LabGradeCommand {
public:
  using FindSources = std::function<Result<labs::Sources>()>;
  // The arguments are for tests of the grader: they replace the program's own labs and sources.
  explicit LabGradeCommand(const std::vector<labs::Lab>& (*labs)() = labs::all_labs,
                           FindSources find_sources = labs::find_sources)
      : labs_(labs), find_sources_(std::move(find_sources)) {}

  // Adds `lab grade` and `lab collect`.
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run();
  int run_one(const labs::Lab& lab, const labs::Sources& sources, const ScratchDirectory& scratch);
  int grade_one(const labs::Lab& lab, const labs::Sources& sources,
                const Result<labs::grading::SubmittedFile>& submitted, const std::string& digest,
                const ScratchDirectory& scratch);
  int run_class(const labs::Lab& lab, const labs::Sources& sources,
                const ScratchDirectory& scratch);
  // Writes the tables of the class. A student of the roster without a submission has no points out
  // of those of `lab`, a results.json; by default that of another submission.
  int run_collect(const std::filesystem::path& results,
                  const std::optional<nlohmann::ordered_json>& lab) const;
  // The students of --roster; nobody without this option.
  Result<labs::grading::Roster> roster() const;
  // Returns whether every student handed in, and nobody else.
  static bool apply_roster(std::vector<labs::grading::ClassRow>& rows,
                           const labs::grading::Roster& roster, const nlohmann::ordered_json& lab);
  std::vector<std::string> command_for_one(const labs::Lab& lab,
                                           const labs::grading::Sandbox& sandbox,
                                           const labs::grading::Submission& submission) const;
  // A digest of everything that the result of a submission depends on.
  Result<std::string> digest_of(const labs::Lab& lab, const labs::Sources& sources,
                                const labs::grading::Submission& submission,
                                const Result<labs::grading::SubmittedFile>& submitted) const;
  // The seed by which the inputs of the submission with this name are varied; never 0.
  static std::uint64_t seed_of(const labs::Lab& lab, const std::string& name);
  Result<const labs::Lab*> find_lab(const labs::Sources& sources,
                                    const ScratchDirectory& scratch) const;

  const std::vector<labs::Lab>& (*labs_)();
  FindSources find_sources_;
  std::string submissions_, kit_, collected_, lab_dir_, name_, metadata_, roster_;
  std::vector<std::string> also_;  // Submission::also, with --one
  ResultFiles files_;              // for a class: the folder of all results
  std::optional<int> lab_;
  std::optional<labs::grading::Confinement> confinement_;
  int jobs_ = 0;
  double seconds_ = 10, total_seconds_ = 300;
  std::size_t memory_mib_ = 512;
  bool one_ = false, resume_ = false, vary_ = false, visible_ = false;
};

}  // namespace glassbox::labs
