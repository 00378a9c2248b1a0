#include "cli/frames/shots.h"

#include <algorithm>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <glassbox/pipeline/number_text.h>

namespace glassbox {

namespace {

// The options, with their camera replaced by the shot's.
PictureOptions options_for(const PictureOptions& picture, const CameraAt& at) {
  PictureOptions own = picture;
  own.camera.camera.reset();
  own.camera.eye = at.eye;
  own.camera.look_at = at.look_at;
  own.camera.up = at.up;
  if (at.fov_degrees) own.camera.fov_degrees = at.fov_degrees;
  return own;
}

Result<void> aim(const Scene& scene, const PictureOptions& own, Shot& shot) {
  return choose_view(scene, own).map([&](const ChosenView& chosen) {
    shot.camera = chosen.camera;
    shot.centre = chosen.view;
  });
}

// Asks for the pair with separation zero, because this gives the automatic window without further
// checks.
Result<void> aim_eyes(const Scene& scene, const PictureOptions& picture, PictureOptions own,
                      const CameraPath& path, Shot& shot) {
  own.eyes.separation = 0;
  own.eyes.window.reset();
  return choose_eyes(scene, own).map([&](const ChosenEyes& chosen) {
    shot.camera = chosen.camera;
    shot.centre = chosen.centre;
    const double looked_at = chosen.eyes.pair.window;
    shot.window = path.has_window ? window_at(path, shot.time, looked_at)
                                  : picture.eyes.window.value_or(looked_at);
  });
}

std::string comma_separated(const std::array<double, 3>& triple) {
  return number_text(triple[0]) + "," + number_text(triple[1]) + "," + number_text(triple[2]);
}

}  // namespace

Result<std::vector<Shot>> make_shots(const Scene& scene, const PictureOptions& picture,
                                     const CameraPath& path,
                                     const std::optional<Turntable>& turntable,
                                     const FrameRange& range, bool stereo) {
  std::vector<Shot> shots;
  for (int number = range.first; number <= range.last; ++number) {
    Shot shot{number, turntable ? number : time_of_frame(path, number, range.count), {}, {}, {}, 0};
    shot.at = turntable ? turntable->camera(number, range.count) : camera_at(path, shot.time);
    const PictureOptions own = options_for(picture, shot.at);
    const Result<void> aimed =
        stereo ? aim_eyes(scene, picture, own, path, shot) : aim(scene, own, shot);
    if (!aimed) {
      const Error& error = aimed.error();
      return fail(fmt::format("frame {}", number),
                  error.place.empty() ? error.cause : error.place + ": " + error.cause,
                  error.remedy);
    }
    shots.push_back(std::move(shot));
  }
  return shots;
}

std::vector<std::string> words_for(const Shot& shot, const StereoPair* pair,
                                   const std::vector<const CLI::Option*>& options) {
  const std::vector<std::string> replaced{"--eye-separation", "--window", "--camera", "--eye",
                                          "--look-at",        "--up"};
  std::vector<const CLI::Option*> kept;
  for (const CLI::Option* option : options) {
    if (std::ranges::find(replaced, option->get_name()) == replaced.end()) kept.push_back(option);
  }
  std::vector<std::string> words = words_of(kept);
  const auto add = [&words](const char* name, const std::string& value) {
    words.insert(words.end(), {name, value});
  };
  add("--eye", comma_separated(shot.at.eye));
  add("--look-at", comma_separated(shot.at.look_at));
  add("--up", comma_separated(shot.at.up));
  if (shot.at.fov_degrees) add("--fov", number_text(*shot.at.fov_degrees));
  if (pair != nullptr) {
    add("--eye-separation", number_text(2 * pair->half_separation));
    add("--window", number_text(pair->window));
  }
  return words;
}

}  // namespace glassbox
