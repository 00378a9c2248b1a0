// glassbox render SCENE: draws a picture and, if asked for, writes other images of the framebuffer,
// such as the depths.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/frames/frames.h"
#include "app/render/error_report.h"
#include "app/stereo/stereo_picture.h"
#include "app/why/verdict_text.h"
#include "cli/frames/frames_options.h"
#include "cli/frames/stop_request.h"
#include "cli/options/add_command.h"
#include "cli/options/builtin_help.h"
#include "cli/options/choices.h"
#include "cli/options/engine_options.h"
#include "cli/options/ignored_options.h"
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/number_json.h"
#include "cli/report/output.h"
#include "cli/report/picture_output.h"
#include "cli/report/progress.h"
#include "cli/report/stage_report.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/elapsed.h>
#include <glassbox/base/error.h>
#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/recipe.h>
#include <glassbox/images/write.h>
#include <glassbox/mesh/check.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/framebuffer.h>
#include <glassbox/render/engine/statistics.h>
#include <glassbox/render/renderer.h>
#include <glassbox/render/trace/numbering.h>
#include <glassbox/render/trace/scene_verdict.h>

namespace glassbox::app {

struct DrawnPicture;

// How long loading the scene and the whole run took.
struct RunTimes {
  double load_ms = 0, total_ms = 0;
};

class RenderCommand {
public:
  // Adds the subcommand. When it runs, its result is stored in `exit_code`.
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();
  // Draws the frames of a camera path.
  int run_frames(const std::string& default_output);
  Result<DrawnPicture> draw(const Scene& scene, Renderer& renderer) const;
  std::vector<TextEntry> recipe_text() const;
  Result<void> write_pictures(const std::string& image, const DrawnPicture& drawn) const;
  Result<void> write_error_report(const Scene& scene, Renderer& renderer,
                                  const DrawnPicture& drawn) const;
  std::string stats_text(const DrawnPicture& drawn, const RunTimes& times) const;
  // Prints what is to be reported when all files are written. Returns the exit code.
  int report(const std::string& image, const DrawnPicture& drawn, const RunTimes& times) const;
  // Checks the paths of all outputs as far as possible before anything is computed.
  Result<void> check_other_outputs(const std::string& image) const;

  std::string scene_ = "teapot";
  std::string output_;  // empty: named after the scene
  std::optional<StreamFormat> format_;
  PictureOptions picture_;
  StereoPictureOptions stereo_;
  FramesOptions frames_;
  EngineOptions engine_;
  LoadLimits limits_;
  std::optional<std::string> depth_output_;
  std::optional<std::string> id_output_;
  std::optional<std::string> json_output_;
  std::optional<std::string> report_output_;
  bool stats_ = false;
  bool check_ = false;  // fail if nothing is seen
};

// The picture, and the data for the reports about it.
struct DrawnPicture {
  Camera camera;
  View view;  // for two eyes: the view of the camera between them
  Image<Rgba8> image;
  Framebuffer planes;
  // The statistics of each eye with the eye's name, which is empty if there is only one eye.
  std::vector<std::pair<std::string, Statistics>> stages;
  std::string eyes_text;
  nlohmann::ordered_json eyes_json;
  std::optional<ChosenEyes> eyes;
  std::optional<WarpedRightEye> warped;
};

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

// Floats represent every integer up to 2^24. Ids up to 2^24 - 1 therefore stay exact, also when 1
// is added.
constexpr std::uint64_t kMaxIdTriangles = (1u << 24) - 1;

Result<void> write_ids(const std::string& path, const Image<std::uint32_t>& ids) {
  Image<float> as_floats(ids.width, ids.height);
  for (std::size_t i = 0; i < ids.pixels.size(); ++i) as_floats.pixels[i] = float(ids.pixels[i]);
  return write_file(path, encode_pfm(as_floats));
}

Json camera_json(const Camera& camera, const View& view) {
  Json matrix = Json::array();
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      matrix.push_back(camera.world_from_eye.at(row, column));
  }
  Json json{{"name", camera.name},
            {"projection", view.perspective ? "perspective" : "parallel"},
            {"near", view.near}};
  json["far"] = finite_or_inf(view.far);
  json["world_from_eye_rows"] = matrix;
  return json;
}

