// The expected answers of lab 6, computed by the program's snap, triangle set-up and fans, and by
// the exact oracle of coverage.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include <glassbox/raster/fan.h>
#include <glassbox/raster/snap.h>
#include <glassbox/raster/triangle_setup.h>

#include "exact/coverage.h"
#include "labs/06-rasterisation/generators.h"
#include "labs/06-rasterisation/words.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

using namespace lab_06;

// A case in which the results for many inputs are the `values` of one field; they are not
// coordinates of points.
Case expect_numbers(const std::string& what, const std::string& restated, const std::string& field,
                    std::vector<double> values, const std::string& unit = "") {
  return {
      what, restated + extreme_case_command(what), {numbers(field, std::move(values), 0, unit)}};
}

// ---- 6.1 ----

Case expect_snap(const SnapCase& input) {
  std::vector<double> steps, from_centre;
  std::string text = "positions";
  for (const float pixels : input.pixels) {
    steps.push_back(glassbox::snap(pixels));
    from_centre.push_back(steps.back() - kCentre);
    if (steps.size() <= 6)
      text += fmt::format("{} {} px ({} steps)", steps.size() == 1 ? "" : ",", pixels,
                          double(pixels) * 256);
  }
  if (steps.size() > 6) text += ", ...";
  Case c = expect_numbers(input.what, text, "steps", steps, "1/256 px");
  c.slipped = {{"half-pixel", {numbers("steps", from_centre, 0, "1/256 px")}}};
  return c;
}

// ---- edge functions with a slip ----

// The edge function as a way of computing it gives it; a double has room for every result.
using Edge = double (*)(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& p);

double exact_edge(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& p) {
  return double(double_area(a, b, p));
}

double float_product(std::int32_t x, std::int32_t y) {
  return float(x) * float(y);
}

double edge_in_float(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& p) {
  return float(float_product(b.x - a.x, p.y - a.y) - float_product(b.y - a.y, p.x - a.x));
}

// In float on a machine that keeps one of the two products exact (fused multiply-add).
double edge_by_first_fused(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& p) {
  const auto second = float(float_product(b.y - a.y, p.x - a.x));
  return std::fma(float(b.x - a.x), float(p.y - a.y), -second);
}
double edge_by_second_fused(const SnappedVertex& a, const SnappedVertex& b,
                            const SnappedVertex& p) {
  const auto first = float(float_product(b.x - a.x, p.y - a.y));
  return std::fma(-float(b.y - a.y), float(p.x - a.x), first);
}

double edge_rounded_to_float(const SnappedVertex& a, const SnappedVertex& b,
                             const SnappedVertex& p) {
  return float(double_area(a, b, p));
}

// What is left of a number in 32 bits.
std::int64_t narrow(std::int64_t number) {
  return std::int32_t(std::uint32_t(std::uint64_t(number)));
}

double edge_in_32_bits(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& p) {
  return double(narrow(double_area(a, b, p)));
}

// The products of the edge function, of which some are computed in 32 bits; their difference is
// exact.
template <bool kFirst, bool kSecond>
double edge_by_narrow_products(const SnappedVertex& a, const SnappedVertex& b,
                               const SnappedVertex& p) {
  const std::int64_t first = std::int64_t(b.x - a.x) * (p.y - a.y);
  const std::int64_t second = std::int64_t(b.y - a.y) * (p.x - a.x);
  return double((kFirst ? narrow(first) : first) - (kSecond ? narrow(second) : second));
}

struct SlippedEdge {
  const char* slip;
  Edge edge;
};

constexpr SlippedEdge kSlippedEdges[] = {{"edge-in-float", edge_in_float},
                                         {"edge-in-float", edge_by_first_fused},
                                         {"edge-in-float", edge_by_second_fused},
                                         {"edge-in-float", edge_rounded_to_float},
                                         {"edge-in-32-bits", edge_in_32_bits},
                                         {"edge-in-32-bits", edge_by_narrow_products<true, true>},
                                         {"edge-in-32-bits", edge_by_narrow_products<true, false>},
                                         {"edge-in-32-bits", edge_by_narrow_products<false, true>}};

// ---- coverage with a slip ----

// A rule of coverage: where in a pixel the sample point is, which edges a clockwise triangle owns,
// and how the edge functions are computed.
struct Rule {
  const char* slip;
  std::int32_t centre;
  bool (*owns)(const SnappedVertex& a, const SnappedVertex& b);
  Edge edge = exact_edge;
  // Whether the winding is found by `edge`, too, and not exactly.
  bool winding_by_edge = false;
};

