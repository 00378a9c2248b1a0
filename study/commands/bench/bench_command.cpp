#include "study/commands/bench/bench_command.h"

#include <algorithm>
#include <charconv>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/builtin_help.h"
#include "cli/options/choices.h"
#include "cli/options/engine_options.h"
#include "cli/options/output_options.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "study/bench/machine.h"
#include "study/bench/mesa/limits.h"
#include "study/bench/peer_process.h"
#include "study/commands/bench/matching.h"
#include "study/commands/bench/report.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox::study {

namespace {

constexpr const char* kPeerCommand = "bench-peer";
constexpr int kMaxBenchFrames = 100000;

std::vector<int> parse_threads(const std::string& text) {
  std::vector<int> all;
  for (const std::string& word : CLI::detail::split(text, ',')) {
    int threads = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), threads);
    const bool number = error == std::errc() && end == word.data() + word.size();
    if (!number || threads < 1 || threads > kMaxThreads) {
      throw CLI::ValidationError(
          "--threads", fmt::format("needs numbers from 1 to {}, such as 1,2; not '{}'", kMaxThreads,
                                   printable(word, 100)));
    }
    all.push_back(threads);
  }
  return all;
}

Result<std::unique_ptr<PeerProcess>> start_mesa(const std::string& name,
                                                const BenchDrawing& drawing, int threads) {
  std::vector<std::string> words{kPeerCommand, name};
  const std::vector<std::string> more = words_of(drawing);
  words.insert(words.end(), more.begin(), more.end());
  return PeerProcess::start({"/proc/self/exe", words, threads});
}

}  // namespace

void BenchCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand("bench");
  command.footer(
      "Examples:\n"
      "  glassbox bench\n"
      "  glassbox bench S1 S3 --against mesa --threads 1,2\n"
      "  glassbox bench model.glb teapot:64 --against mesa --samples 4\n"
      "  glassbox bench room forest --against opencv --threads 2\n"
      "  glassbox bench room --stereo anaglyph --json -\n"
      "  glassbox bench --scaling triangles --most 1000000\n\n"
      "Times are medians. Three frames run before the measured ones (one with --against opencv);\n"
      "docs/benchmark.md says what the times include.\n\n" +
      bench_scene_help() + "\n" + builtin_help());
  command.add_option(
      "SCENE", scenes_,
      "a scene of the benchmark, a built-in scene, or a glTF, GLB, OBJ or PLY file [S1 to R12]");
  add_measure_options(command);
  add_engine_options(command);
  const std::string outputs = "Other outputs";
  add_html_output(command, html_output_, "the printed output as a page, with bars and curves")
      ->group(outputs);
  add_json_output(command, json_output_)->group(outputs);
  command.callback([this, &exit_code] { exit_code = run(); });
}

void BenchCommand::add_measure_options(CLI::App& command) {
  add_choice<std::optional<Peer>>(
      command, "--against", against_, {{"mesa", Peer::kMesa}, {"opencv", Peer::kOpencv}},
      "also draw the frames, in turn, with this other renderer (the peer), and compare the "
      "pictures; opencv: compare the matching of picture pairs instead (see views match)");
  command.add_option("--frames", frames_, "measured frames of Glassbox and of the peer [9]")
      ->check(CLI::Range(1, kMaxBenchFrames))
      ->type_name("N");
  add_bench_drawing(command, drawing_);
  size_option_ = command.get_option("--size");
  add_choice(
      command, "--scaling", scaling_,
      choices_of({ScaledBy::kTriangles, ScaledBy::kPixels, ScaledBy::kThreads, ScaledBy::kTile}),
      "instead of scenes, measure how time grows with this quantity");
  command
      .add_option_function<std::string>(
          "--most", [this](const std::string& text) { most_ = parse_number("--most", text); },
          "largest number of triangles or pixels that --scaling measures [30 million triangles, "
          "16384 x 16384 pixels]")
      ->type_name("N");
  command.add_flag("--floor", floor_,
                   "measure the machine's speed too, and compare each time with the least that "
                   "this machine allows");
}

