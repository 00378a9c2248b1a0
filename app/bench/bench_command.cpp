#include "app/bench/bench_command.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/bench/json.h"
#include "app/bench/page.h"
#include "app/bench/text.h"
#include "app/options/builtin_help.h"
#include "app/options/choices.h"
#include "app/options/engine_options.h"
#include "app/options/output_options.h"
#include "app/options/picture_options.h"
#include "app/report/exit_codes.h"
#include "app/report/output.h"
#include "app/report/progress.h"
#include "study/bench/machine.h"
#include "study/bench/peer_process.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/mesh/formats/load.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox::app {

namespace {

using study::BenchScene;
using study::PeerProcess;
using study::ScaledBy;

constexpr const char* kPeerCommand = "bench-peer";
constexpr int kMostThreads = 256, kMostFrames = 100000;

std::string scene_help() {
  std::string text = "Scenes of the benchmark:\n";
  for (const study::BenchSceneName& known : study::bench_scene_names()) {
    text += fmt::format("  {:<14}{}\n", known.name, known.stresses);
  }
  return text;
}

bool is_bench_scene(const std::string& name) {
  return std::ranges::any_of(study::bench_scene_names(), [&](const auto& known) {
    return CLI::detail::to_lower(std::string(known.name)) == CLI::detail::to_lower(name);
  });
}

std::vector<int> parse_threads(const std::string& text) {
  std::vector<int> all;
  for (const std::string& word : CLI::detail::split(text, ',')) {
    int threads = 0;
    const bool number = CLI::detail::lexical_cast(word, threads);
    if (!number || threads < 1 || threads > kMostThreads) {
      throw CLI::ValidationError("--threads",
                                 fmt::format("needs numbers from 1 to {}, such as 1,2; not '{}'",
                                             kMostThreads, printable(word, 100)));
    }
    all.push_back(threads);
  }
  return all;
}

Result<std::unique_ptr<PeerProcess>> start_mesa(const BenchScene& bench, int threads) {
  const std::string size = fmt::format("{}x{}", bench.width(), bench.height());
  return PeerProcess::start(
      {"/proc/self/exe", {kPeerCommand, bench.name, "--size", size}, threads});
}

}  // namespace

void BenchCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command =
      *app.add_subcommand("bench", "how fast it draws, against whom, and how its time grows");
  command.footer(
      "Examples:\n"
      "  glassbox bench\n"
      "  glassbox bench S1 S3 --against mesa --threads 1,2\n"
      "  glassbox bench model.glb teapot:64 --json -\n"
      "  glassbox bench --scaling triangles --most 1000000\n\n"
      "Times are medians after three frames that are not measured; docs/benchmark.md says what is\n"
      "in them.\n\n" +
      scene_help() + "\n" + builtin_help());
  command.add_option("SCENE", scenes_,
                     "of the benchmark, built-in, or a glTF, GLB, OBJ or PLY file [S1 to S7]");
  add_measure_options(command);
  add_engine_options(command);
  const std::string outputs = "Other outputs";
  add_html_output(command, html_output_, "the same as a page, with bars and curves")
      ->group(outputs);
  add_json_output(command, json_output_)->group(outputs);
  command.callback([this, &exit_code] { exit_code = run(); });
}

void BenchCommand::add_measure_options(CLI::App& command) {
  add_choice<std::optional<Peer>>(
      command, "--against", against_, {{"mesa", Peer::kMesa}},
      "draw S1 to S7 with this too, in alternation, and compare the pictures");
  command.add_option("--frames", frames_, "measured frames of each side [9]")
      ->check(CLI::Range(1, kMostFrames))
      ->type_name("N");
  command
      .add_option_function<std::string>(
          "--size", [this](const std::string& text) { size_ = parse_size(text); },
          "of the picture [1920x1080]")
      ->type_name("WxH");
  add_choice(
      command, "--scaling", scaling_,
      choices_of({ScaledBy::kTriangles, ScaledBy::kPixels, ScaledBy::kThreads, ScaledBy::kTile}),
      "how time grows with this, in place of scenes");
  command
      .add_option_function<std::string>(
          "--most", [this](const std::string& text) { most_ = parse_number("--most", text); },
          "end --scaling there [30 million triangles, 16384 x 16384 pixels]")
      ->type_name("N");
  command.add_flag("--floor", floor_,
                   "measure the machine too, and how far each scene is from what it allows");
}

void BenchCommand::add_engine_options(CLI::App& command) {
  const std::string group = "Engine";
  add_choice(command, "--engine", engine_.engine,
             choices_of({EngineKind::kTile, EngineKind::kStaged}), "which one draws [tile]")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--threads", [this](const std::string& text) { threads_ = parse_threads(text); },
          "measure with each of these numbers of threads [1 and all]")
      ->type_name("N,...")
      ->group(group);
  add_target_option(command, engine_.tile.target);
}

