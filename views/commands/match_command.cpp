// glassbox views match: finds for each point how far apart two pictures show it (the disparity).
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/builtin_help.h"
#include "cli/options/choices.h"
#include "cli/options/engine_options.h"
#include "cli/options/output_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"
#include "views/commands/commands.h"
#include "views/commands/match_input.h"
#include "views/commands/match_report.h"
#include "views/commands/rectified_pair.h"
#include "views/matching/match.h"
#include "views/matching/surface.h"

#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox::views {

class ViewsMatchCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  void add_settings_options(CLI::App& command);
  void add_output_options(CLI::App& command);
  int run();
  Result<void> check_sources() const;
  Result<void> check_outputs() const;
  Result<void> check_rectified() const;
  Result<void> check_depth(const MatchInput& input) const;
  Result<void> write_maps(const MatchInput& input, const views::DenseMatch& match) const;
  Result<std::string> write_surface(const MatchInput& input, const views::DenseMatch& match) const;
  Result<void> write_page(const MatchInput& input, const views::DenseMatch& match,
                          const nlohmann::ordered_json& json) const;
  std::string command_line() const;
  views::MatchSettings settings(const MatchInput& input) const;

  MatchSources sources_;
  std::string method_ = "default";
  std::optional<views::MatchingCost> cost_;
  std::optional<int> window_, adaptive_, paths_, planes_, left_right_, speckle_;
  std::optional<float> confidence_;
  std::optional<views::DisparityRange> range_;
  std::optional<views::Calibration> calibration_;
  bool no_fill_ = false, no_subpixel_ = false, no_median_ = false, no_smooth_ = false,
       no_check_ = false;
  Target target_ = best_target();
  int threads_ = 0;
  std::uint32_t max_megabytes_ = 4096;
  std::optional<std::string> output_, depth_output_, surface_output_, json_output_, page_;
  std::pair<std::string, std::string> rectified_output_;
  std::vector<const CLI::Option*> options_;  // options to repeat in the report's command line
};

namespace {

template <class Value>
void add_value(CLI::App& command, const std::string& name, Value& value, const std::string& type,
               const std::string& group, const std::string& help) {
  command.add_option(name, value, help)->type_name(type)->group(group);
}

views::DisparityRange parse_range(const std::string& text) {
  const auto [first, last] = parse_numbers<2>("--range", text);
  constexpr double kFarthest = 1e6;
  if (!(first == double(std::int64_t(std::clamp(first, -kFarthest, kFarthest))) &&
        last == double(std::int64_t(std::clamp(last, -kFarthest, kFarthest))))) {
    throw CLI::ValidationError(
        "--range",
        "needs two whole numbers of pixels from -1000000 to 1000000, not '" + text + "'");
  }
  return {int(first), int(last)};
}

// The command line that draws the surface from the left picture's camera.
std::string drawn_by(const std::string& path, const views::SurfaceView& view, int width,
                     int height) {
  return shell_line({{"render", path, "--size", fmt::format("{}x{}", width, height), "--eye",
                      "0,0,0", "--look-at", "0,0,-1", "--near", fmt::format("{:.6g}", view.near),
                      "--far", fmt::format("{:.6g}", view.far),
                      fmt::format("--frustum={:.6g},{:.6g},{:.6g},{:.6g}", view.left, view.right,
                                  view.bottom, view.top),
                      "--shade", "unlit", "-o", "again.png"}});
}

}  // namespace

