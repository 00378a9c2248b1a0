#include "study/commands/bench/matching.h"

#include <chrono>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/scratch_directory.h"
#include "cli/report/text_layout.h"
#include "study/bench/machine.h"
#include "study/bench/statistics.h"
#include "views/commands/match_input.h"
#include "views/matching/match.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/elapsed.h>
#include <glassbox/base/printable.h>
#include <glassbox/base/processor_time.h>

namespace glassbox::study {

namespace {

namespace fs = std::filesystem;

constexpr double kSeparation = 0.2;  // world units

bool is_directory(const std::string& name) {
  std::error_code ignored;
  return fs::is_directory(name, ignored);
}

Result<views::MatchInput> read_pair(const std::string& name, const Size& size, Progress& progress) {
  views::MatchSources sources;
  if (is_directory(name)) {
    sources.left = name + "/im2.ppm";
    sources.right = name + "/im6.ppm";
    sources.truth = name + "/disp2.pgm";
    sources.truth_right = name + "/disp6.pgm";
    sources.truth_scale = 4;
  } else {
    sources.scene = name;
    sources.picture.size = size;
    sources.picture.eyes.separation = kSeparation;
  }
  return views::read_match_input(sources, progress);
}

Result<MatcherResult> measure_ours(const views::MatchInput& input, const char* method,
                                   const views::DisparityRange& range, int threads,
                                   const MatchingBenchOptions& options) {
  views::MatchSettings settings = *views::settings_named(method);
  settings.range = range;
  settings.threads = threads;
  settings.target = options.target;
  MatcherResult matcher;
  matcher.name = fmt::format("glassbox {}", method);
  std::vector<double> cpu, wall;
  for (int frame = 0; frame <= options.frames; ++frame) {
    const double before = processor_ms();
    const auto start = std::chrono::steady_clock::now();
    const auto match = views::match_pictures(input.left, input.right, settings);
    if (!match) return tl::unexpected(match.error());
    const double took_ms = elapsed_ms(start);
    if (frame == 0) {
      matcher.visible = views::disparity_errors(match->disparity, input.truth->disparity,
                                                &input.truth->is_visible);
      continue;
    }
    cpu.push_back(processor_ms() - before);
    wall.push_back(took_ms);
  }
  matcher.cpu_ms = study::median(cpu);
  matcher.wall_ms = study::median(wall);
  return matcher;
}

class MatchingBench {
public:
  MatchingBench(const MatchingBenchOptions& options, Progress& progress)
      : options_(options), progress_(progress) {
    report_.machine = study::machine_name();
    report_.compiler = study::compiler_name();
    report_.target = name_of(options.target);
    report_.frames = options.frames;
  }

  Result<void> pair(const std::string& name) {
    const auto input = read_pair(name, options_.size, progress_);
    if (!input) return tl::unexpected(input.error());
    const views::DisparityRange range =
        is_directory(name) ? views::DisparityRange{} : views::range_of(*input->truth);
    for (const int threads : options_.threads) {
      MatchedPair pair{input->description, threads, range.count(), {}};
      progress_.phase(fmt::format("matching {} with {}", name, counted(threads, "thread")));
      for (const char* method : {"fast", "default"}) {
        auto ours = measure_ours(*input, method, range, threads, options_);
        if (!ours) return tl::unexpected(ours.error());
        pair.matchers.push_back(std::move(*ours));
      }
      if (const auto done = add_peer(*input, range, threads, pair); !done) return done;
      report_.pairs.push_back(std::move(pair));
    }
    return {};
  }

  MatchingReport& report() { return report_; }

private:
  // If OpenCV is not installed, it is not tried again. Any other error concerns this pair only.
  Result<void> add_peer(const views::MatchInput& input, const views::DisparityRange& range,
                        int threads, MatchedPair& pair) {
    const auto scratch = scratch_.path();
    if (!scratch) return tl::unexpected(scratch.error());
    for (const PeerPaths paths : {PeerPaths::kThree, PeerPaths::kEight}) {
      if (is_missing_) return {};
      auto peer = match_with_opencv(input.left, input.right, range, paths, threads, options_.frames,
                                    *scratch);
      if (!peer) {
        is_missing_ = peer.error().cause == kPeerIsMissing;
        report_.notes.push_back(is_missing_
                                    ? fmt::format("OpenCV is left out: {}.", peer.error().message())
                                    : fmt::format("{} did not match {}, {}: {}.", name_of(paths),
                                                  pair.description, counted(threads, "thread"),
                                                  peer.error().message()));
        continue;
      }
      report_.peer = "OpenCV " + peer->version;
      pair.matchers.push_back({name_of(paths), study::median(peer->cpu_ms),
                               study::median(peer->wall_ms),
                               views::disparity_errors(peer->disparity, input.truth->disparity,
                                                       &input.truth->is_visible)});
    }
    return {};
  }

