#include "app/lab/student_stages.h"

namespace glassbox::app {

Result<void> StudentStages::build(const labs::Sources& sources, const LabFolder& folder,
                                  Progress& progress) {
  const auto place = scratch_.path();
  if (!place) return tl::unexpected(place.error());
  auto sandbox = labs::grading::Sandbox::choose(*place);
  if (!sandbox) return tl::unexpected(sandbox.error());
  sandbox_ = std::move(*sandbox);
  progress.phase("compiling " + folder.student.string());
  auto program = labs::build_stages(
      sources, {folder.lab->folder, folder.student, folder.build_dir / "drawing", *place},
      *sandbox_);
  if (!program) return tl::unexpected(program.error());
  program_ = std::move(*program);
  return {};
}

}  // namespace glassbox::app
