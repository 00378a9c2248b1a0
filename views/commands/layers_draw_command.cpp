// glassbox views layers draw: draws a layered depth image from one or many other views, and reports
// the difference from the true picture.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/frames/frames_options.h"
#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/camera_options.h"
#include "cli/options/choices.h"
#include "cli/options/engine_options.h"
#include "cli/options/output_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/picture_output.h"
#include "cli/report/progress.h"
#include "views/commands/commands.h"
#include "views/commands/layers_drawing.h"
#include "views/layers/draw_layers.h"
#include "views/layers/layer_file.h"
#include "views/layers/second_eye_error.h"

#include <glassbox/base/elapsed.h>
#include <glassbox/base/printable.h>
#include <glassbox/base/processor_time.h>
#include <glassbox/images/read.h>

namespace glassbox::views {

class LayersDrawCommand {
public:
  void add_to(CLI::App& layers, int& exit_code);

private:
  struct Times {
    double median_ms = 0, lower_ms = 0;  // over `count` pictures; lower_ms is the lower quartile
    double processor_ms = 0;             // lower quartile of the time of all threads together
    int count = 1;
  };
  struct DrawnLayers {
    views::LayerPicture picture;
    Times times;
    std::optional<LayersComparison> against;
  };

  int run();
  Result<void> check_options() const;
  Result<DrawnLayers> draw(const views::StoredLayers& layers, Progress& progress);
  int run_frames(const views::StoredLayers& layers, Progress& progress);
  int report(const DrawnLayers& drawn) const;

