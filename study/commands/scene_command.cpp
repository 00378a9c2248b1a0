// glassbox study scene: measures the error and the time of every way to draw the user's own scene.
#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/builtin_help.h"
#include "cli/options/engine_options.h"
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"
#include "study/bench/memory.h"
#include "study/commands/commands.h"
#include "study/commands/measuring.h"
#include "study/commands/report.h"
#include "study/commands/scene/curve_report.h"
#include "study/experiment/runner.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/error.h>
#include <glassbox/base/printable.h>
#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::study {

// Writes the camera that was chosen for a scene as options, so that other levels of detail of the
// scene are seen by the same camera.

namespace {

void set_lens(CameraOptions& options, const PerspectiveLens& lens) {
  options.fov_degrees = degrees_from_radians(lens.fovy_radians);
  options.near = lens.near;
  options.far = lens.far.value_or(std::numeric_limits<double>::infinity());
}
void set_lens(CameraOptions& options, const OrthographicLens& lens) {
  options.ortho_height = 2 * lens.half_height;
  options.near = lens.near;
  options.far = lens.far;
}
void set_lens(CameraOptions& options, const FrustumLens& lens) {
  options.frustum = {lens.left, lens.right, lens.bottom, lens.top};
  options.near = lens.near;
  options.far = lens.far.value_or(std::numeric_limits<double>::infinity());
}

// The numbers with the fewest digits that give the same doubles when they are read.
std::string comma_separated(std::span<const double> numbers) {
  return fmt::format("{}", fmt::join(numbers, ","));
}

}  // namespace

// The picture's options with this camera, instead of the options that chose it.
PictureOptions pinned(PictureOptions picture, const Camera& camera) {
  const auto& m = camera.world_from_eye;
  CameraOptions options;
  options.formulation = picture.camera.formulation;
  options.eye = {m.at(0, 3), m.at(1, 3), m.at(2, 3)};
  options.look_at = {m.at(0, 3) - m.at(0, 2), m.at(1, 3) - m.at(1, 2), m.at(2, 3) - m.at(2, 2)};
  options.up = {m.at(0, 1), m.at(1, 1), m.at(2, 1)};
  std::visit([&](const auto& lens) { set_lens(options, lens); }, camera.lens);
  picture.camera = options;
  return picture;
}

// The options as words: the given words without those about the camera, and then words for the
// camera of `pinned`.
std::vector<std::string> pinned_words(const PictureOptions& given, const PictureOptions& pinned) {
  constexpr std::string_view kReplaced[] = {"--camera", "--eye",     "--look-at", "--up", "--fov",
                                            "--ortho",  "--frustum", "--near",    "--far"};
  std::vector<const CLI::Option*> kept;
  for (const CLI::Option* option : given.options) {
    if (std::ranges::find(kReplaced, option->get_name()) == std::end(kReplaced))
      kept.push_back(option);
  }
  std::vector<std::string> words = glassbox::option_words(kept);
  const CameraOptions& camera = pinned.camera;
  const auto add = [&](const char* name, const auto& numbers) {
    if (numbers) words.insert(words.end(), {name, comma_separated(*numbers)});
  };
  const auto add_number = [&](const char* name, const std::optional<double>& number) {
    if (number) words.insert(words.end(), {name, fmt::to_string(*number)});
  };
  add("--eye", camera.eye);
  add("--look-at", camera.look_at);
  add("--up", camera.up);
  add_number("--fov", camera.fov_degrees);
  add_number("--ortho", camera.ortho_height);
  add("--frustum", camera.frustum);
  add_number("--near", camera.near);
  add_number("--far", camera.far);
  return words;
}

class StudySceneCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  Result<void> check_options() const;
  Result<CurveReport> measure(const Scene& scene, Progress& progress) const;
  SecondEyes measure_second_eyes(const Scene& scene, Progress& progress) const;
  Result<void> write_outputs(const CurveReport& report) const;
  std::string command() const;
  int run() const;

  std::string scene_;
  PictureOptions picture_;
  bool quick_ = false;
  int threads_ = 0;  // the largest number of threads to measure; 0: as many as the machine has
  std::optional<std::string> json_output_, csv_output_, page_;
};

