// A lab's checks put to one student.cpp after the other.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include <unistd.h>

#include "labs/framework/check_lab.h"
#include "labs/framework/lab.h"
#include "tests/support/catch.h"

namespace glassbox::labs {

// A folder for a student's file and what is built from it; the checks are compiled once for all files put into it, and what is
// expected is worked out once.
class Bench {
public:
  // Cases that depend on a seed are worked out anew for each file.
  enum class Cases { kOnce, kAnew };
  explicit Bench(const Lab& lab, Cases cases_are = Cases::kOnce)
      : lab_(lab), sources_(find_sources().value()) {
    namespace fs = std::filesystem;
    folder_ = fs::temp_directory_path() / fmt::format("glassbox-{}-{}", lab.folder, getpid());
    fs::create_directories(folder_);
    if (cases_are == Cases::kAnew) return;
    for (Check& check : lab_.checks) {
      check.cases = [cases = check.cases()] { return cases; };
    }
  }
  ~Bench() { std::filesystem::remove_all(folder_); }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  const Sources& sources() const { return sources_; }
  const Lab& lab() const { return lab_; }

  LabResult check(const std::string& student, bool hidden = true) const {
    const auto file = folder_ / "student.cpp";
    REQUIRE(write_if_changed(file, student));
    CheckOptions options;
    options.with_hidden = hidden;
    options.limits.seconds = 60;  // of a machine that compiles other things meanwhile
    LocalRunner runner;
    BuildRequest request;
    request.folder = lab_.folder;
    request.student = file;
    request.build_dir = folder_ / (hidden ? "hidden" : "visible");
    request.seconds = 300;
    const auto result = check_lab(lab_, sources_, request, options, runner);
    REQUIRE(result);
    INFO(result->not_built);
    REQUIRE(result->not_built.empty());
    return *result;
  }

private:
  Lab lab_;
  Sources sources_;
  std::filesystem::path folder_;
};

// What a report would say first of each check that is not right.
inline std::string failures(const LabResult& result) {
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
