// glassbox study: measures error against run time, and the cases that break pipelines.
#pragma once

#include "app/options/cli_fwd.h"
#include "app/options/list_command.h"
#include "app/study/agree_command.h"
#include "app/study/collect_command.h"
#include "app/study/extremes_command.h"
#include "app/study/list.h"
#include "app/study/recommend_command.h"
#include "app/study/report_command.h"
#include "app/study/run_command.h"
#include "app/study/scene_command.h"
#include "app/study/stiffness_command.h"

namespace glassbox::app {

class StudyCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  ListCommand list_{"the experiments and what they ask", experiments_text, experiments_json};
  StudyRunCommand run_;
  StudyCollectCommand collect_;
  StudyAgreeCommand agree_;
  StudyReportCommand report_;
  StudyExtremesCommand extremes_;
  StudySceneCommand scene_;
  StudyRecommendCommand recommend_;
  StudyStiffnessCommand stiffness_;
};

}  // namespace glassbox::app
