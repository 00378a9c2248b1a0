// Voxel colouring (Seitz and Dyer 1997): the voxels of a box that have one colour in all pictures that see them (S1-15 to S1-21), in an
// order in which what hides is decided before what it hides; and space carving (Kutulakos and Seitz 2000) where there is no such
// order.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

#include "views/rings/picture_set.h"
#include "views/voxels/grid.h"
#include "views/voxels/settings.h"
#include "views/voxels/sweep.h"
#include "views/voxels/traversal.h"

namespace glassbox::views {

enum class Order {
  kAuto,   // a sweep where the cameras allow one, else carving
  kSweep,  // one sweep, even where it is wrong (C-90)
  kCarve,  // sweeps along all six directions, each with the cameras before its plane, until nothing is carved any more
};
std::string_view name_of(Order order);

struct ColoringRequest {
  WorldBox box;
  double voxel_size = 1;
  std::string size_option = kVoxelOption;  // what asks for that size, which refusals of it name
  Order order = Order::kAuto;
  // Of kSweep: the axis, 0 .. 2, and 1 or -1; absent: as classify() says, along the z axis of the surrounded.
  std::optional<std::array<int, 2>> direction;
  ColoringSettings settings;
  int levels = 0;        // coarse to fine: so many halvings before the voxels asked for; 0: none
  double slack = 2;      // what the threshold is multiplied by at coarser levels
  int most_passes = 20;  // of kCarve, each of six sweeps
  std::uint64_t most_bytes = std::uint64_t(1) << 32;
};

// What was judged: its layer in the order of visiting and the verdicts of its voxels.
using LayerWatcher = std::function<void(int layer, std::span<const VoxelRun> runs,
                                        std::span<const Verdict> verdicts)>;

// A request with what it leaves open decided: how its voxels are visited.
struct ColoringPlan {
  VoxelGrid grid;
  TraversalKind traversal = TraversalKind::kHalfSpace;
  Order order = Order::kSweep;         // kSweep or kCarve
  bool in_shells = false;              // of a sweep: outwards around the cameras, not by planes
  std::array<int, 2> direction{2, 1};  // of a sweep by planes: an axis of the grid, and 1 or -1
  std::uint64_t bytes = 0;             // of all that grows with pictures and voxels
};

struct Coloring : ColoringPlan {
  int layers = 0, passes = 0;
  bool is_finished = true;         // of carving: the last pass carved nothing
  std::int64_t judged = 0;         // voxels of the finest level
  std::int64_t judged_coarse = 0;  // of the levels before it
  VerdictCounts counts{};  // of the finest level; of carving, those of the surface that remains
  std::vector<ColoredVoxel> voxels;
  std::vector<VoxelRun> solid;  // what carving leaves, its inside too
  double milliseconds = 0;      // of the whole, packing of the pictures included
};

// Refused: what grid_of refuses, fewer than one picture, cameras whose numbers leave the range of floats, a direction or coarser levels
// where voxels are carved, and what would take more than `most_bytes`, computed before anything of it is taken. Counted are the pictures
// as they were read and as they are swept with their tiles, a layer, and as many coloured voxels as the box has at its six sides; how many there will
// be, nobody knows before.
Result<ColoringPlan> plan_coloring(const PictureSet& set, const ColoringRequest& request);

// `watch` is called for each layer of the finest level; carving has no layers that could be watched.
Coloring color_voxels(const PictureSet& set, const ColoringRequest& request,
                      const ColoringPlan& plan, const LayerWatcher& watch = {});

// Both.
Result<Coloring> color_voxels(const PictureSet& set, const ColoringRequest& request,
                              const LayerWatcher& watch = {});

}  // namespace glassbox::views
