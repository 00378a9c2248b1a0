#include "app/inspect_command.h"

#include <filesystem>
#include <span>

#include <fmt/format.h>

#include "app/arguments.h"
#include "app/builtin_help.h"
#include "app/exit_codes.h"
#include "app/output.h"
#include "app/program_name.h"
#include "app/progress.h"
#include "app/shell_line.h"

#include <glassbox/images/atomic_file.h>
#include <glassbox/mesh/load.h>

namespace glassbox::app {

namespace {

bool is_pixel(double x) {
  return x >= 0 && x <= kMaxImageSide && x == int(x);
}

PixelAt parse_pixel(const std::string& text) {
  const auto [x, y] = parse_numbers<2>("--pixel", text);
  if (!is_pixel(x) || !is_pixel(y)) {
    throw CLI::ValidationError("--pixel",
                               "needs X,Y in whole pixels from the top left, not '" + text + "'");
  }
  return {int(x), int(y)};
}

PixelRect parse_rectangle(const std::string& text) {
  const auto [x0, y0, x1, y1] = parse_numbers<4>("--rect", text);
  if (!is_pixel(x0) || !is_pixel(y0) || !is_pixel(x1) || !is_pixel(y1) || x0 >= x1 || y0 >= y1) {
    throw CLI::ValidationError("--rect",
                               "needs X0,Y0,X1,Y1 in whole pixels from the top left, the last two "
                               "beyond the first two, not '" +
                                   text + "'");
  }
  return {int(x0), int(y0), int(x1), int(y1)};
}

std::string default_output(const std::string& scene) {
  return std::filesystem::path(scene.substr(0, scene.find(':'))).stem().string() + ".html";
}

}  // namespace

void InspectCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command =
      *app.add_subcommand("inspect", "every stage of a picture, fragment by fragment, as a page");
  command.footer(
      "Examples:\n"
      "  glassbox inspect teapot -o teapot.html\n"
      "  glassbox inspect room --size 640x360 --pixel 320,180\n"
      "  glassbox inspect huge.glb --rect 600,300,680,380 -o part.html\n\n"
      "The page needs no network and no other file. The options of the picture are those of\n"
      "glassbox render: the same words show the same picture.\n\n" +
      builtin_help());
  command.add_option("SCENE", scene_, "a glTF, GLB or OBJ file, or the name of a built-in scene")
      ->required();
  command.add_option("-o,--output", output_, "the page, .html [SCENE.html]")->type_name("FILE");
  command
      .add_option_function<std::string>(
          "--pixel", [this](const std::string& text) { page_.pixel = parse_pixel(text); },
          "the pixel chosen on opening, with every number of its fragments")
      ->type_name("X,Y");
  command
      .add_option_function<std::string>(
          "--rect", [this](const std::string& text) { page_.rectangle = parse_rectangle(text); },
          "only what reaches into these pixels, x0 <= x < x1, with every number")
      ->type_name("X0,Y0,X1,Y1");
  add_picture_options(command, picture_);
  const std::string group = "Limits";
  command
      .add_option("--max-triangles", page_.max_triangles,
                  fmt::format("in a page [{}]", page_.max_triangles))
      ->type_name("N")
      ->group(group);
  command
      .add_option("--max-fragments", page_.max_fragments,
                  fmt::format("in a page [{}]", page_.max_fragments))
      ->type_name("N")
      ->group(group);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> InspectCommand::check_pixels() const {
  const auto [width, height] = picture_.size;
  const std::string size = fmt::format("the picture has {} x {} pixels", width, height);
  if (page_.rectangle && (page_.rectangle->x1 > width || page_.rectangle->y1 > height)) {
    return fail("--rect", size, "name a part of it, or another --size");
  }
  if (!page_.pixel) return {};
  const auto [x, y] = *page_.pixel;
  const std::string place = fmt::format("--pixel {},{}", x, y);
  if (x >= width || y >= height) return fail(place, size, "name a pixel in it, or another --size");
  const auto& r = page_.rectangle;
  if (r && (x < r->x0 || x >= r->x1 || y < r->y0 || y >= r->y1)) {
    return fail(place, "the pixel lies outside of --rect", "name a pixel inside");
  }
  return {};
}

// What makes this page again.
std::string InspectCommand::command_line() const {
  std::vector<std::string> words{"inspect", scene_};
  const std::vector<std::string> picture = words_given(picture_);
  words.insert(words.end(), picture.begin(), picture.end());
  if (page_.pixel) {
    words.insert(words.end(), {"--pixel", fmt::format("{},{}", page_.pixel->x, page_.pixel->y)});
  }
  if (const auto& r = page_.rectangle) {
    words.insert(words.end(), {"--rect", fmt::format("{},{},{},{}", r->x0, r->y0, r->x1, r->y1)});
  }
  words.insert(words.end(), {"-o", output_});
  return shell_line(words).value_or("");
}

int InspectCommand::run() {
  if (output_.empty()) output_ = default_output(scene_);
  if (const auto legal = check_extension(output_, ".html"); !legal) return refuse(legal.error());
  if (const auto legal = check_outputs({output_}); !legal) return refuse(legal.error());
  if (const auto legal = check_pixels(); !legal) return refuse(legal.error());
  Progress progress;
  progress.phase("loading " + scene_);
  const Result<Scene> scene = load_scene(scene_, limits_);
  if (!scene) return refuse(scene.error());
  for (const std::string& warning : scene->warnings) progress.say("warning: " + warning);
  const Result<ChosenView> chosen = choose_view(*scene, picture_);
  if (!chosen) return refuse(chosen.error());

  page_.scene_name = scene_;
  page_.words = words_given(picture_);
  page_.program = "glassbox " GLASSBOX_VERSION;
  page_.command = command_line();
  progress.phase("tracing " + scene_);
  const Result<PageFacts> page =
      make_inspect_page(*scene, chosen->camera, chosen->view, picture_.settings, page_);
  if (!page) return refuse(page.error());
  progress.phase("writing " + output_);
  if (const auto written = write_file(output_, std::as_bytes(std::span(page->html))); !written) {
    return refuse(written.error());
  }
  progress.done();
  fmt::print("{}: {} triangles and {} fragments, {:.1f} MB; open it in a browser\n", output_,
             page->triangles, page->fragments, double(page->html.size()) / 1e6);
  return kSuccess;
}

}  // namespace glassbox::app