bool nothing_drawn(const DrawnPicture& drawn) {
  return std::ranges::all_of(drawn.stages, [](const auto& eye) { return eye.second.covered == 0; });
}

// The times of all eyes added up. The counts are left at 0.
Statistics times_of_all(const DrawnPicture& drawn) {
  Statistics sum;
  for (const auto& [eye, one] : drawn.stages) {
    sum.prepare_ms += one.prepare_ms;
    sum.vertex_ms += one.vertex_ms;
    sum.triangle_ms += one.triangle_ms;
    sum.fragment_ms += one.fragment_ms;
  }
  return sum;
}

// What is wrong with a scene of which nothing can be drawn, because all its faces lack area; empty
// if there is something to draw.
std::string why_nothing_can_be_drawn(const Scene& scene) {
  std::uint64_t faces = 0, in_z_order = 0;
  for (const Mesh& mesh : scene.meshes) {
    const MeshReport report = mesh_report(mesh);
    if (report.triangles + report.lines + report.points > 0) return "";
    faces += report.faces;
    in_z_order += report.quads_in_z_order;
  }
  std::string why = fmt::format("nothing is drawn, because {} of the scene {} no area",
                                faces == 1 ? "the only face" : fmt::format("all {} faces", faces),
                                faces == 1 ? "has" : "have");
  if (in_z_order > 0) {
    why += fmt::format("; {} listed in Z order: exchange the last two corners",
                       in_z_order == 1 ? "one is a quad" : fmt::format("{} are quads", in_z_order));
  }
  return why;
}

bool is_of_one_color(const Image<Rgba8>& image) {
  return std::ranges::all_of(image.pixels,
                             [&](const Rgba8& pixel) { return pixel == image.pixels.front(); });
}

// The explanation for a picture that shows only the background.
std::string why_empty(const Scene& scene, const View& view, const SceneVerdict& found) {
  if (const std::string why = why_nothing_can_be_drawn(scene); !why.empty()) return why;
  if (found.causes.empty()) return "no part of the scene is in this picture";
  const CauseText text = explain(scene, view, found, found.causes.front());
  return fmt::format("no part of the scene is seen in this picture: {}; {}", text.why, text.mend);
}

}  // namespace

void RenderCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand("render", "render a scene to an image");
  command.footer(
      "Examples:\n"
      "  glassbox render duck.glb -o duck.png\n"
      "  glassbox render teapot --eye 5,5,11 --look-at 0,1.5,0 --fov 30 --size 1920x1080\n"
      "  glassbox render plan.obj --ortho 10 --shade flat --background 1,1,1\n"
      "  glassbox render room --depth-out room.pfm --id-out ids.pfm --json -\n"
      "  glassbox render room --report -\n"
      "  glassbox render forest --stereo anaglyph --eye-separation 0.3 --window 12\n"
      "  glassbox render forest --stereo pair --second-eye warp --report -\n"
      "  glassbox render forest --stereo anaglyph --frames 60 --path walk.json -o walk.png\n"
      "  glassbox render duck.glb --frames 36 --turntable -o turn/\n"
      "  glassbox render - -o - < duck.glb > duck.png\n\n"
      "Engine options never change a byte of the picture (docs/engines.md). step, pixel, why and "
      "inspect\n"
      "always use the staged engine, because they look at one stage after the other.\n\n" +
      builtin_help());
  command.add_option("SCENE", scene_, kSceneHelp)->required();
  command
      .add_option("-o,--output", output_,
                  "image file, .png or .ppm [SCENE.png]; - is standard output")
      ->type_name("FILE|-");
  add_choice<std::optional<StreamFormat>>(
      command, "--format", format_, {{"png", StreamFormat::kPng}, {"ppm", StreamFormat::kPpm}},
      "format of the picture that -o - writes [png]");
  add_picture_options(command, picture_);
  add_stereo_picture_options(command, stereo_);
  add_frames_options(command, frames_);
  add_engine_options(command, engine_);

  const std::string outputs = "Other outputs";
  command
      .add_option("--depth-out", depth_output_,
                  "picture of distances along the gaze, +inf where nothing was drawn")
      ->type_name("FILE.pfm")
      ->group(outputs);
  command
      .add_option("--id-out", id_output_,
                  "picture with 1 + the number of the visible triangle at each pixel, 0 for none")
      ->type_name("FILE.pfm")
      ->group(outputs);
  command.add_flag("--stats", stats_, "print what every stage did, and how long it took")
      ->group(outputs);
  command
      .add_option("--report", report_output_,
                  "error bounds and time of each stage: JSON if the name ends in .json, else a "
                  "table; - is standard output")
      ->type_name("FILE|-")
      ->group(outputs);
  add_json_output(command, json_output_, "camera, counts and times")->group(outputs);
  command.add_flag("--check", check_, "exit with 1 if nothing of the scene is seen")
      ->group(outputs);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> RenderCommand::check_other_outputs(const std::string& image) const {
  if (stereo_.form.wanted && (depth_output_ || id_output_)) {
    return fail(depth_output_ ? "--depth-out" : "--id-out", "it would be different for each eye",
                "render one eye at a time, with --seen-by left and --seen-by right");
  }
  std::vector<std::string> paths{image};
  for (const std::optional<std::string>& plane : {depth_output_, id_output_}) {
    if (!plane) continue;
    if (const auto legal = check_extension(*plane, ".pfm"); !legal) return legal;
    paths.push_back(*plane);
  }
  if (stereo_.form.wanted && report_output_ && !stereo_.second_eye) {
    return fail("--report", "it would be different for each eye",
                "render one eye at a time, with --seen-by left and --seen-by right");
  }
  std::vector<std::string> at_standard_output;
  if (image == "-") at_standard_output.push_back("-o -");
  for (const auto& [option, target] :
       {std::pair("--json -", &json_output_), std::pair("--report -", &report_output_)}) {
    if (!*target) continue;
    if (**target != "-") {
      paths.push_back(**target);
    } else {
      at_standard_output.push_back(option);
    }
  }
  if (at_standard_output.size() > 1) {
    return fail(at_standard_output.back(),
                at_standard_output.front() == "-o -" ? "the picture goes to standard output"
                                                     : "the JSON goes to standard output",
                "name a file for one of them");
  }
  return check_outputs(paths);
}

