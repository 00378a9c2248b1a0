// glassbox study: measures error against run time, and the cases that break pipelines.
#pragma once

#include "cli/options/cli_fwd.h"
#include "cli/options/list_command.h"
#include "study/commands/agree_command.h"
#include "study/commands/collect_command.h"
#include "study/commands/extremes_command.h"
#include "study/commands/list.h"
#include "study/commands/recommend_command.h"
#include "study/commands/report_command.h"
#include "study/commands/run_command.h"
#include "study/commands/scene_command.h"
#include "study/commands/stiffness_command.h"

namespace glassbox::study {

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

}  // namespace glassbox::study
