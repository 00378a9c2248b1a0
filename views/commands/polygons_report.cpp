#include "views/commands/polygons_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/exit_codes.h"
#include "views/commands/picture_choice.h"
#include "views/polygons/mesh_scene.h"
#include "views/texture/unlit_renderer.h"
#include "views/voxels/truth.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/mesh/gltf/write.h>

namespace glassbox::views {

namespace {

using PolygonsJson = nlohmann::ordered_json;

double iou_of(const views::Occupancy& solid, const views::TrueVolume& truth) {
  const auto& count = solid.grid().count;
  views::Overlap overlap(truth);
  for (int z = 0; z < count[2]; ++z) {
    for (int y = 0; y < count[1]; ++y) {
      for (int x = 0; x < count[0]; ++x) {
        const views::VoxelPosition at{x, y, z};
        if (solid.has(at)) overlap.add(at);
      }
    }
  }
  return overlap.iou();
}

// An estimate of the number of polygons, which is not known in advance: two for each face of a
// voxel on the box's six sides.
double polygons_of_box(const views::VoxelGrid& grid) {
  const auto [nx, ny, nz] = grid.count;
  return 4 * (double(nx) * ny + double(ny) * nz + double(nz) * nx);
}

// An upper bound of the memory in bytes for all outputs, in addition to colouring the voxels and
// the polygons. All data are counted as if they existed at the same time.
double extra_bytes(const PolygonsInput& input, const PolygonsRequest& request,
                   const views::VoxelGrid& grid, double polygons) {
  double bytes =
      views::Occupancy::bytes_for(grid) +
      polygons * (views::kBytesOfScenePolygon + (request.writes_glb ? kGlbBytesOfTriangle : 0));
  if (input.truth) bytes += views::TrueVolume::bytes_for(grid);
  if (input.pictures.left_out) {
    bytes += views::bytes_of(*input.pictures.left_out) +
             views::UnlitRenderer::bytes_for(polygons,
                                             double(input.pictures.left_out->color.pixels.size()));
  }
  return bytes;
}

}  // namespace

Result<PolygonsReport> report_polygons(const PolygonsInput& input, const PolygonsRequest& request,
                                       Progress& progress) {
  const views::PictureSet& set = input.pictures.set;
  const auto plan = views::plan_coloring(set, request.voxels);
  if (!plan) return tl::unexpected(plan.error());
  const views::VoxelGrid& grid = plan->grid;
  if (const auto legal = views::check_floats(grid); !legal) return tl::unexpected(legal.error());
  const double expected = polygons_of_box(grid);
  PolygonsReport report;
  report.bytes = std::uint64_t(double(plan->bytes) + extra_bytes(input, request, grid, expected) +
                               views::polygon_bytes(grid, expected) + views::layer_bytes(set));
  const auto legal = check_memory(
      "--resolution",
      fmt::format("{} x {} x {} voxels, their polygons and the layered images of {} pictures",
                  grid.count[0], grid.count[1], grid.count[2], set.pictures.size()),
      double(report.bytes), request.voxels.most_bytes);
  if (!legal) return tl::unexpected(legal.error());
  progress.phase("colouring voxels");
  views::Occupancy solid(grid);
  {
    const views::Coloring voxels = views::color_voxels(
        set, request.voxels, *plan,
        [&](int, std::span<const views::VoxelRun> runs, std::span<const views::Verdict> verdicts) {
          solid.fill(runs, verdicts);
        });
    for (const views::VoxelRun& run : voxels.solid) solid.fill(run);
    report.voxel_milliseconds = voxels.milliseconds;
    report.colored_voxels = voxels.voxels.size();
  }

  progress.phase("colouring polygons");
  views::PolygonColoringSettings settings = request.polygons;
  settings.most_bytes =
      double(request.voxels.most_bytes) - views::bytes_of(set) - views::Occupancy::bytes_for(grid);
  auto coloring = views::color_polygons(set, solid, settings);
  if (!coloring) return tl::unexpected(coloring.error());
  report.coloring = std::move(*coloring);
  // The memory is checked again, because the layered images are freed now and the number of
  // polygons is known.
  const auto polygons = double(report.coloring.mesh.polygons.size());
  const double bytes = views::bytes_of(set) + views::polygon_bytes(grid, polygons) +
                       extra_bytes(input, request, grid, polygons);
  const auto fits = check_memory(
      "--max-mb", fmt::format("a scene of {} polygons", report.coloring.mesh.polygons.size()),
      bytes, request.voxels.most_bytes);
  if (!fits) return tl::unexpected(fits.error());
  report.bytes = std::max(report.bytes, std::uint64_t(bytes));
  report.check = views::check_mesh(report.coloring.mesh);
  auto scene = views::scene_of(report.coloring);
  if (!scene) return tl::unexpected(scene.error());
  report.scene = std::move(*scene);
  if (input.pictures.left_out) {
    const views::CalibratedPicture& left_out = *input.pictures.left_out;
    auto drawn = views::UnlitRenderer(report.scene)
                     .draw(left_out.camera, left_out.color.width, left_out.color.height);
    if (!drawn) return tl::unexpected(drawn.error());
    report.drawn = views::TexturedPicture{std::move(drawn->color), std::move(drawn->id)};
    report.left_out = views::textured_picture_errors(*report.drawn, left_out);
  }
  if (input.truth) {
    progress.phase("computing which voxels are inside the scene");
    const views::TrueVolume truth(*input.truth, grid);
    report.iou_before = iou_of(solid, truth);
    report.iou = iou_of(report.coloring.solid, truth);
  }
  return report;
}

std::string polygons_text(const PolygonsInput& input, const PolygonsReport& report) {
  const views::PolygonColoring& coloring = report.coloring;
  const views::MeshCheck& check = report.check;
  std::string text = fmt::format(
      "{}: {}\n"
      "voxels: {} full of {}, {} of them coloured, in {:.1f} ms\n"
      "polygons: {} with {} corners, {} edges shared by exactly two of them; Euler {}, {:.6g} "
      "voxels inside\n"
      "carved: {} voxels behind polygons of several colours ({} times a voxel was kept because the "
      "pictures fit no better without it), {} outside the object; {} polygons tested, {:.1f} ms\n"
      "layered images: {} samples of polygon and distance; {} MB\n",
      printable(input.pictures.set.source, kLongestMessage),
      counted(input.pictures.set.pictures.size(), "picture"), coloring.full_before,
      coloring.grid.voxels(), report.colored_voxels, report.voxel_milliseconds,
      coloring.mesh.polygons.size(), check.corners,
      check.edges - check.holes - check.non_manifold_edges, check.euler, check.volume,
      coloring.carved_by_color, coloring.kept, coloring.carved_by_background, coloring.examined,
      coloring.milliseconds, coloring.samples, (report.bytes + (1u << 20) - 1) >> 20);
  if (report.left_out) text += left_out_text(input.pictures.left_out->name, *report.left_out);
  if (report.iou)
    text += fmt::format("compared with the truth: IoU {:.4f}, and before carving {:.4f}\n",
                        *report.iou, *report.iou_before);
  if (coloring.unseen > 0)
    text += fmt::format(
        "Left out: the pictures' colours of {} that no picture shows. Such a polygon has its "
        "neighbours' colours.\n",
        counted(coloring.unseen, "polygon"));
  return text;
}

nlohmann::ordered_json polygons_json(const PolygonsInput& input, const PolygonsReport& report) {
  const views::PolygonColoring& coloring = report.coloring;
  const views::MeshCheck& check = report.check;
  PolygonsJson json{
      {"cameras", input.pictures.set.source},
      {"pictures", input.pictures.set.pictures.size()},
      {"count", {coloring.grid.count[0], coloring.grid.count[1], coloring.grid.count[2]}},
      {"voxel", coloring.grid.size},
      {"full_before", coloring.full_before},
      {"full", coloring.full},
      {"carved_by_color", coloring.carved_by_color},
      {"kept", coloring.kept},
      {"carved_by_background", coloring.carved_by_background},
      {"judged", coloring.examined},
      {"polygons", coloring.mesh.polygons.size()},
      {"unseen", coloring.unseen},
      {"corners", check.corners},
      {"edges", check.edges},
      {"closed", check.is_closed()},
      {"degenerate", check.degenerate},
      {"duplicates", check.duplicates},
      {"euler", check.euler},
      {"volume", check.volume},
      {"samples", coloring.samples},
      {"bytes", report.bytes},
      {"voxel_ms", report.voxel_milliseconds},
      {"ms", coloring.milliseconds}};
  if (report.left_out)
    json["left_out"] = left_out_json(input.pictures.left_out->name, *report.left_out);
  if (report.iou) json["truth"] = {{"iou", *report.iou}, {"iou_before", *report.iou_before}};
  return json;
}

}  // namespace glassbox::views
