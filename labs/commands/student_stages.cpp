#include "labs/commands/student_stages.h"

namespace glassbox::labs {

namespace {

std::filesystem::path stage_build_dir(const LabFolder& folder, bool timed) {
  return folder.build_dir / (timed ? "measuring" : "drawing");
}

}  // namespace

Result<void> StudentStages::build(const labs::Sources& sources, const LabFolder& folder,
                                  Progress& progress, bool timed) {
  const auto place = scratch_.path();
  if (!place) return tl::unexpected(place.error());
  auto sandbox = labs::grading::Sandbox::choose(*place);
  if (!sandbox) return tl::unexpected(sandbox.error());
  sandbox_ = std::move(*sandbox);
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