bool top_left(const SnappedVertex& a, const SnappedVertex& b) {
  return b.y < a.y || (b.y == a.y && b.x > a.x);
}
bool bottom_left(const SnappedVertex& a, const SnappedVertex& b) {
  return b.y < a.y || (b.y == a.y && b.x < a.x);
}
bool bottom_right(const SnappedVertex& a, const SnappedVertex& b) {
  return !top_left(a, b);
}
bool all_edges(const SnappedVertex&, const SnappedVertex&) {
  return true;
}

constexpr Rule kRule{"", kCentre, top_left};
constexpr Rule kSlippedRules[] = {{"half-pixel", 0, top_left},
                                  {"y-direction", kCentre, bottom_left},
                                  {"ownership", kCentre, bottom_right},
                                  {"all-edges", kCentre, all_edges}};

bool is_clockwise(const Rule& rule, const Triangle& t) {
  return (rule.winding_by_edge ? rule.edge : exact_edge)(t[0], t[1], t[2]) >= 0;
}

// Whether a pixel is on the inner side of edge k of a triangle. A counter-clockwise triangle is
// turned first.
bool inside_edge(const Rule& rule, const Triangle& t, std::size_t k, int x, int y) {
  const bool turned = !is_clockwise(rule, t);
  const SnappedVertex &from = t[k], &to = t[(k + 1) % 3];
  const SnappedVertex &a = turned ? to : from, &b = turned ? from : to;
  const double e = rule.edge(a, b, {x * kSteps + rule.centre, y * kSteps + rule.centre});
  return e > 0 || (e == 0 && rule.owns(a, b));
}

// ---- 6.2 and 6.3 ----

std::string samples_text(const EdgeCase& input, bool with_point) {
  std::string text = with_point ? "a, b, p (px):" : "a, b (px):";
  for (std::size_t i = 0; i < input.samples.size() && i < 6; ++i) {
    const auto& [a, b, p] = input.samples[i];
    text += fmt::format("\n  {}: {} {}", i, text_of(a), text_of(b));
    if (with_point) text += " " + text_of(p);
  }
  return text + (input.samples.size() > 6 ? "\n  ..." : "");
}

Case expect_edge(const EdgeCase& input) {
  std::vector<double> values, negated;
  for (const auto& [a, b, p] : input.samples) {
    values.push_back(double(double_area(a, b, p)));
    negated.push_back(-values.back());
  }
  Case c = expect_numbers(input.what, samples_text(input, true), "edge function", values,
                          "steps squared");
  // The typical mistake: the formula for a y axis that points up, or with a and b exchanged.
  c.slipped = {{"edge-sign", {numbers("edge function", negated, 0, "steps squared")}}};
  for (const SlippedEdge& each : kSlippedEdges) {
    std::vector<double> slipped;
    for (const auto& [a, b, p] : input.samples) slipped.push_back(each.edge(a, b, p));
    c.slipped.push_back({each.slip, {numbers("edge function", slipped, 0, "steps squared")}});
  }
  return c;
}

// The snapped vertex in pixels, the form that the triangle set-up takes.
ScreenVertex on_screen(const SnappedVertex& v) {
  return {{float(v.x) / 256, float(v.y) / 256, 0}, 1};
}

// Sets up a triangle that has the edge from a to b, and looks up whether it owns this edge.
Case expect_owner(const EdgeCase& input) {
  std::vector<double> owned, going_down, bottom, others;
  for (const auto& [a, b, p] : input.samples) {
    // With y down, the vector (-dy, dx) points to the right of the edge (dx, dy), so `inner` is on
    // the inner side of a clockwise triangle's edge.
    const SnappedVertex inner{a.x - (b.y - a.y), a.y + (b.x - a.x)};
    const auto setup = setup_triangle({on_screen(inner), on_screen(a), on_screen(b)});
    owned.push_back(setup && setup->edges[0].owns_zero ? 1 : 0);
    going_down.push_back(b.y > a.y || (b.y == a.y && b.x > a.x) ? 1 : 0);
    bottom.push_back(bottom_left(a, b) ? 1 : 0);
    others.push_back(1 - owned.back());
  }
  Case c = expect_numbers(input.what, samples_text(input, false), "owned", owned);
  c.slipped = {{"y-direction", {numbers("owned", going_down)}},
               {"y-direction", {numbers("owned", bottom)}},
               {"ownership", {numbers("owned", others)}},
               {"all-edges", {numbers("owned", std::vector<double>(owned.size(), 1))}}};
  return c;
}

// ---- 6.4 ----

// The pixels of the window that a triangle can cover by any rule.
PixelRect box_of(const Triangle& t, const PixelRect& window) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  return {std::max(window.x0, (left >> 8) - 1), std::max(window.y0, (top >> 8) - 1),
          std::min(window.x1, (right >> 8) + 2), std::min(window.y1, (bottom >> 8) + 2)};
}