void BenchCommand::add_engine_options(CLI::App& command) {
  const std::string group = "Engine";
  add_choice(command, "--engine", engine_.engine,
             choices_of({EngineKind::kTile, EngineKind::kStaged}), "the engine that draws [tile]")
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
    return fail("--threads", "--engine staged always uses one thread", "leave one of the two out");
  }
  if (!(most_ >= 0))
    return fail("--most", "is not a number above 0",
                "give the largest number to measure, such as 1e6");
  return check_report_outputs(html_output_, json_output_);
}

study::MeasureOptions BenchCommand::measure_options(int threads) const {
  study::MeasureOptions options{engine_, frames_};
  options.engine.tile.threads = threads;
  return options;
}

Result<void> BenchCommand::measure_scene(const std::string& name, BenchReport& report,
                                         Progress& progress) const {
  if (const auto missing = missing_asset(name)) {
    report.notes.push_back(
        fmt::format("{} is left out: the file {} does not exist.", name, *missing));
    return {};
  }
  progress.phase("loading " + name);
  const Result<BenchScene> bench = load_bench_scene(name, drawing_);
  if (!bench) return tl::unexpected(bench.error());
  for (const std::string& warning : bench->scene.warnings)
    progress.print_line("warning: " + warning);
  const auto alone = against_ ? study::peer_cannot_draw(*bench) : std::nullopt;
  for (const int threads : threads_) {
    progress.phase(fmt::format("drawing {} with {}", name, counted(threads, "thread")));
    std::unique_ptr<PeerProcess> peer;
    if (against_ && !alone) {
      auto started = start_mesa(name, drawing_, threads);
      if (!started) return tl::unexpected(started.error());
      peer = std::move(*started);
    }
    auto measured = study::measure(*bench, measure_options(threads), peer.get());
    if (!measured) return tl::unexpected(measured.error());
    report.results.push_back(std::move(*measured));
  }
  if (alone) report.notes.push_back(fmt::format("{} is drawn without the peer: {}.", name, *alone));
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
  for (const std::string& name : scenes_.empty() ? all_bench_scenes() : scenes_) {
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
      *scaling_,
      {measure_options(threads_.back()), drawing_.size.width, drawing_.size.height, most_},
      [&](double x) { progress.phase(fmt::format("{} {}", x, by)); }));
}

// Measures the matching of stereo pairs, instead of the drawing of scenes.
int BenchCommand::run_matching() {
  if (scaling_ || floor_ || html_output_ || drawing_.anaglyph || drawing_.samples) {
    return refuse(fail("--against opencv", "it measures the matching of picture pairs, not drawing",
                       "leave out --scaling, --floor, --html, --samples and --stereo")
                      .value());
  }
  MatchingBenchOptions options{scenes_, {640, 480}, threads_, frames_, engine_.tile.target};
  if (size_option_->count() > 0) options.size = drawing_.size;
  Progress progress;
  const auto report = measure_matching(options, progress);
  if (!report) return refuse(report.error());
  progress.done();
  if (json_output_) {
    const auto written = write_json(*json_output_, matching_json(*report));
    if (!written) return refuse(written.error());
  }
  if (json_output_ != "-") fmt::print("{}", matching_text(*report));
  return kSuccess;
}

int BenchCommand::run() {
  if (const auto legal = check_options(); !legal) return refuse(legal.error());
  const bool staged = engine_.engine == EngineKind::kStaged;
  if (threads_.empty()) {
    threads_ = {1};
    if (!staged && study::processor_count() > 1) threads_.push_back(study::processor_count());
  }
  if (against_ == Peer::kOpencv) return run_matching();
  BenchReport report;
  report.machine = study::machine_name();
  report.compiler = study::compiler_name();
  report.engine = name_of(engine_.engine);
  report.target = name_of(staged ? Target::kScalar : engine_.tile.target);
  report.width = drawing_.size.width;
  report.height = drawing_.size.height;
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
  CLI::App& command =
      *app.add_subcommand(kPeerCommand, "draws with another renderer for glassbox bench")
           ->group("");
  command.add_option("SCENE", scene_)->required();
  add_bench_drawing(command, drawing_);
  command.callback([this, &exit_code] {
    const auto bench = load_bench_scene(scene_, drawing_);
    if (!bench) {
      exit_code = refuse(bench.error());
      return;
    }
    exit_code = study::serve_mesa(*bench) ? kSuccess : kFailure;
  });
}

}  // namespace glassbox::study
