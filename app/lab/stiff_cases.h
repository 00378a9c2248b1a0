// The catalogue's cases of a lab, put to the pipeline with a student's functions in it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "labs/drawing/program.h"
#include "labs/framework/lab.h"
#include "labs/framework/sources.h"
#include "study/extremes/run.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

struct StiffCase {
  const study::ExtremeCase* what = nullptr;
  // By the case's own judge: with the student's functions in the pipeline, with the reference's in the same places, and what naive code
  // makes of it. Absent: the case does not show in a picture that the lab draws.
  std::optional<study::Outcome> yours, reference;
  study::Outcome naive;
  std::string broke;  // how the student's code ended; empty: well
  // Where no answer within the contract would hold, the reference's does not either.
  bool out_of_reach() const { return yours && broke.empty() && !reference->passes(); }
  bool gives_up() const {
    return yours && (!broke.empty() || (!yours->passes() && reference->passes()));
  }
};

// Those that the lab's handout names under "Stiff cases", in its order.
Result<std::vector<const study::ExtremeCase*>> cases_of_lab(const labs::Sources& sources,
                                                            const labs::Lab& lab);

StiffCase put_case(const study::ExtremeCase& extreme, const labs::Lab& lab,
                   const labs::LabDrawing& drawing, const labs::grading::Sandbox& sandbox,
                   const labs::StageProgram& program, double seconds);

}  // namespace glassbox::app
