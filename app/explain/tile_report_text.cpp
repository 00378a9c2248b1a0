#include "app/explain/tile_report_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/stage_report.h"

#include <glassbox/raster/lanes/tables.h>

namespace glassbox::app {

namespace {

// the size in bytes of a position, of a normal, or of a triangle's three indices
constexpr std::uint64_t kTriple = 3 * sizeof(float);

std::string amount(std::uint64_t bytes) {
  return bytes < 1000000 ? fmt::format("{:.1f} kB", double(bytes) / 1e3)
                         : fmt::format("{:.1f} MB", double(bytes) / 1e6);
}

using ThreadTime = double TileReport::Thread::*;

std::string row(const std::string& stage, double ms, const TileReport& report, ThreadTime part,
                const StageBytes* bytes) {
  std::string text = fmt::format("  {:<26}{:>12.2f} ms", stage, ms);
  if (bytes != nullptr) {
    text += fmt::format("   {:>9} in {:>9} out  ", amount(bytes->read), amount(bytes->written));
    for (const TileReport::Thread& thread : report.threads) {
      text += fmt::format(" {:.2f}", thread.*part);
    }
  }
  return text + "\n";
}

}  // namespace

TileBytes bytes_moved(const Statistics& s, const TileReport& report) {
  TileBytes bytes;
  const std::uint64_t screen = s.vertices * sizeof(SnappedEntry);
  const std::uint64_t indices = report.triangles * kTriple;
  const std::uint64_t lists = report.list_entries * sizeof(std::uint32_t);
  const std::uint64_t large = report.large_triangles * sizeof(LargeTriangle);
  bytes.vertices = {(s.vertices + s.normals + s.eye_positions) * kTriple,
                    screen + (s.normals + s.eye_positions) * kTriple};
  bytes.triangles = {indices + screen, lists + large};
  bytes.fragments = {lists + large + indices + screen, report.plane_bytes};
  return bytes;
}

std::string tile_text(const Statistics& s, const TileReport& report) {
  const TileBytes bytes = bytes_moved(s, report);
  std::string text = fmt::format(
      "  vertices: {} tested against planes; to eye space: {} normals, {} positions\n"
      "  triangles: {} in {} entries of {} tiles' lists, {} of them set up one by one\n",
      with_separators(s.plane_tests), with_separators(s.normals), with_separators(s.eye_positions),
      with_separators(report.triangles), with_separators(report.list_entries),
      with_separators(report.tiles), with_separators(report.large_triangles));
  if (report.runs < report.draws) {
    text += fmt::format("  draws: {}, joined into {} lists of triangles, each of one mesh\n",
                        with_separators(report.draws), with_separators(report.runs));
  }
  if (report.textures > 0) {
    text += fmt::format("  textures: {} of {} used, and their mip levels made\n",
                        with_separators(report.textures_made), with_separators(report.textures));
  }
  text += fmt::format("\n  {:<26}{:>12}      {:>25}   {}\n", "time", "", "bytes of tables",
                      "busy ms, thread by thread");
  text += row("prepare", s.prepare_ms, report, nullptr, nullptr);
  text += row("vertices", s.vertex_ms, report, &TileReport::Thread::vertex_ms, &bytes.vertices);
  text +=
      row("triangles", s.triangle_ms, report, &TileReport::Thread::triangle_ms, &bytes.triangles);
  text +=
      row("fragments", s.fragment_ms, report, &TileReport::Thread::fragment_ms, &bytes.fragments);
  return text;
}

nlohmann::ordered_json to_json(const Statistics& s, const TileReport& report) {
  const TileBytes bytes = bytes_moved(s, report);
  const auto moved = [](const StageBytes& b) {
    return nlohmann::ordered_json{{"read", b.read}, {"written", b.written}};
  };
  nlohmann::ordered_json threads = nlohmann::ordered_json::array();
  for (const TileReport::Thread& thread : report.threads) {
    threads.push_back({{"vertices", thread.vertex_ms},
                       {"triangles", thread.triangle_ms},
                       {"fragments", thread.fragment_ms}});
  }
  return {{"tiles", report.tiles},
          {"rounds", report.rounds},
          {"draws", report.draws},
          {"runs", report.runs},
          {"list_entries", report.list_entries},
          {"large_triangles", report.large_triangles},
          {"textures", {{"all", report.textures}, {"made", report.textures_made}}},
          {"bytes",
           {{"vertices", moved(bytes.vertices)},
            {"triangles", moved(bytes.triangles)},
            {"fragments", moved(bytes.fragments)}}},
          {"thread_ms", std::move(threads)}};
}

}  // namespace glassbox::app
