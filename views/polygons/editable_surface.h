// The surface of a solid of voxels as seen in a ring of pictures, kept up to date while voxels are
// removed (S1-39). Each picture has its layered image of polygon ids, and an edit only changes the
// polygons of eight cells.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "views/polygons/id_layers.h"
#include "views/polygons/occupancy.h"
#include "views/rings/picture_set.h"

namespace glassbox::views {

// A cell has the centres of eight voxels as its corners: (x, y, z) to (x + 1, y + 1, z + 1).
// Coordinates start at -1.
struct CellPosition {
  int x = 0, y = 0, z = 0;
};

struct WorldPolygon {
  PolygonId id = 0;
  Corners3d corners;  // world, counter-clockwise seen from outside
};

// A polygon's number tells where it is: the number of its cell times eight, plus its place in the
// cell. Polygons that are made again get the same numbers.
class EditableSurface {
public:
  static constexpr int kMaxPolygonsPerCell = 8;

  // The surface is half way between full and empty voxels. The pictures must outlive this object.
  // `threads` is the number of threads, 0 for as many as the machine has; the result does not
  // depend on it. If the layered images need more than `most_bytes`, no more polygons are added,
  // and the object may only be destroyed.
  EditableSurface(const PictureSet& set, const Occupancy& occupancy, int threads = 0,
                  double most_bytes = std::numeric_limits<double>::infinity());

  double layer_bytes() const;

  const Occupancy& occupancy() const { return occupancy_; }
  const std::vector<IdLayers>& layers() const { return layers_; }  // one for each picture

  CellPosition cell_of(PolygonId id) const;
  WorldPolygon polygon(PolygonId id) const;
  // Whether the surface has this polygon.
  bool has(PolygonId id) const;
  std::vector<PolygonId> polygons() const;  // in ascending order
  // The cells that have the voxel's centre as a corner.
  std::array<CellPosition, 8> cells_around(const VoxelPosition& voxel) const;
  std::vector<WorldPolygon> polygons_of(const CellPosition& cell) const;

  // Fills or empties a voxel. Returns the new polygons and those that came into view, in no order
  // and possibly repeated.
  std::vector<PolygonId> set_voxel(const VoxelPosition& voxel, bool full);

  // The number of polygons of a solid's surface.
  static std::int64_t count_polygons(const Occupancy& occupancy);
  // Whether a grid has more cells than there are numbers for polygons.
  static bool is_too_large(const VoxelGrid& grid);

private:
  static unsigned inside_of(const Occupancy& occupancy, const CellPosition& cell);
  // Calls each(cell, number of its polygons).
  template <class Each>
  static void for_each_cell(const Occupancy& occupancy, const Each& each);
  PolygonId number_of(const CellPosition& cell) const;

  const PictureSet& set_;
  Occupancy occupancy_;
  std::vector<IdLayers> layers_;
};

}  // namespace glassbox::views
