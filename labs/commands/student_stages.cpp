#include "labs/commands/student_stages.h"

#include <chrono>
#include <filesystem>
#include <system_error>

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;

// Removes what is kept for folders that were not built for a month, and marks this one as in use.
// A class that is measured once would otherwise stay in the cache for ever.
void remove_unused(const fs::path& in_use) {
  constexpr auto kMonth = std::chrono::hours(24 * 30);
  const auto now = fs::file_time_type::clock::now();
  std::error_code error;
  fs::create_directories(in_use, error);
  fs::last_write_time(in_use, now, error);
  // Another process may remove them at the same time, so errors are ignored.
  for (fs::directory_iterator entry(in_use.parent_path(), error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (entry->last_write_time(ignored) + kMonth < now && !ignored)
      fs::remove_all(entry->path(), ignored);
  }
}

// Programs are kept in the cache and never in the folder: whoever handed the folder in could have
// put another program there.
fs::path stage_build_dir(const LabFolder& folder, bool timed) {
  return folder.cache / (timed ? "measuring" : "drawing");
}

}  // namespace

Result<void> StudentStages::build(const labs::Sources& sources, const LabFolder& folder,
                                  Progress& progress, bool timed) {
  const auto place = scratch_.path();
  if (!place) return tl::unexpected(place.error());
  auto sandbox = labs::grading::Sandbox::choose(*place);
  if (!sandbox) return tl::unexpected(sandbox.error());
  sandbox_ = std::move(*sandbox);
  remove_unused(folder.cache);
  progress.phase("compiling " + folder.student.string());
  auto program = labs::build_stages(
      sources, {folder.lab->folder, folder.student, stage_build_dir(folder, timed), *place, timed},
      *sandbox_);
  if (!program) return tl::unexpected(program.error());
  program_ = std::move(*program);
  return {};
}

Result<labs::StageProgram> StudentStages::build_starter(const labs::Sources& sources,
                                                        const LabFolder& folder, bool timed) const {
  const auto place = scratch_.path();
  if (!place) return tl::unexpected(place.error());
  return labs::build_stages(
      sources,
      {folder.lab->folder, folder.student, stage_build_dir(folder, timed), *place, timed, true},
      *sandbox_);
}

}  // namespace glassbox::labs
