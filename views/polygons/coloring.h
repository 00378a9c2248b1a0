// Polygon colouring (S1-39): each polygon of the surface has the mean colour of the pixels that
// show it. Where those pixels do not have one colour, the voxel behind the polygon is removed, and
// the surface changes. Generalized voxel coloring with layered depth images does the same for
// voxels (Culbertson, Malzbender and Slabaugh 1999).
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "views/polygons/editable_surface.h"
#include "views/polygons/polygonise.h"

namespace glassbox::views {

// The pixels of the pictures that show a polygon.
struct PolygonObservation {
  std::int64_t pixels = 0;      // pixels that belong to the object
  std::int64_t background = 0;  // pixels that are background
  int views = 0;                // pictures with at least one pixel of the object
  std::array<std::int64_t, 3> sums{}, squares{};

  // Sum of the squared distances of the pixels from their mean, levels^2.
  double residual() const;
  // Standard deviation, pooled over the channels, in levels; 0 for fewer than two pixels.
  double deviation() const;
};

PolygonObservation observe_polygon(const PictureSet& set, const EditableSurface& surface,
                                   const WorldPolygon& polygon);

struct PolygonColoringSettings {
  // The largest deviation of a polygon's colours, in levels. If it is larger, the voxel behind the
  // polygon is carved if the pictures are explained better without it; if the threshold is
  // infinite, no voxel is carved for its colours. Where a picture shows background, the voxel is
  // carved if its middle is outside of the object in one of the pictures.
  double threshold = 60;
  bool carves = true;
  // Whether the surface's corners are where the neighbourhood is half full of voxels, instead of
  // half way along the lattice's edges.
  bool is_smooth = true;
  int threads = 0;
  // Limit for the sum of polygon_bytes and layer_bytes.
  double most_bytes = std::numeric_limits<double>::infinity();
};

// Bytes that color_polygons needs for a grid's voxels and for this many polygons.
double polygon_bytes(const VoxelGrid& grid, double polygons);
// Bytes that color_polygons needs for the pictures: layered images in which every pixel of the
// object shows one or two polygons.
double layer_bytes(const PictureSet& set);

struct PolygonColor {
  Rgba8 color;
  std::uint16_t views = 0;  // pictures that see it; 0: the colour is that of its neighbours
  float deviation = 0;      // standard deviation of the pixels' colours, in levels
};

struct PolygonColoring {
  VoxelGrid grid;
  Occupancy solid{VoxelGrid{}};  // the voxels that are left after carving
  PolygonMesh mesh;              // in lattice coordinates of the voxels' centres
  std::vector<PolygonColor> colors;
  std::int64_t full_before = 0, full = 0;  // full voxels, before and after carving
  std::int64_t carved_by_color = 0, carved_by_background = 0;
  // How often a voxel was kept because the colours were not explained better without it.
  std::int64_t kept = 0;
  std::int64_t examined = 0;  // polygons that were examined, with repetitions
  std::int64_t samples = 0;   // samples of the layered images at the end
  std::int64_t unseen = 0;    // polygons that no picture shows at a pixel's centre
  double milliseconds = 0;
};

// An error for more cells than there are numbers for polygons, for no voxel at all, and for more
// memory than the settings allow. The memory is checked for the polygons before any is made, and
// for the samples of the layered images while they are added.
Result<PolygonColoring> color_polygons(const PictureSet& set, const Occupancy& occupancy,
                                       const PolygonColoringSettings& settings);

}  // namespace glassbox::views