  const CLI::App* command_ = nullptr;  // tells which options were given
  std::string file_;
  std::optional<std::string> output_, page_;
  std::optional<Size> size_;
  CameraOptions camera_;
  FramesOptions frames_;
  views::LayerDrawing drawing_;
  std::optional<Rgba8> holes_;
  std::optional<int> repeat_;
  std::optional<std::string> against_, json_output_;
};

namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

void LayersDrawCommand::add_to(CLI::App& layers, int& exit_code) {
  CLI::App& command =
      *layers.add_subcommand("draw", "draw layers from another view by warping them");
  command_ = &command;
  command.footer(
      "Examples:\n"
      "  glassbox views layers draw room.ldi --eye 3,2.6,3 --look-at 0,1,0 -o beside.png\n"
      "  glassbox views layers draw room.ldi --eye 3,2.6,3 --look-at 0,1,0 -o beside.png --against "
      "room\n"
      "  glassbox views layers draw room.ldi -o same.png --splat point --order occlusion\n"
      "  glassbox views layers draw room.ldi --frames 30 --path walk.json -o walk.png\n"
      "  glassbox views layers draw room.ldi --html room.html\n\n"
      "Without camera options the view is that from which the layers were made, and the picture "
      "has the\n"
      "same bytes as the scene drawn from there.");
  command.add_option("FILE", file_, "a file of layers, as glassbox views layers build writes it")
      ->required();
  command.add_option("-o,--output", output_, "image file, .png or .ppm; - is standard output")
      ->type_name("FILE|-");
  add_html_output(command, page_, "a page that shows the layers and draws them from any view");
  command
      .add_option_function<std::string>(
          "--size", [this](const std::string& text) { size_ = parse_size(text); },
          "size of the picture in pixels [that of the layers]")
      ->type_name("WxH");
  add_choice(command, "--order", drawing_.order,
             {{"depth", views::LayerOrder::kDepth}, {"occlusion", views::LayerOrder::kOcclusion}},
             "which sample is seen at a pixel: depth: the nearest one; occlusion: the last one in "
             "McMillan's order from back to front [depth]");
  add_choice(command, "--splat", drawing_.splat,
             {{"point", views::Splat::kPoint},
              {"three", views::Splat::kThree},
              {"projected", views::Splat::kProjected},
              {"soft", views::Splat::kSoft}},
             "size of a sample: one pixel, 3 x 3, its projected size, or the same with a "
             "transparent rim [projected]");
  command
      .add_option_function<std::string>(
          "--holes",
          [this](const std::string& text) { holes_ = parse_background(text, "--holes"); },
          "colour where there is no sample, as displayed, each channel 0 .. 1 [the background of "
          "the layers]")
      ->type_name("R,G,B");
  command
      .add_option(
          "--threads", drawing_.threads,
          fmt::format("number of threads, 1 .. {}; the bytes are the same [1]", kMaxThreads))
      ->type_name("N")
      ->check(CLI::Range(1, kMaxThreads));
  add_target_option(command, drawing_.target);
  constexpr int kMaxRepeats = 100000;
  command
      .add_option("--repeat", repeat_,
                  "draw the picture this many times, and print the median of the times")
      ->type_name("N")
      ->check(CLI::Range(1, kMaxRepeats));
  command
      .add_option("--against", against_,
                  "compare the picture with this scene drawn from the same view")
      ->type_name("SCENE");
  add_sequence_options(command, frames_);
  add_camera_options(command, camera_);
  add_json_output(command, json_output_);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> LayersDrawCommand::check_options() const {
  if (!output_ && !page_) return fail("-o", "no output is given", "name a picture, or give --html");
  if (drawing_.splat == views::Splat::kSoft && drawing_.order == views::LayerOrder::kDepth)
    return fail("--splat soft",
                "soft splats have transparent rims, so they must be drawn from back to front, but "
                "--order depth draws in any order",
                "give --order occlusion");
  if (frames_.requests_sequence()) {
    PictureOptions picture;
    picture.camera = camera_;
    if (const auto legal = check_frames_options(picture, false, frames_); !legal) return legal;
    for (const auto& [name, given] : {std::pair("--against", against_.has_value()),
                                      std::pair("--repeat", repeat_.has_value())}) {
      if (given)
        return fail(name, "this option is for one picture, but several frames are drawn",
                    "leave it out");
    }
    if (!output_ || *output_ == "-")
      return fail("-o", "several frames cannot go to standard output",
                  "name a file or a directory");
  } else if (output_) {
    if (const auto good = check_picture_output(*output_, {}, "layers.png"); !good) return good;
  }
  if (output_ == "-" && json_output_ == "-")
    return fail("--json -", "the picture goes to standard output already",
                "name a file for one of the two");
  if (page_) {
    if (const auto legal = check_extension(*page_, ".html"); !legal) return legal;
  }
  if (!output_) {
    for (const CLI::Option* option : command_->get_options()) {
      const std::string name = option->get_name();
      if (option->count() > 0 && name != "FILE" && name != "--html")
        return fail(name, "no picture is drawn without -o", "give -o");
    }
  }
  std::vector<std::string> outputs;
  for (const auto& output : {output_, page_, json_output_}) {
    const bool is_frames = output == output_ && frames_.requests_sequence();
    if (output && *output != "-" && !is_frames) outputs.push_back(*output);
  }
  return check_outputs(outputs);
}

Result<LayersDrawCommand::DrawnLayers> LayersDrawCommand::draw(const views::StoredLayers& layers,
                                                               Progress& progress) {
  std::optional<Scene> truth;
  if (against_) {
    auto scene = load_scene_argument(*against_);
    if (!scene) return tl::unexpected(scene.error());
    truth = std::move(*scene);
  }
  const auto view = LayersView(layers, camera_, size_).view();
  if (!view) return tl::unexpected(view.error());
  DrawnLayers drawn;
  views::LayerDrawer drawer(layers.image);
  std::vector<double> times, processor;
  progress.phase("drawing " + file_);
  for (int i = 0; i < repeat_.value_or(1); ++i) {
    const Clock::time_point start = Clock::now();
    const double worked = processor_ms();
    drawer.draw(views::layer_camera(*view), drawing_, drawn.picture);
    processor.push_back(processor_ms() - worked);
    times.push_back(elapsed_ms(start));
  }
  std::ranges::sort(times);
  std::ranges::sort(processor);
  drawn.times = {times[times.size() / 2], times[times.size() / 4], processor[times.size() / 4],
                 int(times.size())};
  if (!truth) return drawn;
  progress.phase("drawing " + scene_title(*against_));
  drawn.against = compare_with_scene(drawn.picture, *view, *truth, layers);
  return drawn;
}

int LayersDrawCommand::run_frames(const views::StoredLayers& layers, Progress& progress) {
  LayersFramesRequest frames{*output_, camera_, size_, frames_, drawing_};
  const auto written = draw_layer_frames(frames, layers, progress);
  if (!written) return refuse(written.error());
  progress.done();
  if (json_output_) {
    nlohmann::ordered_json json{{"layers", file_}, {"frames", nlohmann::ordered_json::array()}};
    for (const LayersFrame& frame : *written) {
      json["frames"].push_back({{"picture", frame.picture},
                                {"frame", frame.number},
                                {"pixels_without_sample", frame.holes},
                                {"warp_ms", frame.warp_ms}});
    }
    if (const auto told = write_json(*json_output_, json); !told) return refuse(told.error());
  }
  if (json_output_ == "-") return kSuccess;
  double total = 0;
  for (const LayersFrame& frame : *written) total += frame.warp_ms;
  fmt::print("{} to {}: {} frames, {:.2f} ms each\n",
             printable(written->front().picture, kLongestMessage),
             printable(written->back().picture, kLongestMessage), written->size(),
             total / double(written->size()));
  return kSuccess;
}

int LayersDrawCommand::run() {
  if (const auto good = check_options(); !good) return refuse(good.error());
  Progress progress;
  progress.phase("reading " + file_);
  const auto bytes = read_file(file_);
  if (!bytes) return refuse(bytes.error());
  const auto layers = views::decode_layers(*bytes, file_);
  if (!layers) return refuse(layers.error());
  drawing_.background = holes_.value_or(layers->background);
  // All results are computed before the first file is written, except frames, which are too many to
  // be kept.
  Result<std::string> page;
  if (page_) {
    progress.phase("making " + *page_);
    page = make_layers_page(*layers, file_);
    if (!page) return refuse(page.error());
  }
  int exit_code = kSuccess;
  if (frames_.requests_sequence()) {
    exit_code = run_frames(*layers, progress);
  } else if (output_) {
    const auto drawn = draw(*layers, progress);
    if (!drawn) return refuse(drawn.error());
    const auto written = write_picture(*output_, {}, drawn->picture.color, {});
    if (!written) return refuse(written.error());
    progress.done();
    exit_code = report(*drawn);
  }
  progress.done();
  if (!page_ || exit_code != kSuccess) return exit_code;
  if (const auto written = write_text(*page_, *page); !written) return refuse(written.error());
  if (json_output_ != "-" && output_ != "-")
    fmt::print("{}: open it in a browser\n", printable(*page_, kLongestMessage));
  return exit_code;
}

int LayersDrawCommand::report(const DrawnLayers& drawn) const {
  const views::LayerPicture& picture = drawn.picture;
  const Times& times = drawn.times;
  const std::size_t pixels = picture.depth.pixels.size();
  const auto holes = std::size_t(std::ranges::count(picture.depth.pixels, 0.0f));
  const views::WarpCounts& counts = picture.counts;
  if (json_output_) {
    nlohmann::ordered_json json{{"picture", *output_},
                                {"samples_drawn", counts.drawn},
                                {"samples_behind", counts.behind},
                                {"samples_beside", counts.outside},
                                {"splats_cut", counts.oversized},
                                {"pixels", pixels},
                                {"pixels_without_sample", holes},
                                {"target", name_of(drawing_.target)},
                                {"threads", drawing_.threads},
                                {"warp_ms", times.median_ms},
                                {"warp_ms_lower_quartile", times.lower_ms},
                                {"processor_ms_lower_quartile", times.processor_ms},
                                {"times", times.count}};
    if (const auto& against = drawn.against) {
      nlohmann::ordered_json psnr;  // null if both pictures are equal
      if (std::isfinite(against->psnr)) psnr = against->psnr;
      json["against"] = {{"scene", *against_},
                         {"psnr_db", psnr},
                         {"wrong_pixels", against->wrong},
                         {"holes", against->missing},
                         {"interior_holes", against->interior},
                         {"render_ms", against->render_ms}};
    }
    if (const auto written = write_json(*json_output_, json); !written)
      return refuse(written.error());
  }
  if (json_output_ == "-" || output_ == "-") return kSuccess;
  const auto percent = [&](std::size_t count) { return 100 * double(count) / double(pixels); };
  fmt::print("{}: {} samples drawn, {} outside the picture, {} behind the eye; {:.2f} ms\n",
             printable(*output_, kLongestMessage), counts.drawn, counts.outside, counts.behind,
             times.median_ms);
  if (times.count > 1)
    fmt::print(
        "  {} times: {:.0f} pictures per second (median), {:.0f} in the fastest quarter; there "
        "{:.3f} ms of processor time\n",
        times.count, 1000 / times.median_ms, 1000 / times.lower_ms, times.processor_ms);
  if (counts.oversized > 0)
    fmt::print("  {} samples would be larger than {:g} px, and are drawn at that size.\n",
               counts.oversized,
               drawing_.splat == views::Splat::kSoft ? 7.0 : double(views::kLargestSplat));
  fmt::print("  {:.2f} % of the pixels have no sample.\n", percent(holes));
  if (const auto& against = drawn.against)
    fmt::print(
        "  Compared with {}: PSNR {:.1f} dB, {:.2f} % of the pixels differ by more than {}/255, "
        "{:.2f} % are\n"
        "  holes where it shows something, {:.3f} % are holes within a surface; drawing it took "
        "{:.2f} ms\n",
        printable(*against_, kLongestMessage), against->psnr, percent(against->wrong),
        views::kVisibleDifference, percent(against->missing), percent(against->interior),
        against->render_ms);
  return kSuccess;
}

void add_layers_draw_command(CLI::App& views, int& exit_code) {
  add_command<LayersDrawCommand>(views, exit_code);
}

}  // namespace glassbox::views
