// Polygon colouring (S1-39): each polygon of the surface has the mean colour of the pixels that show it, and where those do not have one
// colour, the voxel behind it goes and the surface with it. As generalized voxel coloring with layered depth images does it for
// voxels (Culbertson, Malzbender and Slabaugh 1999).
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "views/polygons/live_surface.h"
#include "views/polygons/polygonise.h"

namespace glassbox::views {

// What the pictures show of a polygon.
struct PolygonSeen {
  std::int64_t pixels = 0;      // of the object
  std::int64_t background = 0;  // and beside it
  int views = 0;                // pictures that have one of the first
  std::array<std::int64_t, 3> sums{}, squares{};

  double unexplained() const;  // squares of the pixels' distances from their mean, levels^2
  double deviation() const;    // pooled over the channels, levels; 0 of fewer than two pixels
};

PolygonSeen seen_of(const PictureSet& set, const LiveSurface& surface, const WorldPolygon& polygon);

struct PolygonColoringSettings {
  // Where the deviation is larger, the voxel behind the polygon is carved if the pictures are explained better without it; infinite:
  // nothing is. Where a picture shows background it is carved if its middle is beside the object in one of them.
  double threshold = 60;
  bool carves = true;
  bool is_smooth = true;  // corners lie where the neighbourhood is half full, in place of half way
  int threads = 0;
  double most_bytes = std::numeric_limits<double>::infinity();  // of polygon_bytes and layer_bytes
};

// What color_polygons takes of a grid's voxels and of so many polygons.
double polygon_bytes(const VoxelGrid& grid, double polygons);
// What it takes of the pictures: layered images in which every pixel of the object shows one polygon or two.
double layer_bytes(const PictureSet& set);

struct PolygonColor {
  Rgba8 color;
  std::uint16_t views = 0;  // 0: seen by nobody; the colour is that of its neighbours
  float deviation = 0;      // levels
};

struct PolygonColoring {
  VoxelGrid grid;
  Occupancy solid{VoxelGrid{}};  // what is left
  PolygonMesh mesh;              // lattice coordinates of voxels' centres
  std::vector<PolygonColor> colors;
  std::int64_t full_before = 0, full = 0;  // voxels
  std::int64_t carved_by_color = 0, carved_by_background = 0;
  std::int64_t kept = 0;     // times that a voxel stayed, as the colours fit no better without it
  std::int64_t judged = 0;   // polygons asked about, again and again
  std::int64_t samples = 0;  // of the layered images, in the end
  std::int64_t unseen = 0;   // polygons that no picture shows at a pixel's centre
  double milliseconds = 0;
};

// Refused: more cells than there are numbers for polygons, no voxel at all, and what takes more than the settings allow: by the polygons
// that there are, before any is made, and by the samples of the layered images, while they come.
Result<PolygonColoring> color_polygons(const PictureSet& set, const Occupancy& occupancy,
                                       const PolygonColoringSettings& settings);

}  // namespace glassbox::views
