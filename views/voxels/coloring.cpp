#include "views/voxels/coloring.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "views/voxels/blocks.h"
#include "views/voxels/carving.h"
#include "views/voxels/layers_of.h"
#include "views/voxels/pyramid.h"

namespace glassbox::views {

namespace {

using Clock = std::chrono::steady_clock;

std::vector<Vector3d> eyes_of(const PictureSet& set) {
  std::vector<Vector3d> eyes;
  for (const CalibratedPicture& picture : set.pictures) eyes.push_back(picture.camera.centre);
  return eyes;
}

// What the request leaves open, decided.
struct Plan {
  Traversal traversal;
  Order order;
  std::array<int, 2> direction{2, 1};
  Matrix3d axes = Matrix3d::Identity();
};

Plan plan_of(const PictureSet& set, const ColoringRequest& request) {
  Plan plan{classify(eyes_of(set), request.box.low, request.box.high), request.order};
  const bool has_order = plan.traversal.kind != TraversalKind::kSurrounded;
  if (plan.order == Order::kAuto) plan.order = has_order ? Order::kSweep : Order::kCarve;
  if (request.direction) {
    plan.direction = *request.direction;
  } else if (plan.order == Order::kSweep && plan.traversal.kind == TraversalKind::kOblique) {
    plan.axes = axes_along(*plan.traversal.direction);
  } else if (plan.traversal.direction && plan.traversal.kind != TraversalKind::kOblique) {
    int axis = 0;
    plan.traversal.direction->cwiseAbs().maxCoeff(&axis);
    plan.direction = {axis, plan.traversal.away[std::size_t(axis)]};
  }
  return plan;
}

// What grows: words, deviations and RGB of pictures, smaller ones of coarser levels, the verdicts and sums of one layer, the bits of
// carving and the depths that its surface is found with, the bytes of coarser cells.
double bytes_needed(const PictureSet& set, const ColoringRequest& request, const VoxelGrid& grid,
                    Order order) {
  double pixels = 0;
  for (const CalibratedPicture& picture : set.pictures)
    pixels += double(picture.color.pixels.size());
  double of_pixel = 4;
  if (wants_spread(request.settings)) of_pixel += 4;
  if (request.settings.space != ColorSpace::kRgb) of_pixel += 4;
  if (request.levels > 0) of_pixel *= 4.0 / 3;
  const auto [nx, ny, nz] = grid.count;
  const double layer = std::max({double(nx) * ny, double(ny) * nz, double(nz) * nx});
  double bytes = of_pixel * pixels + layer;
  if (order == Order::kCarve) bytes += double(grid.voxels()) / 8 + 4 * pixels;
  if (request.levels > 0) bytes += double(grid.voxels()) / 8 * 2;
  return bytes;
}

Result<void> check_request(const PictureSet& set, const ColoringRequest& request,
                           const VoxelGrid& grid, Order order) {
  constexpr int kMostLevels = 6;
  if (request.levels < 0 || request.levels > kMostLevels)
    return fail("--levels", fmt::format("coarser levels are 0 to {}", kMostLevels), "give 2");
  const double bytes = bytes_needed(set, request, grid, order);
  if (bytes <= double(request.most_bytes)) return {};
  return fail("--voxel",
              fmt::format("{} x {} x {} voxels and {} pictures would take {:.0f} MB, and {} MB are "
                          "allowed",
                          grid.count[0], grid.count[1], grid.count[2], set.pictures.size(),
                          bytes / 1048576, request.most_bytes >> 20),
              "take larger voxels, or allow more with --max-mb");
}

void add_voxels(const Sweep& sweep, std::vector<ColoredVoxel>& voxels) {
  for (std::size_t i = 0; i < sweep.colored().size(); ++i) {
    const Seen& seen = sweep.seen()[i];
    voxels.push_back({sweep.colored()[i], seen.color, std::uint16_t(std::min(seen.views, 65535)),
                      float(std::sqrt(seen.sums.variance()) / kCodesPerLevel)});
  }
}

std::vector<PackedPicture> packed(const std::vector<CalibratedPicture>& pictures,
                                  const ColoringSettings& settings) {
  std::vector<PackedPicture> all(pictures.size());
  for_blocks(pictures.size(), settings.threads,
             [&](std::size_t i) { all[i] = pack(pictures[i], settings); });
  return all;
}

// One sweep over a grid: of all its voxels, or of those that `cells` of the coarser level leave.
void run_sweep(const VoxelGrid& grid, std::vector<PackedPicture>& pictures,
               const ColoringSettings& settings, const ColoringRequest& request, const Plan& plan,
               const std::vector<Vector3d>& eyes, const Cells* cells, const LayerWatcher& watch,
               Coloring& result) {
  Sweep sweep(grid, pictures, settings);
  const bool in_shells = plan.traversal.kind == TraversalKind::kEmbedded && !request.direction;
  const PlaneLayers planes(grid, plan.direction);
  const ShellLayers shells(grid, eyes);
  result.layers = in_shells ? shells.count() : planes.count();
  for (int k = 0; k < result.layers; ++k) {
    std::vector<VoxelRun> runs = in_shells ? shells.runs(k) : planes.runs(k, request.box);
    if (cells != nullptr) runs = cells->finer(runs);
    sweep.layer(runs, {}, Occluders::kColored);
    for (const Verdict verdict : sweep.verdicts()) ++result.counts[std::size_t(verdict)];
    result.judged += std::int64_t(sweep.verdicts().size());
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

// Prock and Dyer (1998): coarse voxels are coloured from pictures of their own size, and only those that were, and what is around
// them, are looked at again. A threshold of `slack` times leaves room for what a coarse voxel mixes.
void run_levels(const PictureSet& set, const ColoringRequest& request, const Plan& plan,
                const LayerWatcher& watch, Coloring& result) {
  const std::vector<Vector3d> eyes = eyes_of(set);
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
  std::optional<Cells> cells;
  ColoringSettings settings = request.settings;
  settings.threshold *= request.slack;
  settings.noise *= request.slack;
  settings.k2 *= request.slack;
  settings.alone = Alone::kKeep;
  for (int level = request.levels; level > 0; --level) {
    Coloring coarse;
    const auto at = std::size_t(level);
    run_sweep(grids[at], pictures[at], settings, request, plan, eyes, cells ? &*cells : nullptr, {},
              coarse);
    result.judged_coarse += coarse.judged;
    cells.emplace(grids[at]);
    for (const ColoredVoxel& voxel : coarse.voxels) cells->set(voxel.at);
    cells->grow();
  }
  run_sweep(result.grid, pictures[0], request.settings, request, plan, eyes,
            cells ? &*cells : nullptr, watch, result);
}

}  // namespace

std::string_view name_of(Order order) {
  return order == Order::kAuto ? "auto" : order == Order::kSweep ? "sweep" : "carve";
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
std::string_view name_of(Update update) {
  return update == Update::kLayer ? "layer" : "voxel";
}
std::string_view name_of(Alone alone) {
  return alone == Alone::kReject ? "reject" : "keep";
}

Result<VoxelGrid> grid_for(const PictureSet& set, const ColoringRequest& request) {
  if (set.pictures.empty()) return fail("the pictures", "there are none", "give some");
  return grid_of(request.box, request.voxel_size, plan_of(set, request).axes);
}

Result<Coloring> color_voxels(const PictureSet& set, const ColoringRequest& request,
                              const LayerWatcher& watch) {
  const Clock::time_point start = Clock::now();
  const auto grid = grid_for(set, request);
  if (!grid) return tl::unexpected(grid.error());
  const Plan plan = plan_of(set, request);
  if (const auto legal = check_request(set, request, *grid, plan.order); !legal)
    return tl::unexpected(legal.error());
  Coloring result;
  result.grid = *grid;
  result.traversal = plan.traversal.kind;
  result.order = plan.order;
  result.direction = plan.direction;
  result.bytes = std::uint64_t(bytes_needed(set, request, *grid, plan.order));
  if (plan.order == Order::kCarve) {
    std::vector<PackedPicture> pictures = packed(set.pictures, request.settings);
    carve(pictures, request, result);
  } else {
    run_levels(set, request, plan, watch, result);
    result.passes = 1;
  }
  result.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  return result;
}

}  // namespace glassbox::views
