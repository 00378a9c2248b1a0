#include "app/views/match_command.h"

#include <span>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/options/arguments.h"
#include "app/options/builtin_help.h"
#include "app/options/choices.h"
#include "app/options/engine_options.h"
#include "app/options/output_options.h"
#include "app/options/scene_input.h"
#include "app/report/exit_codes.h"
#include "app/report/output.h"
#include "app/report/progress.h"
#include "app/views/match_report.h"

#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox::app {

namespace {

using views::MatchingCost;

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
    throw CLI::ValidationError("--range", "needs two whole numbers of pixels, not '" + text + "'");
  }
  return {int(first), int(last)};
}

}  // namespace

void ViewsMatchCommand::add_settings_options(CLI::App& command) {
  const std::string group = "Matching";
  add_choice<std::string>(command, "--method", method_,
                          {{"default", "default"}, {"fast", "fast"}, {"winner", "winner"}},
                          "the settings to begin with; winner: each pixel for itself [default]")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--range", [this](const std::string& text) { range_ = parse_range(text); },
          "disparities to look at, px, both included [0,63; of a scene, those it has]")
      ->type_name("A,B")
      ->group(group);
  add_choice<std::optional<MatchingCost>>(
      command, "--cost", cost_,
      choices_of({MatchingCost::kSad, MatchingCost::kSsd, MatchingCost::kNcc, MatchingCost::kZncc,
                  MatchingCost::kCensus, MatchingCost::kAdCensus}),
      "what makes two pixels unlike [ad-census; fast: census; winner: sad]")
      ->group(group);
  add_value(command, "--cost-window", window_, "N", group,
            "side of the square that costs are averaged over, odd, 1 to 15 [1; winner: 11; ncc, "
            "zncc: 7]");
  add_value(command, "--adaptive", adaptive_, "N", group,
            "averages over crosses that stop where the colour changes, 0 to 4 [0]");
  add_value(command, "--paths", paths_, "N", group,
            "directions of semi-global matching: 2, 4, 8, 16; 0: none [8; fast: 4, of which it "
            "leaves out those from below; winner: 0]");
  add_value(command, "--left-right", left_right_, "PX", group,
            "how far the right picture's disparity may be off the left one's [1]");
  add_value(command, "--confidence", confidence_, "RATIO", group,
            "least (second - best) / second of the costs, 0 to 1 [0]");
  add_value(command, "--speckle", speckle_, "N", group, "pieces of fewer pixels are taken out [0]");
  command.add_flag("--no-check", no_check_, "leave out the left-right check")->group(group);
  command.add_flag("--no-subpixel", no_subpixel_, "whole disparities")->group(group);
  command.add_flag("--no-median", no_median_, "leave out the median")->group(group);
  command.add_flag("--no-fill", no_fill_, "leave out what is in doubt: +inf in the file")
      ->group(group);
  add_target_option(command, target_)->group(group);
  add_value(command, "--threads", threads_, "N", group, "threads; no byte depends on it [all]");
  add_value(command, "--max-mb", max_megabytes_, "N", group,
            fmt::format("refuse volumes of more megabytes [{}]", max_megabytes_));
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
          "focal length (px), baseline, and what is added to disparities (px) [the scene's own]")
      ->type_name("F,B,OFFSET")
      ->group(group);
  command
      .add_option("--depth-out", depth_output_,
                  "F B / (disparity + OFFSET), in the baseline's unit: a .pfm file")
      ->type_name("FILE")
      ->group(group);
  add_json_output(command, json_output_)->group(group);
}

