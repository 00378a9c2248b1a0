#include "app/lab/student_stages.h"

namespace glassbox::app {

Result<void> StudentStages::build(const labs::Sources& sources, const LabFolder& folder,
                                  Progress& progress, bool timed) {
  const auto place = scratch_.path();
  if (!place) return tl::unexpected(place.error());
  auto sandbox = labs::grading::Sandbox::choose(*place);
  if (!sandbox) return tl::unexpected(sandbox.error());
  sandbox_ = std::move(*sandbox);
  progress.phase("compiling " + folder.student.string());
  const std::filesystem::path kept = folder.build_dir / (timed ? "measuring" : "drawing");
  auto program = labs::build_stages(
      sources, {folder.lab->folder, folder.student, kept, *place, timed}, *sandbox_);
  if (!program) return tl::unexpected(program.error());
  program_ = std::move(*program);
  return {};
}

}  // namespace glassbox::app