  const MatchingBenchOptions& options_;
  Progress& progress_;
  MatchingReport report_;
  ScratchDirectory scratch_;
  bool is_missing_ = false;
};

}  // namespace

Result<MatchingReport> measure_matching(const MatchingBenchOptions& options, Progress& progress) {
  MatchingBench measuring(options, progress);
  std::vector<std::string> pairs = options.pairs;
  if (pairs.empty()) {
    pairs = {"room", "forest"};
    for (const char* name : {"../shared/assets/stereo/cones", "../shared/assets/stereo/teddy"}) {
      if (is_directory(name)) {
        pairs.emplace_back(name);
      } else {
        measuring.report().notes.push_back(
            fmt::format("{} is left out: there is no such directory.", name));
      }
    }
  }
  for (const std::string& name : pairs) {
    if (const auto done = measuring.pair(name); !done) return tl::unexpected(done.error());
  }
  return std::move(measuring.report());
}

std::string matching_text(const MatchingReport& report) {
  std::string text = fmt::format("{}; {}; {}; medians of {}\n", report.machine, report.compiler,
                                 report.target, counted(report.frames, "match", "matches"));
  if (!report.peer.empty()) {
    text += wrapped("peer: ",
                    report.peer + fmt::format(" StereoSGBM: blocks of {}, P1 {}, P2 {}, left-right "
                                              "check, holes filled from the smaller side",
                                              kPeerBlock, kPeerP1, kPeerP2));
  }
  for (const MatchedPair& pair : report.pairs) {
    text +=
        fmt::format("\n{}\n{}, {} disparities\n{:<20}{:>9}{:>9}{:>12}{:>8}{:>8}{:>8}\n",
                    printable(pair.description, kTextWidth), counted(pair.threads, "thread"),
                    pair.disparities, "", "CPU ms", "wall ms", "off by 0.5", "1", "2 px", "RMS px");
    for (const MatcherResult& one : pair.matchers) {
      const auto& bad = one.visible.bad_percent;
      text += fmt::format("{:<20}{:>9.1f}{:>9.1f}{:>11.2f}%{:>7.2f}%{:>7.2f}%{:>8.2f}\n", one.name,
                          one.cpu_ms, one.wall_ms, bad[0], bad[1], bad[2], one.visible.rms);
    }
  }
  text +=
      "\nPer cent of the pixels seen in both pictures whose disparity is off by more than 0.5, 1 "
      "and 2 px;\n"
      "a pixel without disparity counts as off.\n";
  for (const std::string& note : report.notes) text += wrapped("", note);
  return text;
}

nlohmann::ordered_json matching_json(const MatchingReport& report) {
  using Json = nlohmann::ordered_json;
  Json json{{"machine", report.machine}, {"compiler", report.compiler}, {"target", report.target},
            {"frames", report.frames},   {"peer", report.peer},         {"notes", report.notes}};
  json["pairs"] = Json::array();
  for (const MatchedPair& pair : report.pairs) {
    Json one{
        {"pair", pair.description}, {"threads", pair.threads}, {"disparities", pair.disparities}};
    for (const MatcherResult& matcher : pair.matchers) {
      Json bad = Json::object();
      for (std::size_t i = 0; i < views::kBadAt.size(); ++i) {
        bad[fmt::format("{:g}", views::kBadAt[i])] = matcher.visible.bad_percent[i];
      }
      one["matchers"].push_back({{"name", matcher.name},
                                 {"cpu_ms", matcher.cpu_ms},
                                 {"wall_ms", matcher.wall_ms},
                                 {"bad_percent", bad},
                                 {"rms_px", matcher.visible.rms}});
    }
    json["pairs"].push_back(std::move(one));
  }
  return json;
}

}  // namespace glassbox::study
