// glassbox lab: assignments, for students and for teachers.
#pragma once

#include "cli/options/cli_fwd.h"
#include "cli/options/list_command.h"
#include "labs/commands/check_command.h"
#include "labs/commands/grade_command.h"
#include "labs/commands/gradescope_command.h"
#include "labs/commands/list.h"
#include "labs/commands/measure_command.h"
#include "labs/commands/package_command.h"
#include "labs/commands/quiz_command.h"
#include "labs/commands/render_command.h"
#include "labs/commands/start_command.h"
#include "labs/commands/stiff_command.h"

namespace glassbox::labs {

class LabCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  ListCommand list_{"the labs, their tasks and points", labs_text, labs_json};
  LabStartCommand start_;
  LabCheckCommand check_;
  LabWatchCommand watch_;
  LabRenderCommand render_;
  LabStiffCommand stiff_;
  LabQuizCommand quiz_;
  LabMeasureCommand measure_;
  LabExportCommand export_;
  LabGradeCommand grade_;
  LabGradescopeCommand gradescope_;
  LabPackageCommand package_;
};

}  // namespace glassbox::labs
