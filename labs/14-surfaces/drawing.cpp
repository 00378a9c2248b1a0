// Lab 14 in a picture: the inside of the scene's objects becomes voxels, and the surface around the
// voxels is drawn from the student's polygons and crossings.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "labs/14-surfaces/borders.h"
#include "labs/drawing/drawing.h"
#include "views/polygons/occupancy.h"
#include "views/polygons/polygonise.h"
#include "views/voxels/truth.h"

#include <glassbox/base/rounding.h>

namespace glassbox::labs {

namespace lab_14_drawing {

constexpr int kVoxelsAlong = 40;
constexpr double kLevel = 0.5;

// ---- the reference ----

Numbers surface_polygons(RecordReader& in) {
  Numbers out;
  while (in.more()) {
    for (const auto& polygon : borders_in_cell(unsigned(in.integer()) & 255u)) {
      out.push_back(double(polygon.size()));
      out.insert(out.end(), polygon.begin(), polygon.end());
    }
    out.push_back(0);
  }
  return out;
}

Numbers surface_shares(RecordReader& in) {
  const double level = in.number();
  Numbers out;
  while (in.more()) {
    const double from = in.number();
    out.push_back(views::crossing(from, in.number(), level));
  }
  return out;
}

std::optional<WrongNumber> judge_polygons(const Numbers&, const Numbers& yours,
                                          const Numbers& reference) {
  return first_wrong(
      yours, reference, [](std::size_t) { return 0; }, "",
      [](std::size_t i) { return fmt::format("number {} of the lists", i); });
}

std::optional<WrongNumber> judge_shares(const Numbers&, const Numbers& yours,
                                        const Numbers& reference) {
  return first_wrong(
      yours, reference, [&](std::size_t i) { return 16 * unit_roundoff<double> * reference[i]; },
      "of an edge", [](std::size_t i) { return fmt::format("edge {}", i); });
}

const std::vector<DrawnStage>& surface_stages() {
  static const std::vector<DrawnStage> all{
      {"polygons", "world", "cell_polygons", surface_polygons, judge_polygons,
       in_words({{"inside corners (a bit for each) of cell", 1, kAllThatFollow}})},
      {"shares", "world", "crossing", surface_shares, judge_shares,
       in_words({{"level"}, {"values at the ends of edge", 2, kAllThatFollow}})}};
  return all;
}

// ---- in the pipeline ----

using Cell = std::array<int, 3>;

// A cell that the surface passes through.
struct CrossedCell {
  Cell at{};
  unsigned inside = 0;
};

std::vector<CrossedCell> crossed_cells(const views::ScalarField& field) {
  std::vector<CrossedCell> cells;
  for (int z = -1; z < field.count[2]; ++z) {
    for (int y = -1; y < field.count[1]; ++y) {
      for (int x = -1; x < field.count[0]; ++x) {
        unsigned inside = 0;
        for (int c = 0; c < 8; ++c)
          inside |= unsigned(field(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)) >= kLevel) << c;
        if (inside != 0 && inside != 255) cells.push_back({{x, y, z}, inside});
      }
    }
  }
  return cells;
}

// The polygons that the student's answer gives for each of `sets` sets of inside corners. Numbers
// that are no edges of a cell are ignored, and so are polygons of fewer than three edges.
std::vector<std::vector<std::vector<int>>> polygons_of(const Numbers& answer, std::size_t sets) {
  std::vector<std::vector<std::vector<int>>> all(sets);
  std::size_t at = 0;
  for (auto& polygons : all) {
    while (at < answer.size() && answer[at] > 0) {
      const auto count = std::size_t(std::min(answer[at++], 64.0));
      std::vector<int> polygon;
      for (std::size_t i = 0; i < count && at < answer.size(); ++i, ++at) {
        if (answer[at] >= 0 && answer[at] < 12) polygon.push_back(int(answer[at]));
      }
      if (polygon.size() >= 3) polygons.push_back(std::move(polygon));
    }
    ++at;
  }
  return all;
}

Result<PictureSetup> draw_surface(const DrawingInput& input, AnswerSource& answer_source) {
  const views::WorldBox box = views::box_of(input.scene);
  const auto grid =
      views::grid_of(box, views::size_for(box, kVoxelsAlong), views::Matrix3d::Identity());
  if (!grid) return tl::unexpected(grid.error());
  const views::TrueVolume truth(input.scene, *grid);
  views::Occupancy solid(*grid);
  for (int z = 0; z < grid->count[2]; ++z) {
    for (int y = 0; y < grid->count[1]; ++y) {
      for (int x = 0; x < grid->count[0]; ++x) solid.set({x, y, z}, truth.has({x, y, z}));
    }
  }
  if (solid.full() == 0)
    return fail("the scene",
                "it has no closed object, and lab 14 draws the surfaces of closed objects",
                "choose a scene with closed objects, such as cube, sphere or teapot");
  const views::ScalarField field = solid.smooth_field();
  const std::vector<CrossedCell> cells = crossed_cells(field);

  Question all_sets;
  for (int inside = 0; inside < 256; ++inside) all_sets.numbers.push_back(inside);
  const auto tables = answer_source.ask(surface_stages()[0], std::vector<Question>{all_sets});
  if (!tables) return tl::unexpected(tables.error());
  const auto table = polygons_of(tables->front(), 256);

  // The question contains every edge once, regardless of how many cells it belongs to.
  std::map<std::array<int, 4>, std::size_t> numbers;
  Question pairs{{kLevel}};
  std::vector<views::Vector3d> starts, directions;
  const auto number_of = [&](const CrossedCell& cell, int edge) {
    const views::CellEdge& e = views::kCellEdges[std::size_t(edge)];
    const int x = cell.at[0] + (e.from & 1), y = cell.at[1] + (e.from >> 1 & 1),
              z = cell.at[2] + (e.from >> 2);
    const auto [place, is_new] = numbers.try_emplace({x, y, z, e.axis}, starts.size());
    if (is_new) {
      const views::Vector3d direction = views::Vector3d::Unit(e.axis);
      starts.emplace_back(x, y, z);
      directions.push_back(direction);
      pairs.numbers.push_back(field(x, y, z));
      pairs.numbers.push_back(field(x + (e.axis == 0), y + (e.axis == 1), z + (e.axis == 2)));
    }
    return place->second;
  };
  std::vector<std::vector<std::size_t>> polygons;
  for (const CrossedCell& cell : cells) {
    for (const std::vector<int>& polygon : table[cell.inside]) {
      polygons.emplace_back();
      for (const int edge : polygon) polygons.back().push_back(number_of(cell, edge));
    }
  }
  const auto shares = answer_source.ask(surface_stages()[1], std::vector<Question>{pairs});
  if (!shares) return tl::unexpected(shares.error());

  PictureSetup made{input.scene, input.view, input.settings, nullptr, {}};
  made.settings.shading = Shading::kFlat;
  Mesh mesh;
  mesh.name = "surface";
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const double share = i < shares->front().size() ? shares->front()[i] : 0;
    const double t = std::isfinite(share) ? std::clamp(share, -1.0, 2.0) : 0;
    const views::Vector3d p = views::world_of_lattice(*grid, starts[i] + t * directions[i]);
    mesh.positions.push_back({float(p.x()), float(p.y()), float(p.z())});
  }
  // Each polygon is divided into a fan of triangles, because its corners may not be in one plane.
  for (const std::vector<std::size_t>& polygon : polygons) {
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      mesh.faces.push_back({std::uint32_t(mesh.corners.size()), 3});
      for (const std::size_t corner : {polygon[0], polygon[k], polygon[k + 1]})
        mesh.corners.push_back({std::uint32_t(corner), kNone, kNone, kNone});
    }
  }
  made.scene.meshes = {std::move(mesh)};
  made.scene.nodes = {Node{}};
  made.scene.instances = {{0, 0}};
  made.scene.materials = {Material{}};
  made.scene.textures.clear();
  made.scene.images.clear();
  return made;
}

PictureSetup surface_truth(const DrawingInput& input) {
  return {input.scene, input.view, input.settings, nullptr, {}};
}

}  // namespace lab_14_drawing

LabDrawing drawing_14() {
  using namespace lab_14_drawing;
  return {.stages = surface_stages(),
          .draw = draw_surface,
          .not_drawn = "add, remove, view_weights, statistics, reconstruct",
          .truth = surface_truth};
}

}  // namespace glassbox::labs
