#include "app/views/layers_draw_command.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "app/options/choices.h"
#include "app/options/engine_options.h"
#include "app/options/output_options.h"
#include "app/options/scene_input.h"
#include "app/report/exit_codes.h"
#include "app/report/output.h"
#include "app/report/picture_output.h"
#include "app/report/progress.h"

#include <glassbox/base/printable.h>
#include <glassbox/images/read.h>
#include <glassbox/render/renderer.h>

namespace glassbox::app {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int kVisibleDifference = 8;  // of 255

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// The places of all samples in the world as a scene of points with the camera of the layers, for what asks scenes where they are.
Scene scene_of(const views::StoredLayers& layers) {
  const views::LayeredImage& image = layers.image;
  const Eigen::Matrix4d world_from_screen = image.camera.screen_from_world.inverse();
  Mesh mesh;
  for (int y = 0; y < image.camera.height; ++y) {
    for (int x = 0; x < image.camera.width; ++x) {
      const std::size_t place = image.place(x, y);
      for (std::uint32_t i = image.first[place]; i < image.first[place + 1]; ++i) {
        const Eigen::Vector4d at =
            world_from_screen * Eigen::Vector4d(x + 0.5, y + 0.5, double(image.depth[i]), 1);
        const Eigen::Vector3d p = at.hnormalized();
        mesh.points.push_back({.position = std::uint32_t(mesh.positions.size())});
        mesh.positions.emplace_back(float(p.x()), float(p.y()), float(p.z()));
      }
    }
  }
  Scene scene;
  scene.cameras = {layers.camera};
  if (mesh.points.empty()) return scene;
  scene.materials.emplace_back();
  scene.nodes.push_back({"", kNone, {}, {}});
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back({0, 0});
  return scene;
}

int largest_difference(const Rgba8& a, const Rgba8& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

}  // namespace

void LayersDrawCommand::add_to(CLI::App& layers, int& exit_code) {
  CLI::App& command = *layers.add_subcommand("draw", "warp layers to another view");
  command.footer(
      "Examples:\n"
      "  glassbox views layers draw room.ldi --eye 3,2.6,3 --look-at 0,1,0 -o beside.png\n"
      "  glassbox views layers draw room.ldi --eye 3,2.6,3 --look-at 0,1,0 -o beside.png --against "
      "room\n"
      "  glassbox views layers draw room.ldi -o same.png --splat point --order occlusion\n\n"
      "Without camera options it is the view that the layers were made from, whose picture they "
      "are\nbyte for byte.");
  command.add_option("FILE", file_, "layers, as glassbox views layers build writes them")
      ->required();
  command.add_option("-o,--output", output_, "image file, .png or .ppm; - is standard output")
      ->type_name("FILE|-")
      ->required();
  command
      .add_option_function<std::string>(
          "--size", [this](const std::string& text) { size_ = parse_size(text); },
          "of the picture [of the layers]")
      ->type_name("WxH");
  add_choice(command, "--order", drawing_.order,
             {{"depth", views::LayerOrder::kDepth}, {"occlusion", views::LayerOrder::kOcclusion}},
             "who stays at a pixel: the nearer, or the later in McMillan's order [depth]");
  add_choice(command, "--splat", drawing_.splat,
             {{"point", views::Splat::kPoint},
              {"three", views::Splat::kThree},
              {"projected", views::Splat::kProjected}},
             "how large a sample is: a pixel, 3 x 3, or what its pixel is from here [projected]");
  command
      .add_option_function<std::string>(
          "--holes", [this](const std::string& text) { holes_ = parse_background(text); },
          "where no sample is, as displayed, each 0 .. 1 [the background of the layers]")
      ->type_name("R,G,B");
  command
      .add_option("--threads", drawing_.threads,
                  fmt::format("1 .. {}; same bytes [1]", kMostThreads))
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
  command.add_option("--against", against_, "the scene, drawn from there: how far off it is")
      ->type_name("SCENE");
  add_camera_options(command, camera_);
  add_json_output(command, json_output_);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<View> LayersDrawCommand::choose_view(const views::StoredLayers& layers) const {
  const Size size = size_.value_or(Size{layers.image.camera.width, layers.image.camera.height});
  const double aspect = double(size.width) / double(size.height);
  const auto camera = choose_camera(scene_of(layers), camera_, aspect);
  if (!camera) return tl::unexpected(camera.error());
  return make_view(*camera, size.width, size.height);
}

Result<LayersDrawCommand::Against> LayersDrawCommand::compare(
    const views::LayerPicture& picture, const View& view, const views::StoredLayers& layers) const {
  const auto scene = load_asked_scene(*against_);
  if (!scene) return tl::unexpected(scene.error());
  RenderSettings settings;
  settings.background = layers.background;
  settings.want_distance = true;
  Renderer renderer(*scene, settings.transfer);
  renderer.render(view, settings);  // what is made once is not part of a picture's time
  const Clock::time_point start = Clock::now();
  const Framebuffer truth = renderer.render(view, settings).buffers;
  Against against;
  against.render_ms = ms_since(start);
  double squares = 0;
  for (std::size_t i = 0; i < truth.color.pixels.size(); ++i) {
    const Rgba8 &right = truth.color.pixels[i], &found = picture.color.pixels[i];
    against.wrong += largest_difference(right, found) > kVisibleDifference;
    against.missing += picture.depth.pixels[i] == 0 && std::isfinite(truth.distance.pixels[i]);
    for (const int d : {right.r - found.r, right.g - found.g, right.b - found.b}) {
      squares += double(d * d);
    }
  }
  const double mean = squares / (3 * double(truth.color.pixels.size()));
  against.psnr = 10 * std::log10(255.0 * 255.0 / mean);
  return against;
}

int LayersDrawCommand::run() {
  if (const auto good = check_picture_output(output_, {}, "layers.png"); !good)
    return refuse(good.error());
  std::vector<std::string> outputs;
  for (const auto& output : {std::optional(output_), json_output_}) {
    if (output && *output != "-") outputs.push_back(*output);
  }
  if (const auto good = check_outputs(outputs); !good) return refuse(good.error());
  Progress progress;
  progress.phase("reading " + file_);
  const auto bytes = read_file(file_);
  if (!bytes) return refuse(bytes.error());
  const auto layers = views::decode_layers(*bytes, file_);
  if (!layers) return refuse(layers.error());
  const auto view = choose_view(*layers);
  if (!view) return refuse(view.error());

  drawing_.background = holes_.value_or(layers->background);
  const Clock::time_point start = Clock::now();
  const views::LayerPicture picture =
      views::draw_layers(layers->image, views::layer_camera(*view), drawing_);
  const double warp_ms = ms_since(start);
  std::optional<Against> against;
  if (against_) {
    progress.phase("drawing " + scene_title(*against_));
    const auto compared = compare(picture, *view, *layers);
    if (!compared) return refuse(compared.error());
    against = *compared;
  }
  if (const auto written = write_picture(output_, {}, picture.color, {}); !written)
    return refuse(written.error());
  progress.done();

  const std::size_t pixels = picture.depth.pixels.size();
  const auto holes = std::size_t(std::ranges::count(picture.depth.pixels, 0.0f));
  const views::WarpCounts& counts = picture.counts;
  if (json_output_) {
    nlohmann::ordered_json json{{"picture", output_},
                                {"samples_drawn", counts.drawn},
                                {"samples_behind", counts.behind},
                                {"samples_beside", counts.beside},
                                {"splats_cut", counts.cut},
                                {"pixels", pixels},
                                {"pixels_without_sample", holes},
                                {"warp_ms", warp_ms}};
    if (against) {
      json["against"] = {{"scene", *against_},
                         {"psnr_db", against->psnr},
                         {"wrong_pixels", against->wrong},
                         {"holes", against->missing},
                         {"render_ms", against->render_ms}};
    }
    if (const auto written = write_json(*json_output_, json); !written)
      return refuse(written.error());
  }
  if (json_output_ == "-" || output_ == "-") return kSuccess;
  const auto percent = [&](std::size_t count) { return 100 * double(count) / double(pixels); };
  fmt::print("{}: {} samples drawn, {} beside the picture, {} behind the eye; {:.2f} ms\n",
             printable(output_, kLongestMessage), counts.drawn, counts.beside, counts.behind,
             warp_ms);
  if (counts.cut > 0)
    fmt::print("  {} samples are larger than {:g} px from here, and are drawn so large.\n",
               counts.cut, views::kLargestSplat);
  fmt::print("  {:.2f} % of the pixels have no sample.\n", percent(holes));
  if (against)
    fmt::print(
        "  Against {}: PSNR {:.1f} dB, {:.2f} % of the pixels differ by more than {}/255, {:.2f} % "
        "are\n  holes where it shows something; drawing it took {:.2f} ms\n",
        printable(*against_, kLongestMessage), against->psnr, percent(against->wrong),
        kVisibleDifference, percent(against->missing), against->render_ms);
  return kSuccess;
}

}  // namespace glassbox::app
