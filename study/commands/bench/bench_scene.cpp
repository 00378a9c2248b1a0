#include "study/commands/bench/bench_scene.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "cli/options/choices.h"
#include "cli/options/eyes_options.h"
#include "cli/options/picture_options.h"
#include "study/scenes/real_scenes.h"

#include <glassbox/mesh/formats/load.h>

namespace glassbox::study {

namespace {

// The directory with real meshes, next to the repository.
constexpr const char* kAssets = "../shared/assets";

std::string path_of(const RealScene& scene) {
  return (std::filesystem::path(kAssets) / scene.source).string();
}

// If no such file exists, the name may have been meant for a scene of the benchmark: adds the names
// of these scenes to the error.
Error with_bench_scenes(Error error, const std::string& name) {
  if (std::filesystem::path(name).has_extension()) return error;
  error.remedy += fmt::format("; the benchmark's are {}", fmt::join(all_bench_scenes(), ", "));
  return error;
}

Result<BenchScene> load_by_source(const std::string& name, const std::string& source,
                                  const Size& size) {
  if (study::is_bench_scene(source))
    return study::make_bench_scene(source, size.width, size.height);
  Result<Scene> scene = load_scene(source);
  if (!scene) return tl::unexpected(with_bench_scenes(scene.error(), source));
  PictureOptions picture;
  picture.size = size;
  const Result<ChosenView> chosen = choose_view(*scene, picture);
  if (!chosen) return tl::unexpected(chosen.error());
  return study::make_bench_scene(name, std::move(*scene), chosen->view);
}

Result<BenchScene> load_real_scene(const RealScene& known, const Size& size) {
  if (known.source.empty()) return study::make_real_scene(known.name, size.width, size.height);
  auto bench = load_by_source(std::string(known.name),
                              known.is_asset ? path_of(known) : std::string(known.source), size);
  if (bench) {
    bench->name = known.name;
    bench->settings.samples = known.samples;
  }
  return bench;
}

// Changes a scene that has one view so that both eyes are drawn into one picture: the left eye into
// the red channel, the right eye into the other channels.
Result<void> add_second_eye(BenchScene& bench) {
  if (bench.stereo) return {};
  const View centre = bench.passes.front().view;
  const auto chosen = choose_pair(bench.scene, centre, bench.settings, {}, std::nullopt);
  if (!chosen) return tl::unexpected(chosen.error());
  bench.stereo = study::BenchStereo{centre, chosen->pair};
  bench.passes = {{eye_view(centre, chosen->pair, Side::kLeft), {true, false, false, false}},
                  {eye_view(centre, chosen->pair, Side::kRight), {false, true, true, true}}};
  return {};
}

std::string lines_of(const auto& scenes) {
  std::string text;
  for (const auto& known : scenes) text += fmt::format("  {:<14}{}\n", known.name, known.stresses);
  return text;
}

}  // namespace

void add_bench_drawing(CLI::App& command, BenchDrawing& drawing) {
  command
      .add_option_function<std::string>(
          "--size", [&drawing](const std::string& text) { drawing.size = parse_size(text); },
          "size of the picture in pixels [1920x1080]")
      ->type_name("WxH");
  add_choice<std::optional<int>, int>(
      command, "--samples", drawing.samples, {{"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}, {"16", 16}},
      "samples per pixel [what the benchmark's scene asks for, else 1]");
  add_choice(command, "--stereo", drawing.anaglyph, {{"anaglyph", true}},
             "draw two eyes, each into its own colour channels");
}

std::vector<std::string> words_of(const BenchDrawing& drawing) {
  std::vector<std::string> words{"--size",
                                 fmt::format("{}x{}", drawing.size.width, drawing.size.height)};
  if (drawing.samples) words.insert(words.end(), {"--samples", std::to_string(*drawing.samples)});
  if (drawing.anaglyph) words.insert(words.end(), {"--stereo", "anaglyph"});
  return words;
}

Result<BenchScene> load_bench_scene(const std::string& name, const BenchDrawing& drawing) {
  const RealScene* known = study::find_real_scene(name);
  auto bench = known != nullptr ? load_real_scene(*known, drawing.size)
                                : load_by_source(name, name, drawing.size);
  if (!bench) return bench;
  bench->settings.want_depth = true;  // because the peers write depth too
  if (drawing.samples) bench->settings.samples = *drawing.samples;
  if (drawing.anaglyph) {
    if (const auto seen = add_second_eye(*bench); !seen) return tl::unexpected(seen.error());
  }
  return bench;
}

std::vector<std::string> all_bench_scenes() {
  std::vector<std::string> all;
  for (const study::BenchSceneName& known : study::bench_scene_names()) {
    all.emplace_back(known.name);
  }
  for (const RealScene& known : study::real_scenes()) all.emplace_back(known.name);
  return all;
}

std::optional<std::string> missing_asset(const std::string& name) {
  const RealScene* known = study::find_real_scene(name);
  if (known == nullptr || !known->is_asset) return std::nullopt;
  const std::string path = path_of(*known);
  std::error_code ignored;
  return std::filesystem::exists(path, ignored) ? std::nullopt : std::optional(path);
}

std::string bench_scene_help() {
  return "Scenes of the benchmark:\n" + lines_of(study::bench_scene_names()) +
         lines_of(study::real_scenes());
}

}  // namespace glassbox::study
