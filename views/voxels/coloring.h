// Voxel colouring (Seitz and Dyer 1997): finds the voxels of a box that have one colour in all
// pictures that see them (S1-15 to S1-21). Voxels are visited in an order in which a voxel is
// decided before those that it may hide. Where there is no such order, space carving is used
// (Kutulakos and Seitz 2000).
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

enum class ColoringOrder {
  kAuto,   // a sweep if the cameras allow one, else carving
  kSweep,  // one sweep, even if its result is wrong for these cameras (C-90)
  // Sweeps along all six directions, each with the cameras that its plane has already passed, until
  // nothing more is carved.
  kCarve,
};
std::string_view name_of(ColoringOrder order);

struct ColoringRequest {
  WorldBox box;
  double voxel_size = 1;
  // The option that asks for this size; error messages name it.
  std::string size_option = kVoxelOption;
  ColoringOrder order = ColoringOrder::kAuto;
  // For kSweep: the axis along which it goes, 0 .. 2, and its sign, 1 or -1. If absent, it is
  // chosen by classify(), or is the z axis if the cameras surround the scene.
  std::optional<std::array<int, 2>> direction;
  ColoringSettings settings;
  // Coarse to fine: number of coarser levels, each with voxels twice as large; 0: none.
  int levels = 0;
  double slack = 2;      // factor of the threshold at coarser levels
  int most_passes = 20;  // for kCarve; each pass has six sweeps
  std::uint64_t most_bytes = std::uint64_t(1) << 32;
};

// Called with a layer that was classified: its number in the order of visiting, its voxels, and
// their verdicts.
using LayerWatcher = std::function<void(int layer, std::span<const VoxelRun> runs,
                                        std::span<const Verdict> verdicts)>;

// How the voxels are visited: the choices of the request, and decisions for everything that it
// leaves open.
struct ColoringPlan {
  VoxelGrid grid;
  TraversalKind traversal = TraversalKind::kHalfSpace;
  ColoringOrder order = ColoringOrder::kSweep;  // kSweep or kCarve
  bool in_shells = false;  // for a sweep: outwards around the cameras instead of by planes
  std::array<int, 2> direction{2, 1};  // for a sweep by planes: an axis of the grid, and 1 or -1
  std::uint64_t bytes = 0;  // memory for everything whose size depends on the pictures and voxels
};

struct Coloring : ColoringPlan {
  int layers = 0, passes = 0;
  bool is_finished = true;           // for carving: the last pass carved nothing
  std::int64_t examined = 0;         // voxels of the finest level
  std::int64_t examined_coarse = 0;  // voxels of the coarser levels
  // How often each verdict was given, at the finest level or, for carving, on the surface that
  // remains.
  VerdictCounts counts{};
  std::vector<ColoredVoxel> voxels;
  std::vector<VoxelRun> solid;  // all voxels that carving leaves, the interior included
  double milliseconds = 0;      // in total, including the packing of the pictures
};

// An error for everything that grid_of refuses, for an empty list of pictures, for cameras whose
// numbers are too large for float, for a direction or coarser levels together with carving, and for
// anything that would need more than `most_bytes`. The memory is computed before any of it is
// allocated: for the pictures as they were read, for the pictures as they are swept with their
// tiles, for one layer, and for as many coloured voxels as the box has at its six sides; their real
// number is not known in advance.
Result<ColoringPlan> plan_coloring(const PictureSet& set, const ColoringRequest& request);

// Colours the voxels of a plan. `watch` is called for each layer of the finest level; carving has
// no layers to watch.
Coloring color_voxels(const PictureSet& set, const ColoringRequest& request,
                      const ColoringPlan& plan, const LayerWatcher& watch = {});

// Makes the plan and colours its voxels.
Result<Coloring> color_voxels(const PictureSet& set, const ColoringRequest& request,
                              const LayerWatcher& watch = {});

}  // namespace glassbox::views
