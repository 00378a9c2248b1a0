#include "cli/report/stage_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/text_layout.h"

namespace glassbox {

std::string with_separators(std::uint64_t n) {
  std::string digits = std::to_string(n);
  for (int i = int(digits.size()) - 3; i > 0; i -= 3) digits.insert(std::size_t(i), 1, ',');
  return digits;
}

namespace {

std::string row(const std::string& stage, std::uint64_t in, std::uint64_t out,
                const std::string& notes) {
  return fmt::format("  {:<26}{:>12} {:>12}   {}\n", stage, with_separators(in),
                     with_separators(out), notes);
}

std::string time_row(const std::string& stage, double ms) {
  return fmt::format("  {:<26}{:>12.1f} ms\n", stage, ms);
}

}  // namespace

std::string stage_table(const Statistics& s, EngineKind engine) {
  const bool tile = engine == EngineKind::kTile;
  const std::uint64_t modelled = s.triangles - s.degenerate;
  const std::uint64_t drawable = modelled - s.left_out;
  std::string text = fmt::format("  {:<26}{:>12} {:>12}\n", "stage", "in", "out");
  text += row("triangles of the mesh", s.triangles, modelled,
              s.degenerate ? with_separators(s.degenerate) + " without area" : "");
  const std::uint64_t in_draws = s.left_out - s.left_out_in_clusters;
  if (in_draws > 0) {
    text += row("whole draws", modelled, modelled - in_draws,
                with_separators(in_draws) + " left out by the plan");
  }
  if (s.clusters > 0) {
    text += row("clusters", modelled - in_draws, drawable,
                fmt::format("{} tested: {} outside the view and {} turned away",
                            with_separators(s.clusters), with_separators(s.clusters_outside),
                            with_separators(s.clusters_turned_away)));
  }
  const std::uint64_t vertices = s.vertices + s.moved_in_x;
  text +=
      row("object -> clip space", vertices, vertices,
          s.moved_in_x > 0 ? "vertices are transformed; for the second eye only x is computed again"
                           : "vertices");
  if (s.culled_early > 0) {
    text += row("cull in object space", drawable, drawable - s.culled_early,
                with_separators(s.culled_early) + " turned away for certain");
  }
  std::string clipping = with_separators(s.rejected + s.clipped_away) + " outside";
  if (s.clipped > 0) clipping += ", " + with_separators(s.clipped) + " cut";
  if (tile) clipping += "; those outside the picture are removed after culling";
  text += row("clip", drawable - s.culled_early, s.after_clipping, clipping);
  text += row("divide, viewport, snap", s.after_clipping, s.after_clipping - s.zero_area,
              with_separators(s.zero_area) + " without area on the screen");
  text += row("back-face cull", s.after_clipping - s.zero_area, s.set_up,
              with_separators(s.culled) + " turned away");
  if (s.lines + s.points > 0) {
    text += row("lines and points", s.lines + s.points, s.lines + s.points, "");
  }
  text += row("coverage", s.set_up, s.covered,
              tile ? "triangles in, fragments out; fragments of hidden blocks are not counted"
                   : "triangles in, fragments out");
  text += row("depth test", s.covered, s.covered - s.depth_failed,
              with_separators(s.depth_failed) + " behind");
  text += row(tile ? "alpha mask" : "texture, light, alpha mask", s.covered - s.depth_failed,
              s.written, s.discarded ? with_separators(s.discarded) + " transparent" : "");
  text +=
      row("write", s.written, s.written, s.blended ? with_separators(s.blended) + " blended" : "");
  if (tile) {
    text += wrapped("  texture, light: ",
                    "computed once for each visible pixel (with several samples, once for each "
                    "triangle that the samples show) and for each blended fragment");
  }
  return text;
}

std::string time_table(const Statistics& s) {
  std::string text = time_row("prepare", s.prepare_ms);
  text += time_row("vertices", s.vertex_ms);
  text += time_row("triangles", s.triangle_ms);
  text += time_row("fragments", s.fragment_ms);
  return text;
}

nlohmann::ordered_json to_json(const Statistics& s) {
  return {{"instances", s.instances},
          {"vertices", s.vertices},
          {"triangles", s.triangles},
          {"degenerate", s.degenerate},
          {"left_out", s.left_out},
          {"clusters", s.clusters},
          {"clusters_outside", s.clusters_outside},
          {"clusters_turned_away", s.clusters_turned_away},
          {"left_out_in_clusters", s.left_out_in_clusters},
          {"plane_tests", s.plane_tests},
          {"normals", s.normals},
          {"eye_positions", s.eye_positions},
          {"lines", s.lines},
          {"points", s.points},
          {"culled_early", s.culled_early},
          {"rejected", s.rejected},
          {"clipped_away", s.clipped_away},
          {"clipped", s.clipped},
          {"after_clipping", s.after_clipping},
          {"zero_area", s.zero_area},
          {"culled", s.culled},
          {"set_up", s.set_up},
          {"covered", s.covered},
          {"depth_failed", s.depth_failed},
          {"discarded", s.discarded},
          {"written", s.written},
          {"blended", s.blended},
          {"ms",
           {{"prepare", s.prepare_ms},
            {"vertices", s.vertex_ms},
            {"triangles", s.triangle_ms},
            {"fragments", s.fragment_ms}}}};
}

}  // namespace glassbox
