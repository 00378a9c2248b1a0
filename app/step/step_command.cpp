// glassbox step: follows a triangle of a scene, or points multiplied by the user's own matrices,
// through every space and shows each number.
//
// step_command reads the options and calls one of two groups of sources. Each first computes
// everything and then prints it:
//
//   glassbox step SCENE --triangle N | --pick X,Y
//     stepped_triangle    the run for this triangle only (render/trace), with its error bounds
//     triangle_stages     the texts of its stages, from object to picture; stage_texts.h lists the
//                         longer ones: camera_text (the matrices), clipping_text, singular_text,
//                         fragment_text
//     prompt, line_reader the same stage by stage at a prompt, with other cameras and triangles
//
//   glassbox step --point X,Y,Z --model FILE --view FILE --proj FILE
//     matrix_tokens, printed_matrix  reads a matrix as some program printed it
//     matrices/           what the matrices are, what is wrong with them, and which change of
//                         convention would make the points visible
//     point_step          all of this for some points, transformed from space to space by
//                         pipeline/vertex_chain.h
//     point_matrices_text, point_walk_text, point_verdict_text, point_json   the answer
//
// number_text writes numbers as text for both groups.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/step/point_step.h"
#include "app/step/prompt.h"
#include "app/trace/json.h"
#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/choices.h"
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/mesh/limits.h>

namespace glassbox::app {

class StepCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  // Adds SCENE and the options for a triangle of a scene, with the options of the picture.
  void add_triangle(CLI::App& command);
  int run();
  int run_triangle();
  int run_points();
  Result<void> check_size(std::size_t fragments) const;

  std::string scene_;
  PictureOptions picture_;
  LoadLimits limits_;
  std::optional<std::uint32_t> triangle_;
  std::optional<int> vertex_;
  std::optional<PixelPosition> pick_;
  bool interactive_ = false;

  PointStepOptions points_;
  bool bits_ = false;
  std::optional<std::string> json_output_;
  std::uint32_t max_megabytes_ = 200;  // limit for the JSON output
};

namespace {

constexpr const char* kSceneGroup = "A triangle of a scene";
constexpr const char* kGroup = "Your own matrices";

glm::dvec4 parse_point(const std::string& text) {
  constexpr double kLargest = double(std::numeric_limits<float>::max());
  const auto commas = std::count(text.begin(), text.end(), ',');
  if (commas != 2 && commas != 3) {
    throw CLI::ValidationError("--point", "needs X,Y,Z or X,Y,Z,W, not '" + text + "'");
  }
  glm::dvec4 point(0, 0, 0, 1);
  if (commas == 3) {
    const auto [x, y, z, w] = parse_numbers<4>("--point", text);
    point = {x, y, z, w};
  } else {
    const auto [x, y, z] = parse_numbers<3>("--point", text);
    point = {x, y, z, 1};
  }
  for (int i = 0; i < 4; ++i) {
    if (std::abs(point[i]) > kLargest) {
      throw CLI::ValidationError("--point", "needs numbers that a float can hold, up to 3.4e38");
    }
  }
  return point;
}

std::array<double, 4> parse_window(const std::string& text) {
  const auto window = parse_numbers<4>("--viewport", text);
  constexpr double kEnd = 1 << 20;
  for (const double number : window) {
    if (std::abs(number) > kEnd) {
      throw CLI::ValidationError("--viewport", "needs numbers up to 1048576, not '" + text + "'");
    }
  }
  if (!(window[2] > 0 && window[3] != 0)) {
    throw CLI::ValidationError(
        "--viewport",
        "needs x,y,width,height with a positive width and a height, not '" + text + "'");
  }
  return window;
}

void add_points(CLI::App& command, PointStepOptions& o) {
  command
      .add_option_function<std::vector<std::string>>(
          "--point",
          [&o](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) o.points.push_back(parse_point(text));
          },
          "the point in object space; may be given several times")
      ->type_name("X,Y,Z[,W]")
      ->allow_extra_args(false)
      ->group(kGroup);
  command
      .add_option_function<std::vector<std::string>>(
          "--expect",
          [&o](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              const auto [x, y] = parse_numbers<2>("--expect", text);
              o.expected.push_back({x, y});
            }
          },
          "where in the window the point should appear; may be given several times, in the order "
          "of the points")
      ->type_name("X,Y")
      ->allow_extra_args(false)
      ->group(kGroup);
}

