#include "app/views/layers_build_command.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/options/builtin_help.h"
#include "app/options/output_options.h"
#include "app/options/scene_input.h"
#include "app/report/exit_codes.h"
#include "app/report/output.h"
#include "app/report/progress.h"
#include "views/layers/layer_builder.h"
#include "views/layers/layer_file.h"

#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>

namespace glassbox::app {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int kMostLayers = 255;

}  // namespace

void LayersBuildCommand::add_to(CLI::App& layers, int& exit_code) {
  CLI::App& command =
      *layers.add_subcommand("build", "peel a scene's surfaces from one view into a file");
  command.footer(
      "Examples:\n"
      "  glassbox views layers build room --size 300x300 -o room.ldi\n"
      "  glassbox views layers build forest --layers 4 -o forest.ldi --json -\n\n"
      "Each pass draws what the passes before have not shown, with the staged engine. Colours are "
      "those\nof the view that is peeled: a highlight stays where it is seen from there.\n\n" +
      builtin_help());
  command.add_option("SCENE", scene_, kSceneHelp)->required();
  command.add_option("-o,--output", output_, "the layers, .ldi")->type_name("FILE")->required();
  command.add_option("--layers", layers_, fmt::format("passes, 1 .. {} at most [10]", kMostLayers))
      ->type_name("N")
      ->check(CLI::Range(1, kMostLayers));
  add_picture_options(command, picture_);
  add_json_output(command, json_output_);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> LayersBuildCommand::check_asked(const Scene& scene) const {
  const RenderSettings& settings = picture_.settings;
  if (settings.wireframe)
    return fail("--wireframe", "layers are of surfaces, not of lines", "leave it out");
  if (settings.samples > 1)
    return fail("--samples", "a sample of a layer has one depth", "leave it out");
  if (settings.show != Show::kColor)
    return fail("--show", "layers are drawn in colours", "leave it out");
  for (const Mesh& mesh : scene.meshes) {
    const Material& material = scene.materials[mesh.material];
    if (material.alpha_mode == AlphaMode::kBlend)
      return fail(
          printable(scene_), "material \"" + printable(material.name) + "\" is seen through",
          "make its surfaces opaque or masked: a sample of a layer hides what is behind it");
  }
  return {};
}

int LayersBuildCommand::run() {
  if (const auto good = check_extension(output_, ".ldi"); !good) return refuse(good.error());
  std::vector<std::string> outputs{output_};
  if (json_output_ && *json_output_ != "-") outputs.push_back(*json_output_);
  if (const auto good = check_outputs(outputs); !good) return refuse(good.error());
  Progress progress;
  const auto scene = load_asked_scene(scene_, picture_, progress);
  if (!scene) return refuse(scene.error());
  if (const auto good = check_asked(*scene); !good) return refuse(good.error());
  const auto chosen = choose_view(*scene, picture_);
  if (!chosen) return refuse(chosen.error());

  progress.phase("peeling " + scene_title(scene_));
  const Clock::time_point start = Clock::now();
  const views::StoredLayers layers{
      chosen->camera, picture_.settings.background,
      views::build_layers(*scene, chosen->view, picture_.settings, layers_)};
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const std::vector<std::byte> bytes = views::encode_layers(layers);
  if (const auto written = write_file(output_, bytes); !written) return refuse(written.error());
  progress.done();

  const views::LayerCounts counts = views::count_layers(layers.image);
  const views::LayerCamera& camera = layers.image.camera;
  if (json_output_) {
    const nlohmann::ordered_json json{{"layers", output_},
                                      {"width", camera.width},
                                      {"height", camera.height},
                                      {"samples", counts.samples},
                                      {"covered_pixels", counts.covered},
                                      {"most_samples_of_a_pixel", counts.most},
                                      {"depth_complexity", counts.complexity()},
                                      {"bytes", bytes.size()},
                                      {"seconds", seconds}};
    if (const auto written = write_json(*json_output_, json); !written)
      return refuse(written.error());
  }
  if (json_output_ != "-") {
    fmt::print("{}: {} x {} pixels, {} samples, {} bytes\n", printable(output_, kLongestMessage),
               camera.width, camera.height, counts.samples, bytes.size());
    fmt::print("  depth complexity {:.2f} over {} covered pixels, at most {}; peeled in {:.2f} s\n",
               counts.complexity(), counts.covered, counts.most, seconds);
    if (counts.most == std::size_t(layers_))
      fmt::print("  Left out: what lies behind {} surfaces, if anything (--layers).\n", layers_);
  }
  return kSuccess;
}

}  // namespace glassbox::app
