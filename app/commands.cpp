#include "app/commands.h"

#include "app/diff/diff_command.h"
#include "app/explain/explain_command.h"
#include "app/info/info_command.h"
#include "app/inspect/inspect_command.h"
#include "app/pixel/pixel_command.h"
#include "app/render/render_command.h"
#include "app/step/step_command.h"
#include "app/stereo/stereo_command.h"
#include "app/trace/trace_command.h"
#include "app/why/why_command.h"
#include "cli/options/add_command.h"

namespace glassbox::app {

void add_commands(CLI::App& app, int& exit_code) {
  add_command<RenderCommand>(app, exit_code);
  add_command<InfoCommand>(app, exit_code);
  add_command<ExplainCommand>(app, exit_code);
  add_command<StepCommand>(app, exit_code);
  add_command<PixelCommand>(app, exit_code);
  add_command<WhyCommand>(app, exit_code);
  add_command<TraceCommand>(app, exit_code);
  add_command<StereoCommand>(app, exit_code);
  add_command<InspectCommand>(app, exit_code);
  add_command<DiffCommand>(app, exit_code);
}

}  // namespace glassbox::app
