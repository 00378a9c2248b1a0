// The surface of a solid of voxels in a ring of pictures, kept up to date while voxels are taken away (S1-39): each picture has its layered
// image of polygon ids, and an edit touches the polygons of eight cells alone.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "views/polygons/id_layers.h"
#include "views/polygons/occupancy.h"
#include "views/rings/picture_set.h"

namespace glassbox::views {

// A cell has the centres of eight voxels as corners: (x, y, z) to (x + 1, y + 1, z + 1). From -1 on.
struct CellAt {
  int x = 0, y = 0, z = 0;
};

struct WorldPolygon {
  PolygonId id = 0;
  Corners3d corners;  // world, counter-clockwise seen from outside
};

// A polygon's number says where it is: it is that of its cell times eight, and its place in the cell. What is built anew has the same ones.
class LiveSurface {
public:
  static constexpr int kMostOfCell = 8;

  // The surface lies half way between full and empty voxels. The pictures must outlive it. `threads`: 0: all; nothing depends on it. If the
  // layered images take more than `most_bytes`, no more polygons are put into them, and it may only be destroyed.
  LiveSurface(const PictureSet& set, const Occupancy& occupancy, int threads = 0,
              double most_bytes = std::numeric_limits<double>::infinity());

  double layer_bytes() const;

  const Occupancy& occupancy() const { return occupancy_; }
  const std::vector<IdLayers>& layers() const { return layers_; }  // of each picture

  CellAt cell_of(PolygonId id) const;
  WorldPolygon polygon(PolygonId id) const;
  // Whether the surface has it.
  bool has(PolygonId id) const;
  std::vector<PolygonId> polygons() const;  // in their order
  // Of those that a voxel takes part in.
  std::array<CellAt, 8> cells_around(const VoxelAt& voxel) const;
  std::vector<WorldPolygon> polygons_of(const CellAt& cell) const;

  // A voxel becomes full or empty. The polygons that came, and those that came into view, in no order and perhaps more than once.
  std::vector<PolygonId> edit(const VoxelAt& voxel, bool full);

  // How many a solid has.
  static std::int64_t count_polygons(const Occupancy& occupancy);
  // Whether a grid has more cells than polygons can be numbered.
  static bool is_too_large(const VoxelGrid& grid);

private:
  static unsigned inside_of(const Occupancy& occupancy, const CellAt& cell);
  // each(cell, how many polygons it has)
  template <class Each>
  static void for_each_cell(const Occupancy& occupancy, const Each& each);
  PolygonId number_of(const CellAt& cell) const;

  const PictureSet& set_;
  Occupancy occupancy_;
  std::vector<IdLayers> layers_;
};

}  // namespace glassbox::views