Expected coverage_by(const CoverageCase& input, const Rule& rule) {
  const PixelRect& w = input.window;
  Expected expected{.field = "times covered", .shape = Shape::kCoverage, .columns = w.x1 - w.x0};
  expected.values.resize(std::size_t(w.x1 - w.x0) * std::size_t(w.y1 - w.y0));
  for (const Triangle& t : input.triangles) {
    if (double_area(t[0], t[1], t[2]) == 0) continue;
    const PixelRect box = box_of(t, w);
    for (int y = box.y0; y < box.y1; ++y) {
      for (int x = box.x0; x < box.x1; ++x) {
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k) inside = inside && inside_edge(rule, t, k, x, y);
        const auto row = std::size_t(y - w.y0), column = std::size_t(x - w.x0);
        expected.values[row * std::size_t(w.x1 - w.x0) + column] += inside ? 1 : 0;
      }
    }
  }
  return expected;
}

Expected coverage_of(const CoverageCase& input, bool clockwise, bool counter_clockwise) {
  const PixelRect& w = input.window;
  Expected expected{.field = "times covered", .shape = Shape::kCoverage, .columns = w.x1 - w.x0};
  for (int y = w.y0; y < w.y1; ++y) {
    for (int x = w.x0; x < w.x1; ++x) {
      int times = 0;
      for (const Triangle& t : input.triangles) {
        const bool drawn = double_area(t[0], t[1], t[2]) > 0 ? clockwise : counter_clockwise;
        times += drawn && exact::covers<std::int64_t>(t, x, y) ? 1 : 0;
      }
      expected.values.push_back(times);
    }
  }
  return expected;
}

Case expect_coverage(const CoverageCase& input) {
  const PixelRect& w = input.window;
  std::string text =
      fmt::format("window: pixels {} <= x < {}, {} <= y < {}", w.x0, w.x1, w.y0, w.y1);
  if (w.x0 != 0 || w.y0 != 0)
    text += fmt::format("; pixel (i, j) of the picture is ({} + i, {} + j)", w.x0, w.y0);
  for (std::size_t i = 0; i < input.triangles.size() && i < 4; ++i)
    text += fmt::format("\n  triangle {}: {}", i, text_of(input.triangles[i]));
  if (input.triangles.size() > 4) text += fmt::format("\n  ... {} in all", input.triangles.size());
  const Expected inside = numbers("outside the window", {0});
  // The mistake of accepting only one winding: triangles of the other winding are not drawn.
  Case c{.where = input.what,
         .restated = text + extreme_case_command(input.what),
         .expected = {coverage_of(input, true, true), inside},
         .slipped = {{"winding", {coverage_of(input, true, false), inside}},
                     {"winding", {coverage_of(input, false, true), inside}}}};
  for (const Rule& rule : kSlippedRules)
    c.slipped.push_back({rule.slip, {coverage_by(input, rule), inside}});
  for (const SlippedEdge& each : kSlippedEdges) {
    for (const bool winding_by_edge : {false, true}) {
      const Rule rule{each.slip, kCentre, top_left, each.edge, winding_by_edge};
      c.slipped.push_back({each.slip, {coverage_by(input, rule), inside}});
    }
  }
  return c;
}

// ---- 6.5 ----

Case expect_apex(const PolygonsCase& input) {
  std::vector<double> apexes;
  std::string text = "polygons (px):";
  for (const auto& polygon : input.polygons) {
    apexes.push_back(glassbox::fan_apex(polygon));
    if (apexes.size() > 8) continue;
    text += fmt::format("\n  {}:", apexes.size() - 1);
    for (const SnappedVertex& v : polygon) text += " " + text_of(v);
  }
  return expect_numbers(input.what, text + (apexes.size() > 8 ? "\n  ..." : ""), "apex", apexes);
}

// ---- 6.6 ----

// Classifies a tile by testing all its pixel centres.
TileCover cover_of(const TriangleSetup& setup, const PixelRect& tile) {
  bool all = true;
  for (const EdgeFunction& edge : setup.edges) {
    bool some = false;
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        const bool covers = edge.covers(edge.at(std::int64_t(x) * kSubpixels + kPixelCentre,
                                                std::int64_t(y) * kSubpixels + kPixelCentre));
        some = some || covers;
        all = all && covers;
      }
    }
    if (!some) return TileCover::kNone;
  }
  return all ? TileCover::kAll : TileCover::kSome;
}

TileCover cover_by(const Rule& rule, const Triangle& t, const PixelRect& tile) {
  bool all = true;
  for (std::size_t k = 0; k < 3; ++k) {
    bool some = false;
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        const bool inside = inside_edge(rule, t, k, x, y);
        some = some || inside;
        all = all && inside;
      }
    }
    if (!some) return TileCover::kNone;
  }
  return all ? TileCover::kAll : TileCover::kSome;
}

