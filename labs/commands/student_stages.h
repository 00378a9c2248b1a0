// Builds the functions of a student's folder as a program, together with the sandbox that it runs
// in.
#pragma once

#include <optional>

#include "cli/report/progress.h"
#include "cli/report/scratch_directory.h"
#include "labs/commands/find_lab.h"
#include "labs/drawing/stage_program.h"

namespace glassbox::labs {

class StudentStages {
public:
  // Compiles what has changed: the lab's stages, or (if `timed`) the functions whose time is
  // measured. An error says what prevented the build; a student's own mistakes are in
  // program().messages instead.
  Result<void> build(const labs::Sources& sources, const LabFolder& folder, Progress& progress,
                     bool timed = false);

  // Builds the lab's starter as a program of the same kind. Call it after build().
  Result<labs::StageProgram> build_starter(const labs::Sources& sources, const LabFolder& folder,
                                           bool timed) const;

  // The sandbox and the program that build() has made.
  const labs::grading::Sandbox& sandbox() const { return *sandbox_; }
  const labs::StageProgram& program() const { return program_; }

private:
  ScratchDirectory scratch_;
  std::optional<labs::grading::Sandbox> sandbox_;
  labs::StageProgram program_;
};

}  // namespace glassbox::labs