void add_matrices(CLI::App& command, PointStepOptions& o) {
  const auto add = [&](const char* name, std::optional<std::string>& source, const char* help) {
    command.add_option(name, source, help)->type_name("FILE|-|NUMBERS")->group(kGroup);
  };
  add("--model", o.model, "the model matrix, from object space to world space [the identity]");
  add("--view", o.view, "the view matrix, from world space to eye space [the identity]");
  add("--proj", o.projection,
      "the projection, from eye space to clip space; or projection times view");
  add_choice<std::optional<NumberOrder>>(
      command, "--order", o.order,
      {{"rows", NumberOrder::kRows}, {"columns", NumberOrder::kColumns}},
      "how the numbers are listed: row by row of p' = M p, or column by column (the rows of p M) "
      "[as the layout says, else rows]")
      ->group(kGroup);
}

void add_conventions(CLI::App& command, PointStepOptions& o) {
  Choices<const ApiDialect*> dialects;
  for (const ApiDialect& dialect : api_dialects()) dialects.push_back({dialect.name, &dialect});
  add_choice<const ApiDialect*>(
      command, "--dialect", o.dialect, dialects,
      "the graphics API that the matrices are made for [guessed from them]")
      ->group(kGroup);
  add_choice<std::optional<Handedness>>(
      command, "--world", o.world, {{"right", Handedness::kRight}, {"left", Handedness::kLeft}},
      "the handedness of your world, if you know it")
      ->group(kGroup);
}

// Adds --viewport. It must not be used with --size, which the picture's options have added before.
void add_window(CLI::App& command, PointStepOptions& o) {
  command
      .add_option_function<std::string>(
          "--viewport", [&o](const std::string& text) { o.window = parse_window(text); },
          "the window in pixels: X, Y, width, height, as for glViewport")
      ->type_name("X,Y,W,H")
      ->group(kGroup)
      ->excludes(command.get_option("--size"));
}

constexpr const char* kStepFooter =
    "Examples:\n"
    "  glassbox step teapot --triangle 1000\n"
    "  glassbox step room --size 320x180 --pick 160,90 --bits\n"
    "  glassbox step model.glb --triangle 7 --vertex 0 --json trace.json\n"
    "  glassbox step --point 0,0,0 --view view.txt --proj proj.txt --size 1280x720\n"
    "  glassbox step --point 1,2,3 --model m.txt --view v.txt --proj p.txt --dialect vulkan\n"
    "  glassbox step --point 0,0,-5 --proj '1 0 0 0  0 1 0 0  0 0 -1.02 -0.202  0 0 -1 0'\n"
    "  myprogram | glassbox step --point 0,0,0 --point 1,1,1 --view - --proj proj.txt --json -\n\n"
    "A matrix is a file, - for standard input, or the sixteen numbers themselves, as your program\n"
    "prints them: brackets, commas and names do not matter. The first four are the first row of\n"
    "p' = M p, unless --order columns is given or the layout says otherwise (GLM's to_string "
    "does).\n"
    "Several points give a better diagnosis than one. docs/step.md explains everything.";

// Whether the option has an effect: for points through the user's own matrices (`of_points`), or
// else for a scene's triangle.
bool is_for(const CLI::Option& option, bool of_points) {
  const bool own_matrices = option.get_group() == kGroup;
  if (!of_points) return !own_matrices;
  return own_matrices || option.get_name() == "--size" || option.get_group() == "Other outputs";
}

void print_ignored_options(const CLI::App& command, bool of_points) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || is_for(*option, of_points)) continue;
    fmt::print(stderr, "glassbox: note: {} is ignored: {}\n", option->get_name(),
               of_points ? "a point goes through your own matrices"
                         : "a scene's triangle goes through the picture's matrices");
  }
}

}  // namespace

void StepCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "step", "a triangle of a scene, or a point through your own matrices, through every space");
  command.footer(kStepFooter);
  add_triangle(command);
  add_points(command, points_);
  add_matrices(command, points_);
  add_conventions(command, points_);
  add_window(command, points_);
  command.add_flag("--bits", bits_, "print the bits of each float too, in hexadecimal")
      ->group("Other outputs");
  add_json_output(command, json_output_)->group("Other outputs");
  add_max_megabytes(command, max_megabytes_, " of JSON than this");
  command.callback([this, &command, &exit_code] {
    const bool asks_for_points = !points_.points.empty();
    if (scene_.empty() == asks_for_points) print_ignored_options(command, asks_for_points);
    exit_code = run();
  });
}