void ViewsMatchCommand::add_settings_options(CLI::App& command) {
  const std::string group = "Matching";
  add_choice<std::string>(
      command, "--method", method_,
      {{"default", "default"}, {"fast", "fast"}, {"winner", "winner"}},
      "the settings to start from; winner: each pixel is matched by itself [default]")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--range", [this](const std::string& text) { range_ = parse_range(text); },
          "disparities to search, in px, A and B included [0,63; for a scene, those that occur]")
      ->type_name("A,B")
      ->group(group);
  add_choice<std::optional<MatchingCost>>(
      command, "--cost", cost_,
      choices_of({MatchingCost::kSad, MatchingCost::kSsd, MatchingCost::kNcc, MatchingCost::kZncc,
                  MatchingCost::kCensus, MatchingCost::kAdCensus}),
      "measure of how different two pixels are [ad-census; with --method fast: census; with "
      "--method winner: sad]")
      ->group(group);
  add_value(command, "--cost-window", window_, "N", group,
            "side of the square that costs are averaged over, in px, odd, 1 to 15 [1; with "
            "--method winner: 11; with --cost ncc or zncc: 7]");
  add_value(command, "--adaptive", adaptive_, "N", group,
            "rounds of averaging over crosses that end where the colour changes, 0 to 4 [0]");
  add_value(command, "--paths", paths_, "N", group,
            "number of directions of semi-global matching: 2, 4, 8 or 16; 0: none [8; with "
            "--method fast: 4, none from below; with --method winner: 0]");
  add_value(command, "--planes", planes_, "N", group,
            "rounds of refinement with slanted planes, for fractions of a pixel, 0 to 8 [0]");
  add_value(command, "--left-right", left_right_, "PX", group,
            "largest difference between the disparities of the left and the right picture, in px; "
            "pixels with more are uncertain [1]");
  add_value(command, "--confidence", confidence_, "RATIO", group,
            "leave out pixels whose two lowest costs differ by less than this: (second - best) / "
            "second, 0 to 1 [0]");
  add_value(command, "--speckle", speckle_, "N", group,
            "remove connected regions of disparity with fewer pixels than this [0]");
  command.add_flag("--no-check", no_check_, "leave out the left-right check")->group(group);
  command.add_flag("--no-subpixel", no_subpixel_, "only whole disparities")->group(group);
  command.add_flag("--no-median", no_median_, "leave out the median filter")->group(group);
  command.add_flag("--no-smooth", no_smooth_, "leave out the averaging of fractions of a pixel")
      ->group(group);
  command.add_flag("--no-fill", no_fill_, "leave uncertain pixels empty: +inf in the file")
      ->group(group);
  add_target_option(command, target_)->group(group);
  add_value(command, "--threads", threads_, "N", group,
            "number of threads; the result is always the same [one for each processor]");
  add_value(command, "--max-mb", max_megabytes_, "N", group,
            fmt::format("most memory, in megabytes, for cost volumes; larger ones are refused [{}]",
                        max_megabytes_));
}

void ViewsMatchCommand::add_output_options(CLI::App& command) {
  const std::string group = "Outputs";
  command
      .add_option("-o,--output", output_, "disparities, px: a .pfm file, +inf where there is none")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--calibration",
          [this](const std::string& text) {
            const auto [focal, baseline, offset] = parse_numbers<3>("--calibration", text);
            calibration_ = {focal, baseline, offset};
          },
          "focal length (px), baseline, and offset that is added to disparities (px) [the scene's "
          "own]")
      ->type_name("F,B,OFFSET")
      ->group(group);
  command
      .add_option("--ply", surface_output_,
                  "the points in space with the left picture's colours, joined to a surface: a "
                  ".ply file, which render draws")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option(
          "--rectified-out", rectified_output_,
          "both pictures as rectified by --cameras: .png, transparent where they show nothing")
      ->type_name("FILE FILE")
      ->group(group);
  add_html_output(command, page_,
                  "a page with pictures, maps of disparity and error, each pixel's costs, and the "
                  "points in space")
      ->group(group);
  command
      .add_option("--depth-out", depth_output_,
                  "depths F B / (disparity + OFFSET) by --calibration, in the unit of the baseline "
                  "B: a .pfm file")
      ->type_name("FILE")
      ->group(group);
  add_json_output(command, json_output_)->group(group);
}

