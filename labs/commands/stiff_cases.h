// Tests the extreme cases of a lab: draws each with a student's functions in the pipeline.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "labs/drawing/program.h"
#include "labs/framework/lab.h"
#include "labs/framework/sources.h"
#include "study/extremes/run.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

struct StiffCase {
  const study::ExtremeCase* what = nullptr;
  // The verdicts of the case's own judge: `yours` with the student's functions in the pipeline,
  // `reference` with the reference's instead, `naive` for naive code. `yours` and `reference` are
  // absent if the case is not visible in a picture that the lab draws.
  std::optional<study::Outcome> yours, reference;
  study::Outcome naive;
  std::string broke;  // how the student's code ended if it failed; empty: normally
  // The reference fails too, so no answer within the contract is expected to pass.
  bool out_of_reach() const { return yours && broke.empty() && !reference->passes(); }
  bool gives_up() const {
    return yours && (!broke.empty() || (!yours->passes() && reference->passes()));
  }
};

// The cases that the lab's handout names under "Stiff cases", sorted by code.
Result<std::vector<const study::ExtremeCase*>> cases_of_lab(const labs::Sources& sources,
                                                            const labs::Lab& lab);

StiffCase put_case(const study::ExtremeCase& extreme, const labs::Lab& lab,
                   const labs::LabDrawing& drawing, const labs::grading::Sandbox& sandbox,
                   const labs::StageProgram& program, double seconds);

}  // namespace glassbox::labs