// The recipe, which tells others how the picture was made. Empty for a scene from a pipe, which
// nobody could read again.
std::vector<TextEntry> RenderCommand::recipe_text() const {
  if (scene_ == "-") return {};
  std::vector<std::string> words = portable_option_words(picture_);
  for (const std::string& word : option_words(stereo_.options)) words.push_back(word);
  return to_text(Recipe{scene_, words, GLASSBOX_VERSION});
}

Result<DrawnPicture> RenderCommand::draw(const Scene& scene, Renderer& renderer) const {
  RenderSettings settings = picture_.settings;
  settings.want_distance = depth_output_.has_value();
  settings.want_id = id_output_.has_value();
  if (!stereo_.form.wanted) {
    return choose_view(scene, picture_).map([&](const ChosenView& chosen) {
      Rendering rendering = renderer.render(chosen.view, settings);
      Image<Rgba8> image = std::move(rendering.buffers.color);
      return DrawnPicture{chosen.camera,
                          chosen.view,
                          std::move(image),
                          std::move(rendering.buffers),
                          {{"", rendering.statistics}},
                          {},
                          {},
                          {},
                          {}};
    });
  }
  const Result<ChosenEyes> chosen = choose_eyes(scene, picture_);
  if (!chosen) return tl::unexpected(chosen.error());
  views::SecondEye second;
  return render_stereo_picture(renderer, scene, *chosen, settings, stereo_, second)
      .map([&](StereoPicture drawn) {
        const StereoRendering& both = drawn.rendering;
        DrawnPicture picture{chosen->camera,
                             chosen->centre,
                             std::move(drawn.image),
                             {},
                             {{"left", both.left_statistics}},
                             eyes_text(*chosen, both) + cropped_text(drawn) + warped_text(drawn),
                             eyes_json(*chosen, both),
                             *chosen,
                             {}};
        if (drawn.warped) picture.eyes_json["warped"] = warped_json(*drawn.warped);
        picture.warped = std::move(drawn.warped);
        if (drawn.cropped) {
          picture.eyes_json["cropped"] = {{"shift_px", drawn.cropped->shift_px},
                                          {"columns", drawn.cropped->shift}};
        }
        if (both.passes == 2) picture.stages.emplace_back("right", both.right_statistics);
        return picture;
      });
}

