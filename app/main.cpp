// glassbox: a software rasterizer you can see through.
#include <exception>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/bench/bench_command.h"
#include "app/diff/diff_command.h"
#include "app/explain/explain_command.h"
#include "app/first/first_picture.h"
#include "app/help/completion_command.h"
#include "app/help/help_command.h"
#include "app/help/man_command.h"
#include "app/info/info_command.h"
#include "app/inspect/inspect_command.h"
#include "app/lab/lab_command.h"
#include "app/options/command_tree.h"
#include "app/options/usage_error.h"
#include "app/pixel/pixel_command.h"
#include "app/render/render_command.h"
#include "app/report/exit_codes.h"
#include "app/report/whole_run.h"
#include "app/step/step_command.h"
#include "app/stereo/stereo_command.h"
#include "app/study/study_command.h"
#include "app/trace/trace_command.h"
#include "app/views/views_command.h"
#include "app/why/why_command.h"

namespace glassbox::app {

namespace {

int run(int argc, char** argv) {
  CLI::App app{"Glassbox: a software rasterizer you can see through.", "glassbox"};
  app.set_version_flag("-V,--version", std::string("glassbox ") + GLASSBOX_VERSION);
  app.footer(
      "Without a subcommand the built-in teapot is rendered to teapot.png.\n"
      "glassbox SUBCOMMAND --help shows the options and examples, glassbox help SUBCOMMAND the "
      "same.");

  int exit_code = kSuccess;
  RenderCommand render;
  InfoCommand info;
  ExplainCommand explain;
  StepCommand step;
  PixelCommand pixel;
  WhyCommand why;
  TraceCommand trace;
  StereoCommand stereo;
  InspectCommand inspect;
  DiffCommand diff;
  BenchCommand bench;
  BenchPeerCommand bench_peer;
  StudyCommand study;
  ViewsCommand views;
  LabCommand lab;
  HelpCommand help;
  CompletionCommand completion;
  ManCommand man;
  render.add_to(app, exit_code);
  info.add_to(app, exit_code);
  explain.add_to(app, exit_code);
  step.add_to(app, exit_code);
  pixel.add_to(app, exit_code);
  why.add_to(app, exit_code);
  trace.add_to(app, exit_code);
  stereo.add_to(app, exit_code);
  inspect.add_to(app, exit_code);
  diff.add_to(app, exit_code);
  bench.add_to(app, exit_code);
  bench_peer.add_to(app, exit_code);
  study.add_to(app, exit_code);
  views.add_to(app, exit_code);
  lab.add_to(app, exit_code);
  help.add_to(app, exit_code);
  completion.add_to(app, exit_code);
  man.add_to(app, exit_code);
  app.require_subcommand(0, 1);
  refuse_empty_names(app);
  read_as_decimal(app);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version are no errors; anything else is bad usage, whatever code CLI11 has for it.
    if (error.get_exit_code() == 0) return app.exit(error), kSuccess;
    fmt::print(stderr, "glassbox: {}\n", usage_problem(app, error));
    return kBadInput;
  }
  if (app.get_subcommands().empty()) return draw_first_picture();
  return exit_code;
}

}  // namespace

}  // namespace glassbox::app

int main(int argc, char** argv) {
  glassbox::app::begin_run();
  try {
    return glassbox::app::end_run(glassbox::app::run(argc, argv));
  } catch (const std::exception& error) {
    return glassbox::app::tell(error);
  }
}
