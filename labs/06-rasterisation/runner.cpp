// Calls your functions with the cases of lab 6.
#include "labs/framework/runner.h"
#include "generators.h"
#include "student.h"

namespace lab_06 {
namespace {

using glassbox::labs::Answer;

void ask_snap(const SnapCase& input, Answer& answer) {
  std::vector<double> steps;
  for (const float pixels : input.pixels) steps.push_back(snap(pixels));
  answer.emit("steps", steps);
}

void ask_edge(const EdgeCase& input, Answer& answer) {
  std::vector<double> values;
  for (const auto& [a, b, p] : input.samples) values.push_back(double(edge(a, b, p)));
  answer.emit("edge function", values);
}

void ask_owner(const EdgeCase& input, Answer& answer) {
  std::vector<double> owned;
  for (const auto& [a, b, p] : input.samples) owned.push_back(owns_edge(a, b) ? 1 : 0);
  answer.emit("owned", owned);
}

void ask_coverage(const CoverageCase& input, Answer& answer) {
  const PixelRect& w = input.window;
  const auto width = std::size_t(w.x1 - w.x0);
  std::vector<double> times(width * std::size_t(w.y1 - w.y0));
  double outside = 0;
  for (const Triangle& triangle : input.triangles) {
    for (const Pixel& p : covered_pixels(triangle, w)) {
      if (p.x < w.x0 || p.x >= w.x1 || p.y < w.y0 || p.y >= w.y1) {
        ++outside;
      } else {
        ++times[std::size_t(p.y - w.y0) * width + std::size_t(p.x - w.x0)];
      }
    }
  }
  answer.emit("times covered", times);
  answer.emit("outside the window", {outside});
}

void ask_apex(const PolygonsCase& input, Answer& answer) {
  std::vector<double> apexes;
  for (const auto& polygon : input.polygons) apexes.push_back(fan_apex(polygon));
  answer.emit("apex", apexes);
}

void ask_tiles(const TileCase& input, Answer& answer) {
  std::vector<double> covers;
  for (const PixelRect& tile : input.tiles)
    covers.push_back(int(classify_tile(input.triangle, tile)));
  answer.emit("tiles", covers);
}

}  // namespace
}  // namespace lab_06

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_06;
  return {
      check("positions go to the nearest step", positions(), ask_snap),
      check("the edge function is twice an area with its sign", edges(), ask_edge),
      check("top and left edges are owned", directions(), ask_owner),
      check("every centre belongs to one triangle", triangles(), ask_coverage),
      check("a fan that does not fold back", polygons(), ask_apex),
      check("tiles without, with some, and with all pixels", tilings(), ask_tiles),
      generated_check("any position", generated_positions(), ask_snap),
      generated_check("any edge and point", generated_edges(), ask_edge),
      generated_check("any direction", generated_directions(), ask_owner),
      generated_check("any triangle", generated_triangles(), ask_coverage),
      generated_check("any polygon", generated_polygons(), ask_apex),
      generated_check("any tile", generated_tiles(), ask_tiles),
      // BEGIN HIDDEN
      check("positions next to halves and far away", more_positions(), ask_snap),
      check("edges of 32 K pixels", far_edges(), ask_edge),
      check("edges in every direction", more_directions(), ask_owner),
      check("meshes, fans, slivers and far triangles", more_triangles(), ask_coverage),
      check("flat polygons bent by the snap", thin_polygons(), ask_apex),
      check("tiles in other places and sizes", more_tilings(), ask_tiles),
      // END HIDDEN
  };
}
