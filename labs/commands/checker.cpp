#include "labs/commands/checker.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <thread>

#include <fmt/format.h>

#include "labs/framework/lab_points.h"
#include "labs/grading/compile.h"
#include "labs/grading/submission.h"

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;
using namespace labs::grading;

// Removes this lab's kits (the files that submissions are compiled with) that are a month old or
// older, except the one in use.
void remove_old_kits(const fs::path& kits, const std::string& lab, const fs::path& but) {
  constexpr auto kMonth = std::chrono::hours(24 * 30);
  const auto now = fs::file_time_type::clock::now();
  std::error_code error;
  // Another process may remove them at the same time, so errors are ignored.
  for (fs::directory_iterator entry(kits, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    const bool is_old = entry->last_write_time(ignored) + kMonth < now && !ignored;
    if (is_old && entry->path() != but && entry->path().filename().string().starts_with(lab + "-"))
      fs::remove_all(entry->path(), ignored);
  }
}

// The kit of a lab (what submissions are compiled with), which all folders of the lab share. It
// contains hidden checks, so it is kept in the user's cache and not in the student's folder. If its
// directory exists but is no valid kit (changed, or left incomplete), it is made again: the
// directory belongs to the program.
Result<BuildKit> cached_build_kit(const labs::Sources& sources, const LabFolder& folder) {
  const auto fingerprint = build_kit_fingerprint(sources, folder.lab->folder);
  if (!fingerprint) return tl::unexpected(fingerprint.error());
  std::error_code error;
  fs::create_directories(folder.kits, error);
  fs::permissions(folder.kits, fs::perms::owner_all, error);
  const fs::path place = folder.kits / fmt::format("{}-{}", folder.lab->folder, *fingerprint);
  remove_old_kits(folder.kits, folder.lab->folder, place);
  auto kit = make_build_kit(sources, folder.lab->folder, place);
  if (kit || !fs::exists(place, error)) return kit;
  fs::remove_all(place, error);
  return make_build_kit(sources, folder.lab->folder, place);
}

}  // namespace

Result<std::unique_ptr<LabChecker>> LabChecker::open(const LabFolder& folder,
                                                     const CheckOptions& options) {
  std::unique_ptr<LabChecker> checker(new LabChecker(folder, options));
  if (const auto prepared = checker->prepare(); !prepared) return tl::unexpected(prepared.error());
  return checker;
}

Result<void> LabChecker::prepare() {
  const auto sources = labs::find_sources();
  if (!sources) return tl::unexpected(sources.error());
  sources_ = *sources;
  sources_.outside = folder_.outside;
  auto lab_points =
      labs::read_lab_points(*folder_.lab, sources_.folder_of(folder_.lab->folder) / "points.json");
  if (!lab_points) return tl::unexpected(lab_points.error());
  lab_ = std::move(lab_points->lab);
  warnings_ = std::move(lab_points->warnings);
  const auto place = scratch_.path();
  if (!place) return tl::unexpected(place.error());
  auto sandbox = Sandbox::choose(*place, options_.confinement);
  if (!sandbox) return tl::unexpected(sandbox.error());
  sandbox_ = std::move(*sandbox);
  const auto kit = cached_build_kit(sources_, folder_);
  if (!kit) return tl::unexpected(kit.error());
  auto copy = copy_build_kit(*kit, *place / "kit");
  if (!copy) return tl::unexpected(copy.error());
  kit_ = std::move(*copy);
  return {};
}

Result<CheckOutcome> LabChecker::check() {
  const auto start = std::chrono::steady_clock::now();
  const auto text = read_source(folder_.student);
  if (!text) return tl::unexpected(text.error());
  const auto build = scratch_.make_private_directory(fmt::format("build-{}", ++builds_));
  if (!build) return tl::unexpected(build.error());
  GradeRequest request{.lab = lab_, .sandbox = *sandbox_, .kit = kit_, .build = *build};
  request.limits.seconds = options_.seconds;
  request.limits.memory_bytes = options_.memory_mib * kMiB;
  request.hidden = options_.hidden;
  request.max_parallel_checks = std::max(1u, std::thread::hardware_concurrency());
  request.compile_options.warnings = true;
  request.compile_options.sanitize = options_.sanitize;
  CheckOutcome checked;
  checked.graded = grade(request, *text);
  auto& result = checked.graded.result;
  if (!options_.hidden)
    std::erase_if(result.checks, [](const labs::CheckResult& each) { return each.hidden; });
  result.warnings = warnings_;
  if (result.not_built.empty() && !checked.graded.messages.empty())
    result.warnings.push_back(checked.graded.messages);
  const bool failed = std::any_of(result.checks.begin(), result.checks.end(),
                                  [](const labs::CheckResult& each) { return each.first; });
  if (failed) {
    auto program = debugger_program(*text);
    if (!program) return tl::unexpected(program.error());
    checked.runner = std::move(*program);
  }
  std::error_code error;
  fs::remove_all(*build, error);
  checked.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return checked;
}

Result<std::string> LabChecker::debugger_program(const std::string& text) {
  const auto build = scratch_.make_private_directory(fmt::format("debug-{}", builds_));
  if (!build) return tl::unexpected(build.error());
  CompileOptions options;
  options.debugger = true;
  options.debug_source_folder = folder_.student.parent_path().string();
  CompileResult compiled = compile_submission(text, *sandbox_, kit_, *build, options);
  const CheckSelection checks = options_.hidden ? CheckSelection::kAll : CheckSelection::kVisible;
  const fs::path made = compiled.failure.empty()
                            ? link_submission(checks, *sandbox_, kit_, *build, compiled.messages)
                            : fs::path();
  const fs::path program = (options_.hidden ? folder_.cache : folder_.build_dir) / "runner";
  std::error_code error;
  fs::create_directories(program.parent_path(), error);
  if (made.empty() || !fs::copy_file(made, program, fs::copy_options::overwrite_existing, error))
    return std::string();  // the report then names no program for the debugger
  fs::remove_all(*build, error);
  return program.string();
}

}  // namespace glassbox::labs