namespace {

bool is_given(const std::vector<std::string>& words, const char* option) {
  return std::ranges::find(words, option) != words.end();
}

// Settings that the user has given are held fixed.
std::set<Knob> fixed_knobs(const std::vector<std::string>& words) {
  std::set<Knob> held;
  for (const auto& [option, knob] : {std::pair{"--shade", Knob::kShading},
                                     {"--filter", Knob::kFilter},
                                     {"--samples", Knob::kSamples},
                                     {"--depth", Knob::kDepth}}) {
    if (is_given(words, option)) held.insert(knob);
  }
  return held;
}

// The levels of detail of a built-in scene; empty for files, and for scenes without levels.
struct Levels {
  int chosen = 0;
  std::map<int, Scene> others;  // by level, which is a power of two
};

Result<Levels> levels_of(const std::string& word) {
  const BuiltinScene* const builtin = find_builtin(word);
  if (builtin == nullptr || !builtin->levels) return Levels{};
  const auto& [low, usual, high] = *builtin->levels;
  const auto colon = word.find(':');
  Levels levels{colon == std::string::npos ? usual : std::stoi(word.substr(colon + 1)), {}};
  for (int level = low; level <= high; level *= 2) {
    if (level == levels.chosen) continue;
    auto scene = make_builtin(fmt::format("{}:{}", builtin->name, level));
    if (!scene) return tl::unexpected(scene.error());
    levels.others.emplace(level, std::move(*scene));
  }
  return levels;
}

}  // namespace

