#include "study/commands/scene/pinned_camera.h"

#include <algorithm>
#include <limits>
#include <span>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <glassbox/base/trig.h>

namespace glassbox::study {

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

std::vector<std::string> pinned_words(const PictureOptions& given, const PictureOptions& pinned) {
  constexpr std::string_view kReplaced[] = {"--camera", "--eye",     "--look-at", "--up", "--fov",
                                            "--ortho",  "--frustum", "--near",    "--far"};
  std::vector<const CLI::Option*> kept;
  for (const CLI::Option* option : given.options) {
    if (std::ranges::find(kReplaced, option->get_name()) == std::end(kReplaced))
      kept.push_back(option);
  }
  std::vector<std::string> words = glassbox::words_of(kept);
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

}  // namespace glassbox::study
