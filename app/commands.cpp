#include "app/commands.h"

namespace glassbox::app {

void add_commands(CLI::App& app, int& exit_code) {
  add_render_command(app, exit_code);
  add_info_command(app, exit_code);
  add_explain_command(app, exit_code);
  add_step_command(app, exit_code);
  add_pixel_command(app, exit_code);
  add_why_command(app, exit_code);
  add_trace_command(app, exit_code);
  add_stereo_command(app, exit_code);
  add_inspect_command(app, exit_code);
  add_diff_command(app, exit_code);
}

}  // namespace glassbox::app
