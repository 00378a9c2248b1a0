#include "views/voxels/coloring.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include <glassbox/base/elapsed.h>

#include "views/voxels/blocks.h"
#include "views/voxels/carving.h"
#include "views/voxels/pyramid.h"
#include "views/voxels/voxel_layers.h"

namespace glassbox::views {

namespace {

using Clock = std::chrono::steady_clock;

std::vector<Vector3d> eyes_of(const PictureSet& set) {
  std::vector<Vector3d> eyes;
  for (const CalibratedPicture& picture : set.pictures) eyes.push_back(picture.camera.centre);
  return eyes;
}

// The plan of a request, and the axes that its grid needs.
struct Visit {
  ColoringPlan plan;
  Matrix3d axes = Matrix3d::Identity();
};

Visit visit_of(const PictureSet& set, const ColoringRequest& request) {
  const Traversal traversal = classify(eyes_of(set), request.box.low, request.box.high);
  Visit visit;
  ColoringPlan& plan = visit.plan;
  plan.traversal = traversal.kind;
  plan.order = request.order;
  const bool has_order = traversal.kind != TraversalKind::kSurrounded;
  if (plan.order == ColoringOrder::kAuto)
    plan.order = has_order ? ColoringOrder::kSweep : ColoringOrder::kCarve;
  if (plan.order == ColoringOrder::kCarve) return visit;
  plan.in_shells = traversal.kind == TraversalKind::kEmbedded && !request.direction;
  if (request.direction) {
    plan.direction = *request.direction;
  } else if (traversal.kind == TraversalKind::kOblique) {
    visit.axes = axes_along(*traversal.direction);
  } else if (traversal.direction) {
    int axis = 0;
    traversal.direction->cwiseAbs().maxCoeff(&axis);
    plan.direction = {axis, traversal.away[std::size_t(axis)]};
  }
  return visit;
}

double layer_voxels(const VoxelGrid& grid) {
  const auto [nx, ny, nz] = grid.count;
  return std::max({double(nx) * ny, double(ny) * nz, double(nz) * nx});
}

// Memory for the pictures. A pixel has its colour and its matte as it was read; for the sweep it
// has a word, and on demand a deviation and RGB. The smaller pictures of coarser levels need a
// third of that. The depths that find a carved surface are made for one picture after the other.
double picture_bytes(const PictureSet& set, const ColoringRequest& request, ColoringOrder order) {
  double tiles = 0, largest = 0;
  for (const CalibratedPicture& picture : set.pictures) {
    tiles += PixelTiles::bytes_for(picture.color.width, picture.color.height);
    largest = std::max(largest, double(picture.color.pixels.size()));
  }
  double of_pixel = sizeof(std::uint32_t);
  if (wants_spread(request.settings)) of_pixel += sizeof(std::uint32_t);
  if (request.settings.space != ColorSpace::kRgb) of_pixel += sizeof(Rgba8);
  if (request.levels > 0) of_pixel *= 4.0 / 3;
  return bytes_of(set) + of_pixel * pixels_of(set) + tiles +
         (order == ColoringOrder::kCarve ? largest * double(sizeof(float)) : 0);
}

double bytes_needed(const PictureSet& set, const ColoringRequest& request,
                    const ColoringPlan& plan) {
  const VoxelGrid& grid = plan.grid;
  const auto [nx, ny, nz] = grid.count;
  const double surface = 2 * (double(nx) * ny + double(ny) * nz + double(nz) * nx);
  double bytes = picture_bytes(set, request, plan.order) + surface * double(sizeof(ColoredVoxel)) +
                 layer_voxels(grid) *
                     double(sizeof(Verdict) + sizeof(VoxelObservation) + sizeof(VoxelPosition));
  if (plan.order == ColoringOrder::kCarve) bytes += carving_bytes(grid, surface);
  // A byte for each voxel of the next coarser level, and a copy of it while the marked voxels are
  // grown.
  if (request.levels > 0) bytes += double(grid.voxels()) / 8 * 2;
  return bytes;
}

Result<void> check_request(const PictureSet& set, const ColoringRequest& request,
                           const ColoringPlan& plan) {
  constexpr int kMaxLevels = 6;
  if (request.levels < 0 || request.levels > kMaxLevels)
    return fail("--levels", fmt::format("the number of coarser levels must be 0 to {}", kMaxLevels),
                "give 2");
  if (plan.order == ColoringOrder::kCarve && (request.levels > 0 || request.direction)) {
    return fail(
        request.levels > 0 ? "--levels" : "--direction",
        request.order == ColoringOrder::kCarve
            ? "this option is for a single sweep, but carving sweeps along all six directions"
            : "this option is for a single sweep, but cameras all around the box need carving",
        "leave it out, or ask for --order sweep");
  }
  for (const CalibratedPicture& picture : set.pictures) {
    const GridPicture lens = grid_picture(plan.grid, projection_of(picture.camera),
                                          picture.color.width, picture.color.height);
    if (is_finite(lens)) continue;
    if (projection_of(picture.camera).cast<float>().allFinite())
      return fail("--box",
                  "the box is so large that its voxels cannot be projected into the pictures",
                  "give a smaller box, in the same unit as the positions of the cameras");
    return fail(
        picture.name,
        "the numbers of its camera are so large that voxels cannot be projected into the picture",
        "give the camera's intrinsic matrix K, rotation R and translation t in the unit of the "
        "box");
  }
  const double bytes = double(plan.bytes);
  if (bytes <= double(request.most_bytes)) return {};
  return fail(
      request.size_option,
      fmt::format("{} x {} x {} voxels and {} pictures take {:.0f} MB, but {} MB are allowed",
                  plan.grid.count[0], plan.grid.count[1], plan.grid.count[2], set.pictures.size(),
                  std::ceil(bytes / 1048576), request.most_bytes >> 20),
      "use larger voxels, or allow more with --max-mb");
}

void add_voxels(const Sweep& sweep, std::vector<ColoredVoxel>& voxels) {
  for (std::size_t i = 0; i < sweep.colored().size(); ++i) {
    const VoxelObservation& seen = sweep.observations()[i];
    voxels.push_back({sweep.colored()[i], seen.color, std::uint16_t(std::min(seen.views, 65535)),
                      float(std::sqrt(seen.sums.variance()) / kCodesPerLevel)});
  }
}

std::vector<PackedPicture> packed(const std::vector<CalibratedPicture>& pictures,
                                  const ColoringSettings& settings) {
  std::vector<PackedPicture> all(pictures.size());
  for_blocks(pictures.size(), settings.threads,
             [&](std::size_t i) { all[i] = pack_picture(pictures[i], settings); });
  return all;
}

// One sweep over a grid: over all its voxels, or only over those in the `cells` of the coarser
// level.
void run_sweep(const VoxelGrid& grid, std::vector<PackedPicture>& pictures,
               const ColoringSettings& settings, const std::vector<double>& ratios,
               const ColoringRequest& request, const std::vector<Vector3d>& eyes,
               const CellMask* cells, const LayerWatcher& watch, Coloring& result) {
  Sweep sweep(grid, pictures, settings, ratios);
  const PlaneLayers planes(grid, result.direction);
  const ShellLayers shells(grid, eyes);
  result.layers = result.in_shells ? shells.count() : planes.count();
  for (int k = 0; k < result.layers; ++k) {
    std::vector<VoxelRun> runs = result.in_shells ? shells.runs(k) : planes.runs(k, request.box);
    if (cells != nullptr) runs = cells->refined(runs);
    sweep.layer(runs, {}, Occluders::kColored);
    for (const Verdict verdict : sweep.verdicts()) ++result.counts[std::size_t(verdict)];
    result.examined += std::int64_t(sweep.verdicts().size());
    add_voxels(sweep, result.voxels);
    if (watch) watch(k, runs, sweep.verdicts());
  }
}

VoxelGrid coarser(const VoxelGrid& grid) {
  VoxelGrid half = grid;
  half.size *= 2;
  for (int& count : half.count) count = (count + 1) / 2;
  return half;
}

// Coarse to fine (Prock and Dyer 1998): coarse voxels are coloured from pictures of reduced size,
// and only the coloured ones and their neighbours are examined at the next level. The threshold is
// multiplied by `slack`, because a coarse voxel mixes several colours.
void run_levels(const PictureSet& set, const ColoringRequest& request, const LayerWatcher& watch,
                Coloring& result) {
  const std::vector<Vector3d> eyes = eyes_of(set);
  const std::vector<double> ratios = likelihood_ratios(request.settings);
  std::vector<VoxelGrid> grids{result.grid};
  std::vector<std::vector<PackedPicture>> pictures(1);
  pictures[0] = packed(set.pictures, request.settings);
  for (int level = 1; level <= request.levels; ++level) {
    grids.push_back(coarser(grids.back()));
    std::vector<PackedPicture> halves(set.pictures.size());
    for_blocks(halves.size(), request.settings.threads,
               [&](std::size_t i) { halves[i] = half_size(pictures.back()[i]); });
    pictures.push_back(std::move(halves));
  }
  std::optional<CellMask> cells;
  ColoringSettings settings = request.settings;
  settings.threshold *= request.slack;
  settings.noise *= request.slack;
  settings.k2 *= request.slack;
  settings.alone = SingleViewPolicy::kKeep;
  for (int level = request.levels; level > 0; --level) {
    Coloring coarse;
    coarse.in_shells = result.in_shells;
    coarse.direction = result.direction;
    const auto at = std::size_t(level);
    run_sweep(grids[at], pictures[at], settings, ratios, request, eyes, cells ? &*cells : nullptr,
              {}, coarse);
    result.examined_coarse += coarse.examined;
    cells.emplace(grids[at]);
    for (const ColoredVoxel& voxel : coarse.voxels) cells->set(voxel.at);
    cells->grow();
  }
  run_sweep(result.grid, pictures[0], request.settings, ratios, request, eyes,
            cells ? &*cells : nullptr, watch, result);
}

}  // namespace

std::string_view name_of(ColoringOrder order) {
  return order == ColoringOrder::kAuto    ? "auto"
         : order == ColoringOrder::kSweep ? "sweep"
                                          : "carve";
}

std::string_view name_of(Consistency consistency) {
  return consistency == Consistency::kDeviation    ? "sigma"
         : consistency == Consistency::kLikelihood ? "ratio"
                                                   : "adaptive";
}
std::string_view name_of(ColorSpace space) {
  return space == ColorSpace::kRgb ? "rgb" : "lab";
}
std::string_view name_of(Footprint footprint) {
  return footprint == Footprint::kCentre ? "centre" : footprint == Footprint::kBox ? "box" : "hull";
}
std::string_view name_of(OcclusionUpdate update) {
  return update == OcclusionUpdate::kLayer ? "layer" : "voxel";
}
std::string_view name_of(SingleViewPolicy alone) {
  return alone == SingleViewPolicy::kReject ? "reject" : "keep";
}

Result<ColoringPlan> plan_coloring(const PictureSet& set, const ColoringRequest& request) {
  if (set.pictures.empty())
    return fail("the pictures", "there are none", "give at least one picture");
  Visit visit = visit_of(set, request);
  auto grid = grid_of(request.box, request.voxel_size, visit.axes);
  if (!grid) {
    if (grid.error().place == kVoxelOption) grid.error().place = request.size_option;
    return tl::unexpected(std::move(grid.error()));
  }
  visit.plan.grid = *grid;
  visit.plan.bytes = std::uint64_t(bytes_needed(set, request, visit.plan));
  if (const auto legal = check_request(set, request, visit.plan); !legal)
    return tl::unexpected(legal.error());
  return visit.plan;
}

Coloring color_voxels(const PictureSet& set, const ColoringRequest& request,
                      const ColoringPlan& plan, const LayerWatcher& watch) {
  const Clock::time_point start = Clock::now();
  Coloring result;
  static_cast<ColoringPlan&>(result) = plan;
  if (plan.order == ColoringOrder::kCarve) {
    std::vector<PackedPicture> pictures = packed(set.pictures, request.settings);
    carve(pictures, request, result);
  } else {
    run_levels(set, request, watch, result);
    result.passes = 1;
  }
  result.milliseconds = elapsed_ms(start);
  return result;
}

Result<Coloring> color_voxels(const PictureSet& set, const ColoringRequest& request,
                              const LayerWatcher& watch) {
  return plan_coloring(set, request).map([&](const ColoringPlan& plan) {
    return color_voxels(set, request, plan, watch);
  });
}

}  // namespace glassbox::views
