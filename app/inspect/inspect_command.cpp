// glassbox inspect SCENE -o page.html: writes a run of the scene as a page in which every stage can
// be examined.
#include <optional>
#include <span>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/builtin_help.h"
#include "cli/options/picture_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"
#include "inspect/page.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/mesh/limits.h>

namespace glassbox::app {

class InspectCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();
  Result<void> check_pixels() const;
  std::string command_line() const;

  std::string scene_;
  std::string output_;
  PictureOptions picture_;
  inspect::InspectOptions page_;
  LoadLimits limits_;
};

void InspectCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "inspect", "write a page that shows every stage of a picture, fragment by fragment");
  command.footer(
      "Examples:\n"
      "  glassbox inspect teapot -o teapot.html\n"
      "  glassbox inspect room --size 640x360 --pixel 320,180\n"
      "  glassbox inspect huge.glb --rect 600,300,680,380 -o part.html\n\n"
      "The page needs no network and no other file. The options of the picture are those of\n"
      "glassbox render: the same options show the same picture.\n\n" +
      builtin_help());
  command.add_option("SCENE", scene_, kSceneHelp)->required();
  command.add_option("-o,--output", output_, "the page, .html [SCENE.html]")->type_name("FILE");
  command
      .add_option_function<std::string>(
          "--pixel",
          [this](const std::string& text) { page_.pixel = parse_pixel("--pixel", text); },
          "the pixel that is selected when the page opens; all numbers of its fragments are "
          "recorded")
      ->type_name("X,Y");
  command
      .add_option_function<std::string>(
          "--rect",
          [this](const std::string& text) { page_.rectangle = parse_rectangle("--rect", text); },
          "record only triangles and fragments in these pixels, X0 <= x < X1 and Y0 <= y < Y1, "
          "with all numbers")
      ->type_name("X0,Y0,X1,Y1");
  add_picture_options(command, picture_);
  const std::string group = "Limits";
  command
      .add_option("--max-triangles", page_.max_triangles,
                  fmt::format("most triangles in a page [{}]", page_.max_triangles))
      ->type_name("N")
      ->group(group);
  command
      .add_option("--max-fragments", page_.max_fragments,
                  fmt::format("most fragments in a page [{}]", page_.max_fragments))
      ->type_name("N")
      ->group(group);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> InspectCommand::check_pixels() const {
  const auto& r = page_.rectangle;
  if (r) {
    if (const auto legal = check_rectangle("--rect", *r, picture_.size); !legal) return legal;
  }
  if (!page_.pixel) return {};
  if (const auto legal = check_pixel("--pixel", *page_.pixel, picture_.size); !legal) return legal;
  const auto [x, y] = *page_.pixel;
  if (r && (x < r->x0 || x >= r->x1 || y < r->y0 || y >= r->y1)) {
    return fail(fmt::format("--pixel {},{}", x, y), "the pixel is outside --rect",
                "name a pixel inside it");
  }
  return {};
}

// The command line that makes this page again.
std::string InspectCommand::command_line() const {
  std::vector<std::string> start;
  if (page_.pixel) start = {"--pixel", fmt::format("{},{}", page_.pixel->x, page_.pixel->y)};
  std::vector<std::string> kept;
  if (const auto& r = page_.rectangle) {
    kept = {"--rect", fmt::format("{},{},{},{}", r->x0, r->y0, r->x1, r->y1)};
  }
  return shell_line(
      {{"inspect", scene_}, given_option_words(picture_), start, kept, {"-o", output_}});
}

int InspectCommand::run() {
  if (output_.empty()) output_ = scene_stem(scene_) + ".html";
  if (const auto legal = check_extension(output_, ".html"); !legal) return refuse(legal.error());
  if (const auto legal = check_outputs({output_}); !legal) return refuse(legal.error());
  if (const auto legal = check_pixels(); !legal) return refuse(legal.error());
  print_pixel_centres_note(picture_);
  Progress progress;
  const Result<Scene> scene = load_scene_argument(scene_, picture_, progress, limits_);
  if (!scene) return refuse(scene.error());
  const Result<ChosenView> chosen = choose_view(*scene, picture_);
  if (!chosen) return refuse(chosen.error());

  page_.scene_name = scene_title(scene_);
  page_.words = given_option_words(picture_);
  page_.program = "glassbox " GLASSBOX_VERSION;
  page_.command = command_line();
  progress.phase("tracing " + scene_title(scene_));
  const Result<inspect::PageFacts> page =
      inspect::make_inspect_page(*scene, chosen->camera, chosen->view, picture_.settings, page_);
  if (!page) return refuse(page.error());
  progress.phase("writing " + output_);
  if (const auto written = write_file(output_, std::as_bytes(std::span(page->html))); !written) {
    return refuse(written.error());
  }
  progress.done();
  fmt::print("{}: {} and {}, {:.1f} MB; open it in a browser\n",
             printable(output_, kLongestMessage), counted(page->triangles, "triangle"),
             counted(page->fragments, "fragment"), double(page->html.size()) / 1e6);
  return kSuccess;
}

void add_inspect_command(CLI::App& app, int& exit_code) {
  add_command<InspectCommand>(app, exit_code);
}

}  // namespace glassbox::app