Result<void> BenchCommand::check_options() const {
  if (engine_.engine == EngineKind::kStaged && !threads_.empty() &&
      threads_ != std::vector<int>{1}) {
    return fail("--threads", "the staged engine has one thread", "leave one of the two out");
  }
  if (!(most_ >= 0)) return fail("--most", "is no number of things", "give a number above 0");
  return check_report_outputs(html_output_, json_output_);
}

std::vector<std::string> BenchCommand::scene_names() const {
  if (!scenes_.empty()) return scenes_;
  std::vector<std::string> all;
  for (const study::BenchSceneName& known : study::bench_scene_names())
    all.emplace_back(known.name);
  return all;
}

Result<BenchScene> BenchCommand::load(const std::string& name) const {
  if (is_bench_scene(name)) return study::make_bench_scene(name, size_.width, size_.height);
  Result<Scene> scene = load_scene(name);
  if (!scene) return tl::unexpected(scene.error());
  for (const std::string& warning : scene->warnings) Progress().say("warning: " + warning);
  PictureOptions picture;
  picture.size = size_;
  const Result<ChosenView> chosen = choose_view(*scene, picture);
  if (!chosen) return tl::unexpected(chosen.error());
  return study::make_bench_scene(name, std::move(*scene), chosen->view);
}

study::MeasureOptions BenchCommand::measure_options(int threads) const {
  study::MeasureOptions options{engine_, frames_};
  options.engine.tile.threads = threads;
  return options;
}

Result<void> BenchCommand::measure_scene(const std::string& name, BenchReport& report,
                                         Progress& progress) const {
  progress.phase("loading " + name);
  const Result<BenchScene> bench = load(name);
  if (!bench) return tl::unexpected(bench.error());
  for (const int threads : threads_) {
    progress.phase(fmt::format("drawing {} with {}", name, counted(threads, "thread")));
    std::unique_ptr<PeerProcess> peer;
    if (against_ && bench->peers_draw_it) {
      auto started = start_mesa(*bench, threads);
      if (!started) return tl::unexpected(started.error());
      peer = std::move(*started);
    }
    auto measured = study::measure(*bench, measure_options(threads), peer.get());
    if (!measured) return tl::unexpected(measured.error());
    report.results.push_back(std::move(*measured));
  }
  if (against_ && !bench->peers_draw_it) {
    report.notes.push_back(name + " is drawn alone: the peer draws S1 to S7.");
  }
  return {};
}

Result<void> BenchCommand::write_outputs(const BenchReport& report) const {
  if (html_output_) {
    if (const auto written = write_text(*html_output_, bench_page(report)); !written)
      return written;
  }
  return json_output_ ? write_json(*json_output_, bench_json(report)) : Result<void>();
}

Result<void> BenchCommand::measure_scenes(BenchReport& report, Progress& progress) const {
  for (const std::string& name : scene_names()) {
    if (const auto done = measure_scene(name, report, progress); !done) return done;
  }
  if (!floor_) return {};
  progress.phase("measuring the machine");
  for (const int threads : threads_) report.floors.push_back(study::measure_floor(threads));
  return {};
}

void BenchCommand::measure_scaling(BenchReport& report, Progress& progress) const {
  const std::string_view by = name_of(*scaling_);
  report.scalings.push_back(study::measure_scaling(
      *scaling_, {measure_options(threads_.back()), size_.width, size_.height, most_},
      [&](double x) { progress.phase(fmt::format("{} {}", x, by)); }));
}

int BenchCommand::run() {
  if (const auto legal = check_options(); !legal) return refuse(legal.error());
  const bool staged = engine_.engine == EngineKind::kStaged;
  if (threads_.empty()) {
    threads_ = {1};
    if (!staged && study::processor_count() > 1) threads_.push_back(study::processor_count());
  }
  BenchReport report;
  report.machine = study::machine_name();
  report.compiler = study::compiler_name();
  report.engine = name_of(engine_.engine);
  report.target = name_of(staged ? Target::kScalar : engine_.tile.target);
  report.width = size_.width;
  report.height = size_.height;
  report.frames = frames_;
  Progress progress;
  if (scaling_) {
    measure_scaling(report, progress);
  } else if (const auto measured = measure_scenes(report, progress); !measured) {
    return refuse(measured.error());
  }
  progress.done();
  if (const auto written = write_outputs(report); !written) return refuse(written.error());
  if (json_output_ != "-") {
    fmt::print("{}", bench_text(report));
    if (html_output_) fmt::print("\n{}: open it in a browser\n", *html_output_);
  }
  return report.pictures_same() ? kSuccess : kFailure;
}

void BenchPeerCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(kPeerCommand, "draws for glassbox bench")->group("");
  command.add_option("SCENE", scene_)->required();
  command.add_option_function<std::string>(
      "--size", [this](const std::string& text) { size_ = parse_size(text); });
  command.callback([this, &exit_code] {
    const auto bench = study::make_bench_scene(scene_, size_.width, size_.height);
    if (!bench) {
      exit_code = refuse(bench.error());
      return;
    }
    exit_code = study::serve_mesa(*bench) ? kSuccess : kFailure;
  });
}

}  // namespace glassbox::app
