// glassbox lab: assignments, for students and for teachers.
#pragma once

#include "app/lab/check_command.h"
#include "app/lab/grade_command.h"
#include "app/lab/gradescope_command.h"
#include "app/lab/list.h"
#include "app/lab/measure_command.h"
#include "app/lab/package_command.h"
#include "app/lab/quiz_command.h"
#include "app/lab/render_command.h"
#include "app/lab/start_command.h"
#include "app/lab/stiff_command.h"
#include "app/options/cli_fwd.h"
#include "app/options/list_command.h"

namespace glassbox::app {

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

}  // namespace glassbox::app