int RenderCommand::run_frames(const std::string& default_output) {
  if (depth_output_ || id_output_) {
    return refuse(
        {"", depth_output_ ? "--depth-out" : "--id-out", "it would be different for each frame",
         "leave this option out; a frame's PNG file holds the options that render it alone"});
  }
  if (stats_) {
    return refuse({"", "--stats", "it would be different for each frame",
                   "leave --stats out, or use --json, which has the numbers of each frame"});
  }
  if (report_output_) {
    return refuse(
        {"", "--report", "it would be different for each frame",
         "leave --report out; a frame's PNG file holds the options that render it alone"});
  }
  if (check_) {
    return refuse({"", "--check", "it would be different for each frame",
                   "leave --check out; a note says in how many frames nothing is in view"});
  }
  if (output_ == "-") {
    return refuse(
        {"", "-o -", "several frames cannot go to standard output", "name a file or a directory"});
  }
  if (format_) {
    return refuse({"", "--format", "this option is only for -o -", "end the name in .png or .ppm"});
  }
  if (const auto legal = check_stereo_picture(picture_, stereo_); !legal) {
    return refuse(legal.error());
  }
  return render_frames({scene_, output_, default_output, picture_, stereo_, frames_, engine_,
                        limits_, json_output_});
}

int RenderCommand::run() {
  const Clock::time_point start = Clock::now();
  if (const auto legal = check_frames_options(picture_, stereo_.form.wanted, frames_); !legal) {
    return refuse(legal.error());
  }
  if (const auto legal = check_engine_options(engine_); !legal) return refuse(legal.error());
  print_ignored_options(picture_);
  if (stereo_.second_eye) {
    stereo_.second_eye->threads =
        engine_.tile.threads > 0 ? engine_.tile.threads : default_threads();
    stereo_.second_eye->target = engine_.tile.target;
  }
  const std::string default_output = scene_stem(scene_) + ".png";
  if (frames_.requests_sequence()) return run_frames(default_output);
  const std::string output = output_.empty() ? default_output : output_;
  if (const auto legal = check_picture_output(output, format_, default_output); !legal) {
    return refuse(legal.error());
  }
  if (const auto legal = check_other_outputs(output); !legal) return refuse(legal.error());
  if (const auto legal = check_stereo_picture(picture_, stereo_); !legal) {
    return refuse(legal.error());
  }
  Progress progress;
  const Result<Scene> scene = load_scene_argument(scene_, picture_, progress, limits_);
  if (!scene) return refuse(scene.error());
  const double load_ms = elapsed_ms(start);

  if (id_output_ && count_triangles(*scene) > kMaxIdTriangles) {
    return refuse(
        {scene_, "--id-out",
         fmt::format(
             "the scene has {} triangles, but floats hold whole numbers exactly only up to {}",
             count_triangles(*scene), kMaxIdTriangles + 1),
         "leave --id-out out, or split the scene"});
  }

  progress.phase("rendering " + counted(count_triangles(*scene), "triangle"));
  Renderer renderer = make_renderer(*scene, picture_.settings, engine_);
  const Result<DrawnPicture> drawn = draw(*scene, renderer);
  if (!drawn) return refuse(drawn.error());
  {
    // Ctrl-C waits until the file that is being written is complete.
    const StopRequest stop;
    progress.phase("writing " + output);
    if (const auto written = write_pictures(output, *drawn); !written) {
      return refuse(written.error());
    }
    if (stop.is_requested()) return kFailure;
  }
  progress.done();
  // A picture of one colour shows nothing, or a surface that fills it.
  bool is_seen = true;
  if (nothing_drawn(*drawn) || is_of_one_color(drawn->image)) {
    const SceneVerdict found = scene_verdict(*scene, drawn->view, picture_.settings);
    is_seen = found.shown_pixels > 0;
    if (!is_seen) {
      fmt::print(stderr, "glassbox: note: {}\n", why_empty(*scene, drawn->view, found));
    }
  }
  const RunTimes times{load_ms, elapsed_ms(start)};
  if (report_output_) {
    progress.phase("computing error bounds");
    const auto written = write_error_report(*scene, renderer, *drawn);
    progress.done();
    if (!written) return refuse(written.error());
  }
  const int code = report(output, *drawn, times);
  return code == kSuccess && check_ && !is_seen ? kFailure : code;
}