void StudySceneCommand::add_to(CLI::App& study, int& exit_code) {
  CLI::App& command =
      *study.add_subcommand("scene", "measures error and time for every way to draw a scene");
  command.footer(
      "Examples:\n"
      "  glassbox study scene room\n"
      "  glassbox study scene model.glb --eye 0,1,4 --size 1920x1080 --html curve.html\n"
      "  glassbox study scene teapot --quick --csv -\n"
      "  glassbox study scene checker --filter nearest --json curve.json\n\n"
      "The command varies --shade, --filter, --samples and --depth if you do not give them, the "
      "level of\n"
      "detail of a built-in scene, and the options of the engine; docs/study.md says how it "
      "measures.\n"
      "The exit code is 1 if an option of the engine changed a byte of the picture.\n\n" +
      builtin_help());
  command.add_option("SCENE", scene_, kSceneHelp)->required();
  add_picture_options(command, picture_);
  command.add_flag("--quick", quick_,
                   "vary each option alone, and do not combine shading, filter and samples");
  command.add_option("--threads", threads_, "the largest number of threads that is tried [all]")
      ->check(CLI::Range(1, kMaxThreads));
  add_json_output(command, json_output_, "the measurements");
  command.add_option("--csv", csv_output_, "the measurements as comma-separated values")
      ->type_name("FILE|-");
  add_html_output(command, page_, "chart, pictures and differences as one page");
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> StudySceneCommand::check_options() const {
  if (picture_.settings.show != Show::kColor) {
    return fail("--show",
                "study scene measures errors of colours, but --show draws another quantity",
                "leave --show out");
  }
  if (json_output_ == "-" && csv_output_ == "-") {
    return fail("--csv", "standard output already gets the JSON", "name a file for one of the two");
  }
  return Outputs().data(json_output_).data(csv_output_).file(page_, ".html").check();
}

// The command line that makes the page again.
std::string StudySceneCommand::command() const {
  std::vector<std::string> own;
  if (quick_) own.emplace_back("--quick");
  if (threads_ > 0) own.insert(own.end(), {"--threads", fmt::to_string(threads_)});
  if (page_) own.insert(own.end(), {"--html", *page_});
  return shell_line({{"study", "scene", scene_}, given_option_words(picture_), own});
}

SecondEyes StudySceneCommand::measure_second_eyes(const Scene& scene, Progress& progress) const {
  SecondEyes eyes;
  if (picture_.eyes.seen_by) {
    eyes.left_out = "a second eye needs both eyes, but --seen-by asks for one";
    return eyes;
  }
  const auto chosen = choose_eyes(scene, picture_);
  if (!chosen || chosen->eyes.pair.half_separation == 0) {
    eyes.left_out = chosen ? "both eyes are at the same place" : chosen.error().message();
    return eyes;
  }
  eyes.pair = chosen->eyes.pair;
  const RenderSettings& settings = picture_.settings;
  constexpr int kThreads = 1;  // all other measurements use one thread too
  Renderer renderer(scene, settings.transfer, EngineKind::kTile, {.threads = kThreads});
  for (const int layers : {1, 2}) {
    const auto legal = views::check_second_eye(scene, settings, layers);
    if (!legal) {
      if (eyes.warped.empty()) eyes.left_out = legal.error().message();
      break;
    }
    progress.phase(fmt::format("warping a second eye from {}", counted(layers, "layer")));
    eyes.warped.push_back(views::second_eye_error(renderer, chosen->centre, eyes.pair, settings,
                                                  {.layers = layers, .threads = kThreads}));
  }
  return eyes;
}

Result<CurveReport> StudySceneCommand::measure(const Scene& scene, Progress& progress) const {
  const auto chosen = choose_view(scene, picture_);
  if (!chosen) return tl::unexpected(chosen.error());
  auto levels = levels_of(scene_);
  if (!levels) return tl::unexpected(levels.error());
  // Automatic framing would place the camera slightly differently for each level, so the camera of
  // the level that the user named is used for all.
  const bool pin = !levels->others.empty() && !picture_.eyes.seen_by;
  const PictureOptions picture = pin ? pinned(picture_, chosen->camera) : picture_;

  study::CurveRequest request;
  request.scene = &scene;
  request.level = levels->chosen;
  if (pin) request.at_levels = std::move(levels->others);
  request.view = [&](const RenderSettings& settings, int factor) {
    return choose_view(scene, picture, settings, factor);
  };
  const int threads = threads_ > 0 ? threads_ : default_threads();
  const std::vector<std::string> given = given_option_words(picture_);
  request.variants.settings = picture_.settings;
  request.variants.filter = picture_.filter;
  request.variants.fixed_knobs = fixed_knobs(given);
  request.variants.cull_stage_fixed = is_given(given, "--cull-stage");
  request.variants.threads = threads;
  for (const auto& [level, unused] : request.at_levels) request.variants.levels.push_back(level);
  request.combine = !quick_;
  request.repetitions = study::kMinRepetitions;
  request.keep_pictures = page_.has_value();
  if (const double free = study::available_bytes(); free > 0) request.most_bytes = free / 2;
  request.phase = [&](const std::string& what) { progress.phase(what); };
  return study::measure_curve(request).map([&](study::Curve curve) {
    const auto effort = quick_ ? study::Effort::kQuick : study::Effort::kFull;
    return CurveReport{scene_,
                       picture.size,
                       pin ? pinned_words(picture_, picture) : given_option_words(picture_),
                       study::current_origin(version_and_build(), effort, threads),
                       command(),
                       std::move(curve),
                       measure_second_eyes(scene, progress)};
  });
}

Result<void> StudySceneCommand::write_outputs(const CurveReport& report) const {
  if (csv_output_) {
    if (const auto written = write_text(*csv_output_, curve_csv(report)); !written) return written;
  }
  if (json_output_) {
    if (const auto written = write_json(*json_output_, curve_json(report)); !written)
      return written;
  }
  if (!page_) return {};
  return write_text_result(*page_, curve_page(report));
}

int StudySceneCommand::run() const {
  if (const auto legal = check_options(); !legal) return refuse(legal.error());
  Progress progress;
  const Result<Scene> scene = load_scene_argument(scene_, picture_, progress);
  if (!scene) return refuse(scene.error());
  const auto report = measure(*scene, progress);
  progress.done();
  if (!report) return refuse(report.error());
  if (const auto written = write_outputs(*report); !written) return refuse(written.error());
  if (json_output_ != "-" && csv_output_ != "-") {
    fmt::print("{}", curve_text(*report));
    if (page_) fmt::print("\n{}: open it in a browser\n", printable(*page_, kLongestMessage));
  }
  return report->curve.faults.empty() ? kSuccess : kFailure;
}

void add_scene_command(CLI::App& study, int& exit_code) {
  add_command<StudySceneCommand>(study, exit_code);
}

}  // namespace glassbox::study
