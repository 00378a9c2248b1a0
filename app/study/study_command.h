// glassbox study: error against run time, and the cases that break pipelines.
#pragma once

#include "app/options/cli_fwd.h"
#include "app/study/extremes_command.h"
#include "app/study/list_command.h"
#include "app/study/recommend_command.h"
#include "app/study/report_command.h"
#include "app/study/run_command.h"

namespace glassbox::app {

class StudyCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  StudyListCommand list_;
  StudyRunCommand run_;
  StudyReportCommand report_;
  StudyExtremesCommand extremes_;
  StudyRecommendCommand recommend_;
};

}  // namespace glassbox::app