void ViewsMatchCommand::add_to(CLI::App& views, int& exit_code) {
  CLI::App& command = *views.add_subcommand(
      "match",
      "find the disparity of every pixel of two pictures, and its error if the truth is known");
  command.footer(
      "Examples:\n"
      "  glassbox views match --scene room --eye-separation 0.2 -o disparity.pfm\n"
      "  glassbox views match --scene forest --size 640x480 --method fast --json -\n"
      "  glassbox views match left.png right.png --range 0,63 -o disparity.pfm\n"
      "  glassbox views match im2.ppm im6.ppm --truth disp2.pgm --truth-scale 4\n"
      "  glassbox views match left.png right.png --cameras cameras.txt --range -20,60 --html "
      "page.html\n"
      "  glassbox views match --scene room --eye-separation 0.2 --ply room.ply\n\n"
      "LEFT and RIGHT must be rectified already, or be rectified by --cameras: then the point at "
      "(x, y)\n"
      "of LEFT is at (x - disparity, y) of RIGHT. Grey and 16-bit pictures are read as 8-bit "
      "colours.\n\n" +
      builtin_help());
  command.add_option("LEFT", sources_.left, "the left picture, a file");
  command.add_option("RIGHT", sources_.right, "the right picture, a file");
  const std::string group = "What is known";
  add_value(command, "--truth", sources_.truth, "FILE", group,
            "the left picture's true disparities, a grey picture or .pfm; 0 and +inf: unknown");
  add_value(command, "--truth-right", sources_.truth_right, "FILE", group,
            "the right picture's true disparities, which show what is hidden in it");
  add_value(command, "--truth-scale", sources_.truth_scale, "S", group,
            "value that the files of the truth store for a disparity of one pixel [1]");
  command
      .add_option("--cameras", sources_.cameras,
                  "for pictures that are not rectified: their cameras, as views geometry reads "
                  "them, by which the pictures are rectified")
      ->type_name("FILE")
      ->group(group);
  command.add_option("--scene", sources_.scene, "draw the pair: " + std::string(kSceneHelp))
      ->type_name("SCENE")
      ->group(group);
  const std::size_t before = command.get_options().size();
  add_settings_options(command);
  const auto all = command.get_options();
  options_.assign(all.begin() + std::ptrdiff_t(before), all.end());
  add_output_options(command);
  add_picture_options(command, sources_.picture);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> ViewsMatchCommand::check_sources() const {
  const MatchSources& given = sources_;
  if (given.scene &&
      (given.left || given.truth || given.truth_right || given.truth_scale || given.cameras)) {
    return fail("--scene", "this option draws the pair, so the files and the truth are not needed",
                "leave out the files, --truth and --cameras, or --scene");
  }
  if (given.scene && given.picture.eyes.seen_by) {
    return fail("--seen-by", "the pictures of both eyes are matched, so one eye cannot be chosen",
                "leave it out");
  }
  if (given.scene) return {};
  if (!given.left || !given.right) {
    return fail("LEFT RIGHT", "two pictures are needed", "name their files, or give --scene");
  }
  if (const auto words = given_option_words(given.picture); !words.empty()) {
    return fail(words.front(), "it is only for a pair that --scene draws",
                "add --scene, or leave this option out");
  }
  if (!given.truth && (given.truth_right || given.truth_scale)) {
    return fail(given.truth_right ? "--truth-right" : "--truth-scale",
                "the truth of the left picture is missing", "give --truth too");
  }
  if (given.truth_scale && !(*given.truth_scale > 0 && std::isfinite(*given.truth_scale))) {
    return fail("--truth-scale", fmt::format("{:g} is not a possible scale", *given.truth_scale),
                "give a number above 0, such as 4");
  }
  for (const auto& [name, output] :
       {std::pair{"--depth-out", &depth_output_}, std::pair{"--ply", &surface_output_}}) {
    if (*output && !calibration_ && !given.cameras) {
      return fail(name, "depth needs a focal length and a baseline",
                  "give --calibration F,B,OFFSET");
    }
  }
  return {};
}

Result<void> ViewsMatchCommand::check_rectified() const {
  const bool is_asked = !rectified_output_.first.empty();
  if (!sources_.cameras) {
    return is_asked ? fail("--rectified-out",
                           "the pictures are rectified with their cameras, which are not given",
                           "give --cameras, or leave this option out")
                    : Result<void>();
  }
  if (sources_.truth) {
    return fail("--truth",
                "the truth belongs to the pictures as they are, but --cameras rectifies them",
                "leave out one of the two options");
  }
  if (calibration_) {
    return fail("--calibration",
                "--cameras already gives the calibration of the rectified pictures",
                "leave out one of the two options");
  }
  return {};
}

Result<void> ViewsMatchCommand::check_outputs() const {
  return Outputs()
      .file(output_, ".pfm")
      .file(depth_output_, ".pfm")
      .file(surface_output_, ".ply")
      .file(page_, ".html")
      .files(rectified_output_, ".png")
      .data(json_output_)
      .check();
}

Result<void> ViewsMatchCommand::check_depth(const MatchInput& input) const {
  if (input.calibration || (!depth_output_ && !surface_output_)) return {};
  return fail("--eye-separation", "both eyes are in one place, so no depth can be found",
              "give a separation above 0");
}

views::MatchSettings ViewsMatchCommand::settings(const MatchInput& input) const {
  views::MatchSettings settings = *views::settings_named(method_);
  if (input.is_textured) settings.range = range_of(*input.truth);
  if (range_) settings.range = *range_;
  settings.cost = cost_.value_or(settings.cost);
  const bool correlation =
      settings.cost == MatchingCost::kNcc || settings.cost == MatchingCost::kZncc;
  settings.window = window_.value_or(correlation ? 7 : settings.window);
  settings.adaptive = adaptive_.value_or(settings.adaptive);
  settings.paths = paths_.value_or(settings.paths);
  settings.planes = planes_.value_or(settings.planes);
  if (left_right_) settings.left_right = left_right_;
  if (no_check_) settings.left_right.reset();
  settings.confidence = confidence_.value_or(settings.confidence);
  settings.speckle = speckle_.value_or(settings.speckle);
  settings.subpixel = settings.subpixel && !no_subpixel_;
  settings.median = settings.median && !no_median_;
  settings.smooth = settings.smooth && !no_smooth_;
  settings.fill = settings.fill && !no_fill_;
  settings.target = target_;
  settings.threads = threads_;
  settings.keep_sums = page_ && has_room_for_sums(input, settings.range);
  return settings;
}

Result<void> ViewsMatchCommand::write_maps(const MatchInput& input,
                                           const views::DenseMatch& match) const {
  if (output_) {
    if (const auto written = write_file(*output_, encode_pfm(match.disparity)); !written) {
      return written;
    }
  }
  if (!rectified_output_.first.empty()) {
    const auto written =
        write_rectified(rectified_output_, {*input.rectification, input.left, input.right});
    if (!written) return written;
  }
  if (!depth_output_) return {};
  return write_file(*depth_output_,
                    encode_pfm(views::depths_of(match.disparity, *input.calibration)));
}

// Writes the surface. Returns a line about it for the report.
Result<std::string> ViewsMatchCommand::write_surface(const MatchInput& input,
                                                     const views::DenseMatch& match) const {
  if (!surface_output_) return std::string();
  const views::Surface surface = views::surface_of(input.left, match.disparity, *input.calibration);
  const int width = input.left.width, height = input.left.height;
  const auto view = views::view_of(surface, *input.calibration, width, height);
  if (!view) return tl::unexpected(view.error());
  const auto written =
      write_file(*surface_output_, views::encode_ply(surface, "left camera at 0, gaze -z, y up"));
  if (!written) return tl::unexpected(written.error());
  return fmt::format("\n{}: {} points, {} triangles; from the left camera\n  {}\n",
                     printable(*surface_output_, kLongPath), surface.vertices.size(),
                     surface.triangles.size(), drawn_by(*surface_output_, *view, width, height));
}

// The command line that makes this page again.
std::string ViewsMatchCommand::command_line() const {
  const MatchSources& given = sources_;
  std::vector<std::string> files;
  if (given.left) files = {*given.left, *given.right};
  const auto add = [&](const char* name, const std::optional<std::string>& value) {
    if (value) files.insert(files.end(), {name, *value});
  };
  add("--truth", given.truth);
  add("--truth-right", given.truth_right);
  if (given.truth_scale) add("--truth-scale", fmt::format("{:g}", *given.truth_scale));
  add("--cameras", given.cameras);
  add("--scene", given.scene);
  if (calibration_) {
    add("--calibration", fmt::format("{},{},{}", calibration_->focal_px, calibration_->baseline,
                                     calibration_->offset_px));
  }
  return shell_line({{"views", "match"},
                     files,
                     option_words(options_),
                     given_option_words(given.picture),
                     {"--html", *page_}});
}

Result<void> ViewsMatchCommand::write_page(const MatchInput& input, const views::DenseMatch& match,
                                           const nlohmann::ordered_json& json) const {
  if (!page_) return {};
  return write_text_result(
      *page_, make_match_page(input, match, json, {"glassbox " GLASSBOX_VERSION, command_line()}));
}

int ViewsMatchCommand::run() {
  for (const auto& legal :
       {check_sources(), check_rectified(), check_outputs(),
        calibration_ ? views::check_calibration(*calibration_) : Result<void>(),
        threads_ < 0 || threads_ > kMaxThreads
            ? Result<void>(fail("--threads", "the number of threads must be at least 1",
                                "give 1 or more, or leave it out"))
            : Result<void>()}) {
    if (!legal) return refuse(legal.error());
  }
  Progress progress;
  Result<MatchInput> input = read_match_input(sources_, progress);
  if (!input) return refuse(input.error());
  if (calibration_) input->calibration = calibration_;
  if (const auto legal = check_depth(*input); !legal) return refuse(legal.error());
  if (page_) {
    if (const auto legal = check_match_page(*input); !legal) return refuse(legal.error());
  }
  const views::MatchSettings chosen = settings(*input);
  progress.phase("matching");
  const Result<views::DenseMatch> match =
      views::match_pictures(input->left, input->right, chosen, std::uint64_t(max_megabytes_) << 20);
  if (!match) return refuse(match.error());
  progress.phase("writing the results");
  const Result<std::string> surface = write_surface(*input, *match);
  if (!surface) return refuse(surface.error());
  if (const auto written = write_maps(*input, *match); !written) return refuse(written.error());
  const nlohmann::ordered_json json = match_json(*input, chosen, *match);
  if (const auto written = write_page(*input, *match, json); !written) {
    return refuse(written.error());
  }
  if (json_output_) {
    const auto written = write_json(*json_output_, json);
    if (!written) return refuse(written.error());
  }
  progress.done();
  if (json_output_ == "-") return kSuccess;
  fmt::print("{}{}", match_text(*input, chosen, *match), *surface);
  if (page_) fmt::print("\n{}: open it in a browser\n", printable(*page_, kLongPath));
  return kSuccess;
}

void add_match_command(CLI::App& views, int& exit_code) {
  add_command<ViewsMatchCommand>(views, exit_code);
}

}  // namespace glassbox::views
