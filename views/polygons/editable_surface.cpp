#include "views/polygons/editable_surface.h"

#include <algorithm>

#include "views/polygons/cell_table.h"
#include "views/voxels/blocks.h"

namespace glassbox::views {

namespace {

// The point half way along an edge of a cell.
Vector3d middle_of(const CellPosition& cell, int edge) {
  const CellEdge& e = kCellEdges[std::size_t(edge)];
  Vector3d at(cell.x + (e.from & 1), cell.y + (e.from >> 1 & 1), cell.z + (e.from >> 2));
  at[e.axis] += 0.5;
  return at;
}

PolygonFootprint footprint_in(const CalibratedPicture& picture, const WorldPolygon& polygon) {
  return {picture.camera, picture.color.width, picture.color.height, polygon.corners};
}

}  // namespace

bool EditableSurface::is_too_large(const VoxelGrid& grid) {
  double cells = 1;
  for (const int count : grid.count) cells *= count + 1;
  return cells * kMaxPolygonsPerCell > 0x1p32;
}

EditableSurface::EditableSurface(const PictureSet& set, const Occupancy& occupancy, int threads,
                                 double most_bytes)
    : set_(set), occupancy_(occupancy) {
  for (const CalibratedPicture& picture : set.pictures)
    layers_.emplace_back(picture.color.width, picture.color.height);
  const std::vector<PolygonId> all = polygons();
  // Adds kAtOnce polygons at a time; after each group the memory of all pictures' layers is
  // checked.
  constexpr std::size_t kAtOnce = 4096;
  for (std::size_t first = 0; first < all.size() && layer_bytes() <= most_bytes; first += kAtOnce) {
    std::vector<WorldPolygon> some;
    for (std::size_t i = first; i < std::min(first + kAtOnce, all.size()); ++i)
      some.push_back(polygon(all[i]));
    for_blocks(layers_.size(), threads, [&](std::size_t i) {
      for (const WorldPolygon& one : some)
        layers_[i].add(one.id, footprint_in(set_.pictures[i], one));
    });
  }
}

double EditableSurface::layer_bytes() const {
  double bytes = 0;
  for (const IdLayers& layers : layers_) bytes += layers.bytes();
  return bytes;
}

unsigned EditableSurface::inside_of(const Occupancy& occupancy, const CellPosition& cell) {
  unsigned inside = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const VoxelPosition voxel{cell.x + (corner & 1), cell.y + (corner >> 1 & 1),
                              cell.z + (corner >> 2)};
    inside |= unsigned(occupancy.has(voxel)) << corner;
  }
  return inside;
}

PolygonId EditableSurface::number_of(const CellPosition& cell) const {
  const auto& count = occupancy_.grid().count;
  const std::int64_t index =
      (std::int64_t(cell.z + 1) * (count[1] + 1) + cell.y + 1) * (count[0] + 1) + cell.x + 1;
  return PolygonId(index * kMaxPolygonsPerCell);
}

CellPosition EditableSurface::cell_of(PolygonId id) const {
  const auto& count = occupancy_.grid().count;
  const std::int64_t index = id / kMaxPolygonsPerCell, width = count[0] + 1, height = count[1] + 1;
  return {int(index % width) - 1, int(index / width % height) - 1,
          int(index / (width * height)) - 1};
}

std::vector<WorldPolygon> EditableSurface::polygons_of(const CellPosition& cell) const {
  std::vector<WorldPolygon> polygons;
  PolygonId id = number_of(cell);
  for (const CellTriangle& triangle : consistent_table()[inside_of(occupancy_, cell)].triangles) {
    WorldPolygon polygon{id++, {}};
    for (std::size_t k = 0; k < 3; ++k)
      polygon.corners[k] = world_of_lattice(occupancy_.grid(), middle_of(cell, triangle[k]));
    polygons.push_back(polygon);
  }
  return polygons;
}

WorldPolygon EditableSurface::polygon(PolygonId id) const {
  return polygons_of(cell_of(id))[id % kMaxPolygonsPerCell];
}

bool EditableSurface::has(PolygonId id) const {
  return id % kMaxPolygonsPerCell <
         consistent_table()[inside_of(occupancy_, cell_of(id))].triangles.size();
}

template <class Each>
void EditableSurface::for_each_cell(const Occupancy& occupancy, const Each& each) {
  const auto& count = occupancy.grid().count;
  for (int z = -1; z < count[2]; ++z) {
    for (int y = -1; y < count[1]; ++y) {
      for (int x = -1; x < count[0]; ++x) {
        const CellPosition cell{x, y, z};
        each(cell, consistent_table()[inside_of(occupancy, cell)].triangles.size());
      }
    }
  }
}

std::vector<PolygonId> EditableSurface::polygons() const {
  std::vector<PolygonId> all;
  all.reserve(std::size_t(count_polygons(occupancy_)));
  for_each_cell(occupancy_, [&](const CellPosition& cell, std::size_t polygons) {
    const PolygonId first = number_of(cell);
    for (std::size_t k = 0; k < polygons; ++k) all.push_back(first + PolygonId(k));
  });
  return all;
}

std::int64_t EditableSurface::count_polygons(const Occupancy& occupancy) {
  std::int64_t count = 0;
  for_each_cell(occupancy, [&](const CellPosition&, std::size_t polygons) {
    count += std::int64_t(polygons);
  });
  return count;
}

std::array<CellPosition, 8> EditableSurface::cells_around(const VoxelPosition& voxel) const {
  std::array<CellPosition, 8> cells;
  for (int corner = 0; corner < 8; ++corner)
    cells[std::size_t(corner)] = {voxel.x - (corner & 1), voxel.y - (corner >> 1 & 1),
                                  voxel.z - (corner >> 2)};
  return cells;
}

std::vector<PolygonId> EditableSurface::set_voxel(const VoxelPosition& voxel, bool full) {
  std::vector<PolygonId> changed;
  if (occupancy_.has(voxel) == full) return changed;
  const std::array<CellPosition, 8> cells = cells_around(voxel);
  std::vector<WorldPolygon> before, after;
  const auto gather = [&](std::vector<WorldPolygon>& all) {
    for (const CellPosition& cell : cells) {
      const auto here = polygons_of(cell);
      all.insert(all.end(), here.begin(), here.end());
    }
  };
  gather(before);
  occupancy_.set(voxel, full);
  gather(after);
  for (const WorldPolygon& polygon : after) changed.push_back(polygon.id);
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    for (const WorldPolygon& polygon : before)
      layers_[i].remove(polygon.id, footprint_in(set_.pictures[i], polygon));
    for (const WorldPolygon& polygon : after)
      layers_[i].add(polygon.id, footprint_in(set_.pictures[i], polygon));
    for (const WorldPolygon& polygon : before) {
      footprint_in(set_.pictures[i], polygon).for_each_pixel([&](IdPixel at, float) {
        if (const IdSample* front = layers_[i].front(at)) changed.push_back(front->id);
      });
    }
  }
  return changed;
}

}  // namespace glassbox::views
