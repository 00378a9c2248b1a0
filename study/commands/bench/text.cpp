#include "study/commands/bench/report.h"

#include <cmath>

#include <fmt/format.h>

#include <glassbox/base/counted.h>

namespace glassbox::study {

namespace {

std::string with_quartiles(const Quartiles& q) {
  return fmt::format("{:>8} ({} .. {})", three_digits(q.median), three_digits(q.lower),
                     three_digits(q.upper));
}

std::string result_line(const Measurement& result) {
  std::string line =
      fmt::format("{:<12} {:>7}  {:<27}", result.scene, result.threads, with_quartiles(result.ms));
  if (result.peer_comparison) {
    const PeerComparison& peer_comparison = *result.peer_comparison;
    line +=
        fmt::format("  {:<27}  {:>6} ({} .. {})", with_quartiles(peer_comparison.ms),
                    three_digits(result.ratio()), three_digits(peer_comparison.frame_ratio.lower),
                    three_digits(peer_comparison.frame_ratio.upper));
  }
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

std::string results_table(const BenchReport& report) {
  bool peers = false;
  for (const Measurement& result : report.results)
    peers = peers || result.peer_comparison.has_value();
  std::string text =
      fmt::format("{:<12} {:>7}  {:>8} {:<18}", "scene", "threads", "ms", "(quartiles)");
  if (peers)
    text += fmt::format("  {:>8} {:<18}  {:>6} (of single frames)", "peer ms", "", "ratio");
  text = text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
  for (const Measurement& result : report.results) text += result_line(result);
  return text;
}

// The remarks below the table: what there is to say about a scene besides its times.
std::string remarks(const Measurement& result) {
  std::string text;
  const std::string where =
      fmt::format("{}, {}: ", result.scene, counted(result.threads, "thread"));
  if (result.samples > 1) text += fmt::format("{}{} samples per pixel\n", where, result.samples);
  if (result.peer_comparison) text += where + match_text(result.peer_comparison->match) + "\n";
  if (result.stereo) {
    text += fmt::format("{}both eyes in one run take {} ms, {} times one eye's {} ms\n", where,
                        three_digits(result.stereo->shared_ms),
                        three_digits(result.stereo->shared_ms / result.stereo->mono_ms),
                        three_digits(result.stereo->mono_ms));
    if (const auto& eye = result.stereo->warped) {
      text += fmt::format(
          "{}with the right eye warped from the left one, {} times one eye's {} ms of processor "
          "time; {:.2f} % of its pixels are off by more than {}/255\n",
          where, three_digits(eye->both_warped_ms / eye->one_eye_ms), three_digits(eye->one_eye_ms),
          100 * double(eye->warped.wrong) / double(eye->pixels), views::kVisibleDifference);
    }
  }
  if (result.rejected_ms) {
    text += fmt::format("{}{} ms if objects outside the view are left out as a whole\n", where,
                        three_digits(*result.rejected_ms));
  }
  return text;
}

std::string floor_table(const BenchReport& report) {
  std::string text;
  for (const study::Floor& floor : report.floors) {
    text += fmt::format("{}: memory is read at {} GB/s and written at {} GB/s; {} GFLOP/s\n",
                        counted(floor.threads, "thread"),
                        three_digits(floor.read_bytes_per_second / 1e9),
                        three_digits(floor.written_bytes_per_second / 1e9),
                        three_digits(floor.operations_per_second / 1e9));
  }
  text += fmt::format("\n{:<12} {:>7}  {:>8}  {:>9}  {:>9}  {:>8}  {}\n", "scene", "threads",
                      "MB read", "written", "floor, ms", "ms", "times the floor");
  for (const Measurement& result : report.results) {
    const study::Floor* floor = report.floor_of(result);
    if (floor == nullptr) continue;
    const double least = study::floor_ms(*floor, result.least);
    text += fmt::format("{:<12} {:>7}  {:>8}  {:>9}  {:>9}  {:>8}  {}\n", result.scene,
                        result.threads, three_digits(result.least.read_bytes / 1e6),
                        three_digits(result.least.written_bytes / 1e6), three_digits(least),
                        three_digits(result.ms.median), three_digits(result.ms.median / least));
  }
  return text;
}

std::string scaling_table(const Scaling& scaling) {
  std::string text =
      fmt::format("Time against {}, {}\n{:>12}  {:>8} {:<18}  {:>11}\n", name_of(scaling.by),
                  scaling.what, name_of(scaling.by), "ms", "(quartiles)", "memory, MiB");
  for (const study::ScalingPoint& point : scaling.points) {
    text += fmt::format("{:>12.0f}  {:<27}  {:>11.0f}\n", point.x, with_quartiles(point.ms),
                        point.peak_bytes / 1048576);
  }
  return text + scaling_text(scaling) + "\n";
}

}  // namespace

std::string three_digits(double value) {
  if (value == 0) return "0";
  const int before = int(std::floor(std::log10(std::abs(value)))) + 1;
  return fmt::format("{:.{}f}", value, std::max(0, 3 - before));
}

std::string match_text(const study::PictureMatch& match) {
  if (!match.same()) {
    return fmt::format(
        "NOT the same picture: {} pixels covered, {} by the peer; {} differ in coverage and {} in "
        "colour, {} of them at edges, where {} are allowed; elsewhere colours differ by up to "
        "{}/255",
        match.covered, match.peer_covered, match.coverage_differs, match.color_differs,
        match.at_edges(), match.allowed_at_edges(), match.largest_away_from_edges);
  }
  std::string text =
      match.at_edges() == 0
          ? fmt::format("the same {} pixels covered", match.covered)
          : fmt::format("{} of {} pixels differ at edges", match.at_edges(), match.pixels);
  if (match.colored_away_from_edges > 0) {
    text += fmt::format(", {} elsewhere by up to {}/255", match.colored_away_from_edges,
                        match.largest_away_from_edges);
  }
  return text + fmt::format("; colours otherwise within {}/255", match.largest_elsewhere);
}

std::string scaling_text(const Scaling& scaling) {
  std::string text;
  if (scaling.ratios) {
    text = fmt::format("{:.3g} times as many {} take {:.3g} times as long", scaling.ratios->x,
                       name_of(scaling.by), scaling.ratios->ms);
  }
  if (scaling.law) {
    text = fmt::format("time grows as {}^{:.2f}", name_of(scaling.by), scaling.law->exponent);
  }
  if (scaling.bend) {
    text +=
        fmt::format("; the exponent changes at {:.3g}: {:.2f} before, {:.2f} after",
                    scaling.bend->at, scaling.bend->before.exponent, scaling.bend->after.exponent);
  }
  if (scaling.bytes_per_triangle) {
    text += fmt::format("; {:.0f} bytes per triangle", *scaling.bytes_per_triangle);
  }
  if (!scaling.stopped.empty()) text += (text.empty() ? "" : "; ") + scaling.stopped;
  return text;
}

std::string bench_text(const BenchReport& report) {
  std::string text = fmt::format("{}; {}; {} engine, {}; {} x {}, medians of {} frames\n",
                                 report.machine, report.compiler, report.engine, report.target,
                                 report.width, report.height, report.frames);
  if (!report.results.empty()) {
    for (const Measurement& result : report.results) {
      if (!result.peer_comparison) continue;
      text += "peer: " + result.peer_comparison->peer + "\n";
      break;
    }
    text += "\n" + results_table(report);
    std::string below;
    for (const Measurement& result : report.results) below += remarks(result);
    if (!below.empty()) text += "\n" + below;
  }
  if (!report.floors.empty()) text += "\n" + floor_table(report);
  for (const Scaling& scaling : report.scalings) text += "\n" + scaling_table(scaling);
  for (const std::string& note : report.notes) text += "\n" + note + "\n";
  return text;
}

}  // namespace glassbox::study
