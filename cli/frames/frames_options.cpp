#include "cli/frames/frames_options.h"

#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/frames/path_file.h"
#include "cli/options/arguments.h"
#include "cli/report/output.h"

#include <glassbox/pipeline/number_text.h>

namespace glassbox {

namespace {

// Parses a parallax budget: one number for both sides of the window, or two numbers.
std::array<double, 2> parse_budget(const std::string& text) {
  const std::string name = "--parallax-budget";
  const bool both = text.find(',') == std::string::npos;
  const std::array<double, 2> budget =
      both ? std::array{parse_number(name, text), parse_number(name, text)}
           : parse_numbers<2>(name, text);
  for (const double percent : budget) {
    if (percent >= 0 && percent <= 100) continue;
    throw CLI::ValidationError(name,
                               fmt::format("needs a percentage from 0 to 100, not '{}'", text));
  }
  return budget;
}

double parse_at_least_zero(const std::string& name, const std::string& text) {
  const double number = parse_number(name, text);
  if (number >= 0 && std::isfinite(number)) return number;
  throw CLI::ValidationError(name, fmt::format("needs a number of at least 0, not '{}'", text));
}

constexpr const char* kFramesGroup = "Frames";

void add_frames_option(CLI::App& command, const std::string& name, const std::string& type,
                       const std::string& help,
                       const std::function<void(const std::string&)>& take) {
  command.add_option_function<std::string>(name, take, help)->type_name(type)->group(kFramesGroup);
}

// Stores the options that were added after the first `before` ones.
void note_frames_options(const CLI::App& command, std::size_t before, FramesOptions& frames) {
  const auto all = command.get_options();
  frames.options.assign(all.begin() + std::ptrdiff_t(before), all.end());
}

}  // namespace

void add_sequence_options(CLI::App& command, FramesOptions& frames) {
  const std::size_t before = command.get_options().size();
  add_frames_option(command, "--frames", "N|FIRST-LAST/N",
                    "render N pictures: FILE-0001.png and so on, or -o with %04d for the number, "
                    "or a directory; FIRST-LAST/N: only frames FIRST to LAST of N",
                    [&frames](const std::string& text) { frames.range = parse_frames(text); });
  add_frames_option(command, "--path", "FILE.json",
                    "the camera's path: keyframes (docs/stereo.md has the format)",
                    [&frames](const std::string& text) { frames.path = text; });
  command
      .add_flag("--turntable", frames.turntable,
                "move the camera once around the scene, all of it in view; the axis is --up "
                "through --look-at or the scene's centre")
      ->group(kFramesGroup);
  note_frames_options(command, before, frames);
}

void add_frames_options(CLI::App& command, FramesOptions& frames) {
  const std::size_t before = command.get_options().size();
  add_sequence_options(command, frames);
  const auto add = [&](const std::string& name, const std::string& type, const std::string& help,
                       const std::function<void(const std::string&)>& take) {
    add_frames_option(command, name, type, help, take);
  };
  add("--parallax-budget", "PERCENT[,PERCENT]",
      "largest parallax in front of the stereo window and behind it, in per cent of the width [3]",
      [&frames](const std::string& text) { frames.budget_percent = parse_budget(text); });
  add("--release-frames", "N",
      "number of frames in which the eyes slowly move apart again and the window follows [15]",
      [&frames](const std::string& text) {
        frames.release_frames = parse_at_least_zero("--release-frames", text);
      });
  add("--max-step", "S",
      "largest change of the eye separation per frame (world units) [the largest separation "
      "divided "
      "by --release-frames]",
      [&frames](const std::string& text) {
        frames.max_step = parse_at_least_zero("--max-step", text);
        if (frames.max_step == 0) {
          throw CLI::ValidationError("--max-step", "needs a number above 0, not '" + text + "'");
        }
      });
  add("--plot", "FILE.svg",
      "a plot of eye separation and parallax over the frames [named after the pictures]",
      [&frames](const std::string& text) { frames.plot = text; });
  note_frames_options(command, before, frames);
}

namespace {

Result<void> check_plot(const FramesOptions& frames) {
  if (!frames.plot) return {};
  if (frames.range->is_slice()) {
    return fail("--plot", "the plot needs all frames, but only some are drawn",
                "leave --plot out, or draw all frames");
  }
  return check_extension(*frames.plot, ".svg");
}

Result<void> check_pose(const CameraOptions& camera, const FramesOptions& frames) {
  if (frames.path && frames.turntable) {
    return fail("--turntable", "the path says where the camera stands",
                "leave out --turntable or --path");
  }
  if (frames.turntable) {
    if (!camera.camera || *camera.camera == "none") return {};
    return fail("--camera", "--turntable moves the camera around the scene",
                "leave --camera out; --eye says where the camera starts");
  }
  const bool posed = camera.camera || camera.eye || camera.look_at || camera.up;
  if (!posed) return {};
  const char* name = camera.camera    ? "--camera"
                     : camera.eye     ? "--eye"
                     : camera.look_at ? "--look-at"
                                      : "--up";
  return fail(name, "the path says where the camera stands", "leave out this option or --path");
}

}  // namespace

Result<void> check_frames_options(const PictureOptions& picture, bool for_two_eyes,
                                  const FramesOptions& frames) {
  for (const CLI::Option* option : frames.options) {
    if (option->count() == 0) continue;
    if (!frames.range)
      return fail(option->get_name(), "the number of frames is missing", "give --frames N");
    if (!frames.path && !frames.turntable) {
      return fail(option->get_name(), "the camera path is missing",
                  "give --path FILE.json, or --turntable");
    }
    const std::string& name = option->get_name();
    const bool of_any = name == "--frames" || name == "--path" || name == "--turntable";
    if (for_two_eyes || of_any) continue;
    return fail(name, "it is an option for pictures of two eyes",
                "give --stereo too, or leave it out");
  }
  if (!frames.requests_sequence()) return {};
  if (const auto legal = check_plot(frames); !legal) return legal;
  if (const auto legal = check_pose(picture.camera, frames); !legal) return legal;
  if (picture.eyes.seen_by) {
    return fail("--seen-by", "this option cannot be used with --frames",
                "use --stereo pair, which has both eyes' pictures at full size");
  }
  if (!for_two_eyes && (picture.eyes.separation || picture.eyes.window)) {
    return fail(picture.eyes.separation ? "--eye-separation" : "--window",
                "it is an option for pictures of two eyes", "give --stereo too, or leave it out");
  }
  const std::optional<double>& separation = picture.eyes.separation;
  if (separation && !(*separation >= 0 && std::isfinite(*separation))) {
    return fail("--eye-separation", "it is " + number_text(*separation),
                "give the largest eye separation, 0 or more");
  }
  const std::optional<double>& window = picture.eyes.window;
  if (window && !(*window > 0)) {
    return fail("--window", "it is " + number_text(*window) + ", not in front of the camera",
                "give a distance above 0, or auto");
  }
  if (window && std::isinf(*window) && !separation && for_two_eyes) {
    return fail("--window", "no eye separation can be derived from an infinite distance",
                "give --eye-separation");
  }
  return {};
}

Result<void> check_path_options(const PictureOptions& picture, const CameraPath& path) {
  const CameraOptions& camera = picture.camera;
  if (path.has_fov && (camera.fov_degrees || camera.ortho_height || camera.frustum)) {
    const char* name = camera.fov_degrees ? "--fov" : camera.ortho_height ? "--ortho" : "--frustum";
    return fail(name, "the path's keyframes already give the angle of view",
                "leave this option out, or remove the angles from the path");
  }
  if (path.has_window && picture.eyes.window) {
    return fail("--window", "the path's keyframes already give the window",
                "leave --window out, or remove the windows from the path");
  }
  return {};
}

}  // namespace glassbox