Case expect_tiles(const TileCase& input) {
  const auto& [a, b, c] = input.triangle;
  const auto setup = setup_triangle({on_screen(a), on_screen(b), on_screen(c)});
  std::vector<double> covers;
  for (const PixelRect& tile : input.tiles)
    covers.push_back(setup ? int(cover_of(*setup, tile)) : -1);
  const PixelRect& first = input.tiles[0];
  int columns = 0;
  while (std::size_t(columns) < input.tiles.size() &&
         input.tiles[std::size_t(columns)].y0 == first.y0)
    ++columns;
  Case made = expect_numbers(
      input.what,
      fmt::format("{}\ntiles of {} x {} pixels, {} to a row, the first at pixel ({}, {}); "
                  "0 kNone, 1 kSome, 2 kAll",
                  text_of(input.triangle), first.x1 - first.x0, first.y1 - first.y0, columns,
                  first.x0, first.y0),
      "tiles", covers);
  for (const Rule& rule : kSlippedRules) {
    std::vector<double> slipped;
    for (const PixelRect& tile : input.tiles)
      slipped.push_back(int(cover_by(rule, input.triangle, tile)));
    made.slipped.push_back({rule.slip, {numbers("tiles", slipped)}});
  }
  return made;
}

// ---- generated inputs; each answer is one number, except for a coverage ----

bool right_snap(const SnapCase& input, const Answer& answer) {
  return has_numbers(answer, "steps", {double(glassbox::snap(input.pixels[0]))});
}

bool right_edge(const EdgeCase& input, const Answer& answer) {
  const auto& [a, b, p] = input.samples[0];
  return has_numbers(answer, "edge function", {double(double_area(a, b, p))});
}

bool right_owner(const EdgeCase& input, const Answer& answer) {
  return has_numbers(answer, "owned",
                     {top_left(input.samples[0][0], input.samples[0][1]) ? 1.0 : 0.0});
}

bool right_coverage(const CoverageCase& input, const Answer& answer) {
  const auto* times = find_field(answer, "times covered");
  return times != nullptr && *times == coverage_of(input, true, true).values &&
         has_numbers(answer, "outside the window", {0});
}

bool right_apex(const PolygonsCase& input, const Answer& answer) {
  return has_numbers(answer, "apex", {double(glassbox::fan_apex(input.polygons[0]))});
}

bool right_tile(const TileCase& input, const Answer& answer) {
  return has_numbers(answer, "tiles", {double(cover_by(kRule, input.triangle, input.tiles[0]))});
}

}  // namespace

Lab lab_06() {
  return {
      6,
      "06-rasterisation",
      "Rasterisation: which pixels a triangle covers",
      {{"6.1", "Snap a position to the grid", 10},
       {"6.2", "The edge function, exactly", 15},
       {"6.3", "Who owns a shared edge", 15},
       {"6.4", "The pixels that a triangle covers", 30},
       {"6.5", "A fan that does not fold back", 10},
       {"6.6", "A tile against a triangle", 20}},
      {check("positions go to the nearest step", "6.1", "screen", positions, expect_snap),
       generated_check("any position", "6.1", "screen", generated_positions, expect_snap,
                       right_snap),
       hidden_check("positions next to halves and far away", "6.1", "screen", more_positions,
                    expect_snap),
       check("the edge function is twice an area with its sign", "6.2", "coverage", edges,
             expect_edge),
       generated_check("any edge and point", "6.2", "coverage", generated_edges, expect_edge,
                       right_edge),
       hidden_check("edges of 32 K pixels", "6.2", "coverage", far_edges, expect_edge),
       check("top and left edges are owned", "6.3", "coverage", directions, expect_owner),
       generated_check("any direction", "6.3", "coverage", generated_directions, expect_owner,
                       right_owner),
       hidden_check("edges in every direction", "6.3", "coverage", more_directions, expect_owner),
       check("every centre belongs to one triangle", "6.4", "coverage", triangles, expect_coverage),
       generated_check("any triangle", "6.4", "coverage", generated_triangles, expect_coverage,
                       right_coverage),
       hidden_check("meshes, fans, slivers and far triangles", "6.4", "coverage", more_triangles,
                    expect_coverage),
       check("a fan that does not fold back", "6.5", "coverage", polygons, expect_apex),
       generated_check("any polygon", "6.5", "coverage", generated_polygons, expect_apex,
                       right_apex),
       hidden_check("flat polygons bent by the snap", "6.5", "coverage", thin_polygons,
                    expect_apex),
       check("tiles without, with some, and with all pixels", "6.6", "coverage", tilings,
             expect_tiles),
       generated_check("any tile", "6.6", "coverage", generated_tiles, expect_tiles, right_tile),
       hidden_check("tiles in other places and sizes", "6.6", "coverage", more_tilings,
                    expect_tiles)}};
}

}  // namespace glassbox::labs
