// The functions of a lab's folder as a program, and the sandbox that it runs in.
#pragma once

#include <optional>

#include "app/lab/find_lab.h"
#include "app/report/progress.h"
#include "app/report/scratch.h"
#include "labs/drawing/program.h"

namespace glassbox::app {

class StudentStages {
public:
  // Compiles what has changed: the lab's stages, or what is timed of it. An error is what kept it from being tried; a student's own
  // mistakes are in program().messages.
  Result<void> build(const labs::Sources& sources, const LabFolder& folder, Progress& progress,
                     bool timed = false);

  // The lab's starter as a program of the same kind, after build().
  Result<labs::StageProgram> build_starter(const labs::Sources& sources, const LabFolder& folder,
                                           bool timed) const;

  // Both as build() made them.
  const labs::grading::Sandbox& sandbox() const { return *sandbox_; }
  const labs::StageProgram& program() const { return program_; }

private:
  Scratch scratch_;
  std::optional<labs::grading::Sandbox> sandbox_;
  labs::StageProgram program_;
};

}  // namespace glassbox::app