void StepCommand::add_triangle(CLI::App& command) {
  command.add_option("SCENE", scene_, kSceneHelp);
  CLI::Option* triangle =
      command
          .add_option("--triangle", triangle_, "the triangle's number in the scene, counted from 0")
          ->type_name("N")
          ->group(kSceneGroup);
  command
      .add_option_function<std::string>(
          "--pick", [this](const std::string& text) { pick_ = parse_pixel("--pick", text); },
          "the triangle that is visible in this pixel, and its fragment there")
      ->type_name("X,Y")
      ->group(kSceneGroup)
      ->excludes(triangle);
  command.add_option("--vertex", vertex_, "show only this corner: 0, 1 or 2")
      ->type_name("K")
      ->check(CLI::Range(0, 2))
      ->group(kSceneGroup);
  command
      .add_flag("--interactive", interactive_,
                "show stage by stage, even if the input is not a terminal")
      ->group(kSceneGroup);
  add_picture_options(command, picture_);
}

int StepCommand::run() {
  if (points_.points.empty() && scene_.empty()) {
    return refuse({"", "", "there is nothing to step through",
                   "give a scene and --triangle N, or --point X,Y,Z and your matrices"});
  }
  if (points_.points.empty()) return run_triangle();
  if (scene_.empty()) return run_points();
  return refuse({"", "--point", "a scene is given as well",
                 "give a scene and a triangle, or points and matrices"});
}

// Refuses JSON above the limit. A fragment takes about two kilobytes, so a triangle that fills a
// picture can take hundreds or thousands of megabytes.
Result<void> StepCommand::check_size(std::size_t fragments) const {
  constexpr double kMegabytesOfFragment = 2.15e-3;
  const double megabytes = double(fragments) * kMegabytesOfFragment;
  if (megabytes <= double(max_megabytes_)) return {};
  return fail(fmt::format("--max-mb {}", max_megabytes_),
              fmt::format("the triangle has {}, about {:.0f} MB of JSON",
                          counted(fragments, "fragment"), megabytes),
              fmt::format("choose a smaller --size, or allow more with --max-mb {:.0f}",
                          std::ceil(megabytes)));
}

int StepCommand::run_triangle() {
  if (interactive_ && scene_ == "-") {
    return refuse({"", "--interactive", "standard input is the scene",
                   "leave --interactive out, or name the scene's file"});
  }
  print_pixel_centres_note(picture_);
  Progress progress;
  const Result<Scene> scene = load_scene_argument(scene_, picture_, progress, limits_);
  if (!scene) return refuse(scene.error());
  progress.phase("rendering " + scene_title(scene_));
  if (!triangle_ && !pick_) {
    return refuse({"", "", "no triangle is chosen",
                   "give --triangle N, or --pick X,Y for what a pixel shows"});
  }
  StepTarget target;
  target.vertex = vertex_;
  const auto aimed = set_step_target(target, *scene, picture_, triangle_, pick_, "--");
  if (!aimed) return refuse(aimed.error());
  const Result<SteppedTriangle> stepped = step_through(*scene, picture_, target.triangle);
  if (!stepped) return refuse(stepped.error());
  progress.done();

  if (json_output_) {
    if (const auto legal = check_size(stepped->trace.fragments.size()); !legal) {
      return refuse(legal.error());
    }
    nlohmann::ordered_json json = to_json(*scene, stepped->trace);
    json["scene"] = scene_;
    if (const auto written = write_json(*json_output_, json); !written)
      return refuse(written.error());
    if (*json_output_ == "-") return kSuccess;
  }
  std::vector<StageText> stages = stage_texts(*scene, *stepped, target, bits_);
  fmt::print("triangle {} of {}, {} x {}\n", stepped->place.number, printable(scene_title(scene_)),
             picture_.size.width, picture_.size.height);
  const bool terminal = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  if (interactive_ || (terminal && !json_output_)) {
    run_step_prompt(*scene, {given_option_words(picture_), target}, std::move(stages), bits_,
                    terminal);
  } else {
    for (const StageText& stage : stages) fmt::print("\n{}", stage.text);
  }
  return kSuccess;
}

int StepCommand::run_points() {
  const std::vector<std::string> words = given_option_words(picture_);
  if (std::find(words.begin(), words.end(), "--size") != words.end()) {
    const auto [width, height] = picture_.size;
    points_.window = {0, 0, double(width), double(height)};
  }
  points_.bits = bits_;
  const auto step = step_points(points_);
  if (!step) return refuse(step.error());
  if (json_output_) {
    if (const auto written = write_json(*json_output_, point_step_json(*step)); !written) {
      return refuse(written.error());
    }
    if (*json_output_ == "-") return kSuccess;
  }
  fmt::print("{}", point_step_text(*step));
  return kSuccess;
}

void add_step_command(CLI::App& app, int& exit_code) {
  add_command<StepCommand>(app, exit_code);
}

}  // namespace glassbox::app