void ViewsMatchCommand::add_to(CLI::App& views, int& exit_code) {
  CLI::App& command = *views.add_subcommand(
      "match", "the disparity of every pixel of two pictures, and how far it is off the truth");
  command.footer(
      "Examples:\n"
      "  glassbox views match --scene room --eye-separation 0.2 -o disparity.pfm\n"
      "  glassbox views match --scene forest --size 640x480 --method fast --json -\n"
      "  glassbox views match left.png right.png --range 0,63 -o disparity.pfm\n"
      "  glassbox views match im2.ppm im6.ppm --truth disp2.pgm --truth-scale 4\n\n"
      "The pictures are rectified: the point at (x, y) of LEFT is at (x - disparity, y) of RIGHT. "
      "Grey\nand 16-bit pictures are read as 8-bit colours.\n\n" +
      builtin_help());
  command.add_option("LEFT", sources_.left, "the left picture, a file");
  command.add_option("RIGHT", sources_.right, "the right picture, a file");
  const std::string group = "What is known";
  add_value(command, "--truth", sources_.truth, "FILE", group,
            "the left picture's disparities, grey or .pfm; 0 and +inf: unknown");
  add_value(command, "--truth-right", sources_.truth_right, "FILE", group,
            "the right picture's, which tell what it does not show of the left one");
  add_value(command, "--truth-scale", sources_.truth_scale, "S", group,
            "what the truth stores for a pixel of disparity [1]");
  command.add_option("--scene", sources_.scene, "draw the pair: " + std::string(kSceneHelp))
      ->type_name("SCENE")
      ->group(group);
  add_settings_options(command);
  add_output_options(command);
  add_picture_options(command, sources_.picture);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> ViewsMatchCommand::check_sources() const {
  const MatchSources& given = sources_;
  if (given.scene && (given.left || given.truth || given.truth_right || given.truth_scale)) {
    return fail("--scene", "the pair is drawn, and its truth is known",
                "leave out the files and --truth, or --scene");
  }
  if (given.scene && given.picture.eyes.seen_by) {
    return fail("--seen-by", "both eyes' pictures are matched", "leave it out");
  }
  if (given.scene) return {};
  if (!given.left || !given.right) {
    return fail("LEFT RIGHT", "two pictures are needed", "name their files, or give --scene");
  }
  if (const auto words = words_given(given.picture); !words.empty()) {
    return fail(words.front(), "this is of a pair that is drawn", "add --scene, or leave it out");
  }
  if (!given.truth && (given.truth_right || given.truth_scale)) {
    return fail(given.truth_right ? "--truth-right" : "--truth-scale",
                "there is no truth of the left picture", "give --truth as well");
  }
  if (given.truth_scale && !(*given.truth_scale > 0 && std::isfinite(*given.truth_scale))) {
    return fail("--truth-scale", fmt::format("{:g} is no scale", *given.truth_scale),
                "give a number above 0, such as 4");
  }
  if (depth_output_ && !calibration_) {
    return fail("--depth-out", "disparities have no depth without a focal length and a baseline",
                "give --calibration F,B,OFFSET");
  }
  return {};
}

Result<void> ViewsMatchCommand::check_outputs() const {
  std::vector<std::string> files;
  for (const auto& path : {output_, depth_output_}) {
    if (!path) continue;
    if (const auto legal = check_extension(*path, ".pfm"); !legal) return legal;
    files.push_back(*path);
  }
  if (json_output_ && *json_output_ != "-") files.push_back(*json_output_);
  return app::check_outputs(files);
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
  if (left_right_) settings.left_right = left_right_;
  if (no_check_) settings.left_right.reset();
  settings.confidence = confidence_.value_or(settings.confidence);
  settings.speckle = speckle_.value_or(settings.speckle);
  settings.subpixel = settings.subpixel && !no_subpixel_;
  settings.median = settings.median && !no_median_;
  settings.fill = settings.fill && !no_fill_;
  settings.target = target_;
  settings.threads = threads_;
  return settings;
}

Result<void> ViewsMatchCommand::write_outputs(const MatchInput& input,
                                              const views::DenseMatch& match) const {
  if (output_) {
    if (const auto written = write_file(*output_, encode_pfm(match.disparity)); !written) {
      return written;
    }
  }
  if (!depth_output_) return {};
  const views::Calibration calibration = calibration_ ? *calibration_ : *input.calibration;
  return write_file(*depth_output_, encode_pfm(views::depths_of(match.disparity, calibration)));
}

int ViewsMatchCommand::run() {
  for (const auto& legal : {check_sources(), check_outputs(),
                            calibration_ ? views::check_calibration(*calibration_) : Result<void>(),
                            threads_ < 0 || threads_ > kMostThreads
                                ? Result<void>(fail("--threads", "this is no number of threads",
                                                    "give 1 or more, or leave it out"))
                                : Result<void>()}) {
    if (!legal) return refuse(legal.error());
  }
  Progress progress;
  const Result<MatchInput> input = read_match_input(sources_, progress);
  if (!input) return refuse(input.error());
  const views::MatchSettings chosen = settings(*input);
  progress.phase("matching");
  const Result<views::DenseMatch> match =
      views::match_pictures(input->left, input->right, chosen, std::uint64_t(max_megabytes_) << 20);
  if (!match) return refuse(match.error());
  if (const auto written = write_outputs(*input, *match); !written) return refuse(written.error());
  if (json_output_) {
    const auto written = write_json(*json_output_, match_json(*input, chosen, *match));
    if (!written) return refuse(written.error());
  }
  progress.done();
  if (json_output_ != "-") fmt::print("{}", match_text(*input, chosen, *match));
  return kSuccess;
}

}  // namespace glassbox::app
