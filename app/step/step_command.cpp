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
//     matrices/           reads a matrix as some program printed it; what the matrices are, what is
//                         wrong with them, and which change of convention would make the points
//                         visible
//     point_step          all of this for some points, transformed from space to space by
//                         pipeline/vertex_chain.h
//     point_summary, point_matrices_text, point_walk_text, point_verdict_text, point_json
//                         the answer
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
#include "app/step/point_summary.h"
#include "app/step/prompt.h"
#include "app/step/scene_vertices.h"
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
#include <glassbox/mesh/input/files.h>
#include <glassbox/mesh/limits.h>

namespace glassbox::app {

class StepCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  // Adds SCENE and the options for a triangle of a scene, with the options of the picture.
  void add_triangle(CLI::App& command);
  void add_tables(CLI::App& command);
  bool asks_for_points() const {
    return !points_.points.empty() || points_source_ || vertices_.has_value();
  }
  Result<void> read_tables(MatrixOptions& matrices);
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
  std::optional<std::string> points_source_, clip_source_;
  std::optional<std::vector<std::uint32_t>> vertices_;
  bool bits_ = false;
  std::optional<std::string> json_output_;
  std::uint32_t max_megabytes_ = 200;  // limit for the JSON output
};

namespace {

constexpr const char* kSceneGroup = "A triangle of a scene";
constexpr const char* kPointGroup = "Points through your own matrices";

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
        "needs x,y,width,height with a width above 0 and a height other than 0, not '" + text +
            "'");
  }
  return window;
}

// Reads a table of vertices from a file, or from standard input.
Result<std::vector<TableVertex>> read_table(const char* option, const std::string& source,
                                            VertexColumns wanted) {
  constexpr std::uint64_t kMaxBytes = 256 << 20;
  const std::string name = scene_title(source);
  return (source == "-" ? read_standard_input(kMaxBytes) : gltf::read_whole_file(source, kMaxBytes))
      .and_then([&](const std::vector<std::byte>& bytes) {
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        return parse_vertex_table(text, name, wanted);
      })
      .map([](VertexTable table) { return std::move(table.vertices); })
      .map_error([&](Error error) {
        error.file = name;
        error.place = error.place.empty() ? option : std::string(option) + ", " + error.place;
        return error;
      });
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
      ->group(kPointGroup);
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
      ->group(kPointGroup);
}

// Adds --viewport. It must not be used with --size, which the picture's options have added before.
void add_window(CLI::App& command, PointStepOptions& o) {
  command
      .add_option_function<std::string>(
          "--viewport", [&o](const std::string& text) { o.window = parse_window(text); },
          "the window in pixels: X, Y, width, height, as for glViewport")
      ->type_name("X,Y,W,H")
      ->group(kPointGroup)
      ->excludes(command.get_option("--size"));
}

constexpr const char* kStepFooter =
    "Examples:\n"
    "  glassbox step teapot --triangle 1000\n"
    "  glassbox step room --size 320x180 --pick 160,90 --bits\n"
    "  glassbox step model.glb --triangle 7 --vertex 0 --json trace.json\n"
    "  glassbox step --point 0,0,0 --view view.txt --proj proj.txt --size 1280x720\n"
    "  glassbox step --point 1,2,3 --model m.txt --view v.txt --proj p.txt --dialect vulkan\n"
    "  glassbox step model.obj --triangle 7 --view view.txt --proj proj.txt --size 1280x720\n"
    "  glassbox step model.obj --vertices 0,5 --view view.txt --proj proj.txt\n"
    "  glassbox step --points in.csv --clip out.csv --model m.txt --view v.txt --proj p.txt\n"
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
  const bool is_points = option.get_group() == kPointGroup;
  if (!of_points) return !is_points;
  return is_points || option.get_group() == kMatrixGroup || option.get_name() == "--size" ||
         option.get_group() == "Other outputs";
}

void print_ignored_options(const CLI::App& command, bool of_points) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || is_for(*option, of_points)) continue;
    fmt::print(stderr, "glassbox: note: {} is ignored: {}\n", option->get_name(),
               of_points ? "a point is transformed by your own matrices"
                         : "this option is for --point, but a scene is given");
  }
}

}  // namespace

void StepCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "step",
      "follow a triangle of a scene, or a point and your own matrices, through every space");
  command.footer(kStepFooter);
  add_triangle(command);
  add_points(command, points_);
  add_tables(command);
  add_window(command, points_);
  add_summary_options(command, points_);
  command.add_flag("--bits", bits_, "print the bits of each float too, in hexadecimal")
      ->group("Other outputs");
  add_json_output(command, json_output_)->group("Other outputs");
  add_max_megabytes(command, max_megabytes_, " of JSON");
  command.callback([this, &command, &exit_code] {
    const bool other_scene = !scene_.empty() && !vertices_;
    if (other_scene != asks_for_points()) print_ignored_options(command, asks_for_points());
    exit_code = run();
  });
}

// Adds the options for points that are not typed.
void StepCommand::add_tables(CLI::App& command) {
  CLI::Option* point = command.get_option("--point");
  CLI::Option* points = command
                            .add_option("--points", points_source_,
                                        "a table of points: CSV, OBJ, or RenderDoc's shader input")
                            ->type_name("FILE|-")
                            ->group(kPointGroup)
                            ->excludes(point);
  command
      .add_option_function<std::string>(
          "--vertices",
          [this](const std::string& text) { vertices_ = parse_vertex_numbers("--vertices", text); },
          "vertices of SCENE by their numbers, counted from 0")
      ->type_name("N,N,...")
      ->group(kPointGroup)
      ->excludes(point)
      ->excludes(points);
  command
      .add_option("--clip", clip_source_,
                  "their clip positions in your program: CSV, or RenderDoc's shader output")
      ->type_name("FILE|-")
      ->group(kPointGroup);
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
  if (!asks_for_points() && scene_.empty()) {
    return refuse({"", "", "neither a triangle nor a point is given",
                   "give a scene and --triangle N, or --point X,Y,Z and your matrices"});
  }
  if (!asks_for_points()) return run_triangle();
  if (vertices_ && scene_.empty()) {
    return refuse({"", "--vertices", "it needs a scene, but none is given", "name a scene"});
  }
  if (scene_.empty() || vertices_) return run_points();
  return refuse({"", points_source_ ? "--points" : "--point",
                 "points and matrices are given, and a scene as well",
                 "give a scene and --triangle or --vertices, or points and matrices"});
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

// Reads the points and clip positions that are not typed. Vertices of a scene bring the transform
// of their node with them, which acts before the model matrix.
Result<void> StepCommand::read_tables(MatrixOptions& matrices) {
  if (const auto read = check_matrices_read(matrices); !read) return read;
  if (vertices_) {
    const auto chosen = load_scene_argument(scene_, limits_).and_then([&](const Scene& scene) {
      return vertices_of(scene, *vertices_);
    });
    if (!chosen) return tl::unexpected(chosen.error());
    points_.table = chosen->vertices;
    if (!chosen->is_at_origin()) {
      matrices.model.m = matrices.model.m * chosen->world_from_object;
      matrices.model.origin +=
          (matrices.model.given ? ", times " : "") + ("node " + in_quotes(chosen->node));
      matrices.model.given = true;
    }
  }
  if (points_source_) {
    auto table = read_table("--points", *points_source_, VertexColumns::kObject);
    if (!table) return tl::unexpected(table.error());
    points_.table = *std::move(table);
  }
  if (!clip_source_) return {};
  auto clip = read_table("--clip", *clip_source_, VertexColumns::kClip);
  if (!clip) return tl::unexpected(clip.error());
  points_.program_clip = *std::move(clip);
  return {};
}

int StepCommand::run_points() {
  MatrixOptions matrices = picture_.matrices;
  if (const auto read = read_tables(matrices); !read) return refuse(read.error());
  const auto [width, height] = picture_.size;
  points_.size = glm::ivec2(width, height);
  const std::vector<std::string> words = given_option_words(picture_);
  points_.size_is_given = std::ranges::find(words, "--size") != words.end();
  points_.bits = bits_;
  const auto step = step_points(points_, matrices);
  if (!step) return refuse(step.error());
  if (json_output_) {
    if (const auto written = write_json(*json_output_, point_step_json(*step)); !written) {
      return refuse(written.error());
    }
    if (*json_output_ == "-") return exit_code_of(*step);
  }
  fmt::print("{}", point_step_text(*step));
  return exit_code_of(*step);
}

void add_step_command(CLI::App& app, int& exit_code) {
  add_command<StepCommand>(app, exit_code);
}

}  // namespace glassbox::app