// Computes the error bounds in a run of its own, so that the drawing of the picture is neither
// changed nor slowed down.
Result<void> RenderCommand::write_error_report(const Scene& scene, Renderer& renderer,
                                               const DrawnPicture& drawn) const {
  // The report on a pair is about the left eye, which is always drawn.
  const bool is_pair = drawn.eyes.has_value();
  std::vector<std::string> words = given_option_words(picture_);
  if (is_pair) words.insert(words.end(), {"--seen-by", "left"});
  const View view = is_pair ? eye_view(drawn.view, drawn.eyes->eyes.pair, Side::kLeft) : drawn.view;
  ErrorReport found{scene_,
                    words,
                    picture_.size.width,
                    picture_.size.height,
                    view,
                    picture_.settings,
                    engine_text(engine_),
                    drawn.stages.front().second,
                    picture_errors(scene, view, picture_.settings),
                    {}};
  if (is_pair && drawn.warped) {
    found.second_eye = views::second_eye_error(renderer, drawn.view, drawn.eyes->eyes.pair,
                                               picture_.settings, *stereo_.second_eye);
  }
  const std::string& target = *report_output_;
  return target != "-" && check_extension(target, ".json")
             ? write_json(target, error_report_json(found))
             : write_text(target, error_report_text(found));
}

Result<void> RenderCommand::write_pictures(const std::string& image,
                                           const DrawnPicture& drawn) const {
  const auto picture = write_picture(image, format_, drawn.image, recipe_text());
  if (!picture) return picture;
  if (depth_output_) {
    const auto written = write_file(*depth_output_, encode_pfm(drawn.planes.distance));
    if (!written) return written;
  }
  return id_output_ ? write_ids(*id_output_, drawn.planes.id) : Result<void>();
}

std::string RenderCommand::stats_text(const DrawnPicture& drawn, const RunTimes& times) const {
  std::string text = engine_text(engine_) + "\n\n";
  for (const auto& [eye, statistics] : drawn.stages) {
    if (!eye.empty()) text += eye + " eye\n";
    text += stage_table(statistics, engine_.engine) + "\n";
  }
  text += time_table(times_of_all(drawn)) + "\n";
  text += fmt::format("  {:<26}{:>12.1f} ms\n", "loading the scene", times.load_ms);
  return text + fmt::format("  {:<26}{:>12.1f} ms\n\n", "everything", times.total_ms);
}

int RenderCommand::report(const std::string& image, const DrawnPicture& drawn,
                          const RunTimes& times) const {
  if (json_output_) {
    Json json{{"scene", scene_},
              {"image", image},
              {"width", drawn.image.width},
              {"height", drawn.image.height},
              {"camera", camera_json(drawn.camera, drawn.view)},
              {"engine", engine_json(engine_)}};
    if (!drawn.eyes_json.is_null()) json["stereo"] = drawn.eyes_json;
    for (const auto& [eye, statistics] : drawn.stages) {
      json[eye.empty() ? "stages" : "stages_" + eye] = to_json(statistics);
    }
    // The tile engine draws the eyes alternately and times them together.
    if (engine_.engine == EngineKind::kTile && drawn.stages.size() > 1) {
      json["stages_right"].erase("ms");
    }
    json["load_ms"] = times.load_ms;
    json["total_ms"] = times.total_ms;
    if (const auto written = write_json(*json_output_, json); !written)
      return refuse(written.error());
  }
  if (json_output_ == "-" || report_output_ == "-") return kSuccess;
  std::FILE* const out = image == "-" ? stderr : stdout;
  if (stats_) fmt::print(out, "{}", stats_text(drawn, times));
  if (image == "-") return kSuccess;
  fmt::print("{} ({} x {}): {}, {:.0f} ms\n{}", printable(image, kLongestMessage),
             drawn.image.width, drawn.image.height,
             counted(drawn.stages.front().second.triangles, "triangle"), times.total_ms,
             drawn.eyes_text);
  return kSuccess;
}

void add_render_command(CLI::App& app, int& exit_code) {
  add_command<RenderCommand>(app, exit_code);
}

}  // namespace glassbox::app
