// glassbox lab render: draws a scene with the student's functions in the pipeline, next to the
// reference's picture.
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/options/add_command.h"
#include "cli/options/builtin_help.h"
#include "cli/options/choices.h"
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "labs/commands/commands.h"
#include "labs/commands/draw_picture.h"
#include "labs/commands/find_lab.h"

namespace glassbox::labs {

class LabRenderCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  LabSelection selection_;
  std::string scene_, output_;
  PictureOptions picture_;
  std::optional<std::string> json_output_, html_output_;
  double seconds_ = 10;
};

void LabRenderCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command = *lab.add_subcommand(
      "render",
      "draws a scene with your functions in the pipeline, beside the reference's picture");
  command.footer(
      "Examples:\n"
      "  glassbox lab render ~/lab5 teapot -o teapot.png\n"
      "  glassbox lab render ~/lab6 room --size 320x180 --html room.html\n"
      "  glassbox lab render labs/04-projection cube --fov 70\n\n"
      "Your code runs in a process of its own, in the sandbox that is used for grading. The exit "
      "code is\n"
      "0 if every number is within its error bound, and 1 if one is not, or if the code does not\n"
      "compile or does not end.\n\n" +
      builtin_help());
  command
      .add_option("FOLDER", selection_.folder,
                  "a folder made by glassbox lab start, or a lab's folder in the sources")
      ->required();
  command.add_option("SCENE", scene_, kSceneHelp)->required();
  command
      .add_option("-o,--output", output_,
                  "your picture beside the reference's, .png or .ppm [SCENE.png]")
      ->type_name("FILE");
  add_lab_name(command, selection_.lab);
  add_picture_options(command, picture_);
  add_json_output(command, json_output_, "the report");
  add_html_output(command, html_output_,
                  "the run as a page, with your records beside the reference's");
  command
      .add_option("--time-limit", seconds_,
                  "time limit of a stage that runs your functions, in seconds")
      ->check(number_between(0.1, 3600))
      ->capture_default_str();
  command.callback([this, &exit_code] { exit_code = run(); });
}

int LabRenderCommand::run() const {
  const std::string output = output_.empty() ? scene_stem(scene_) + ".png" : output_;
  const LabPictureRequest request{selection_,   scene_,       output,  picture_,
                                  json_output_, html_output_, seconds_};
  if (const auto good = check_lab_picture(request); !good) return refuse(good.error());
  return draw_lab_picture(request);
}

void add_render_command(CLI::App& lab, int& exit_code) {
  add_command<LabRenderCommand>(lab, exit_code);
}

}  // namespace glassbox::labs
