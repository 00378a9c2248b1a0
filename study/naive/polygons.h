// Isosurfaces of scalar fields, and layered images of polygons, as beginners first write them.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "views/polygons/id_layers.h"
#include "views/polygons/polygonise.h"

namespace glassbox::study::naive {

using views::CellSurface;
using views::CellTable;
using views::CellTriangle;
using views::PolygonMesh;
using views::ScalarField;

// ---- tables ----

// Cells with more than four corners inside get the triangles of the opposite case (inside and
// outside exchanged), without reversing their winding.
inline CellTable table_of_opposites_not_turned() {
  CellTable table = views::naive_table();
  for (unsigned inside = 0; inside < table.size(); ++inside) {
    if (std::popcount(inside) <= 4) continue;
    for (CellTriangle& t : table[inside].triangles) std::swap(t[1], t[2]);
  }
  return table;
}

// A face with two opposite corners inside can be cut in two ways. Here the cell below the face cuts
// it one way and the cell above it the other way, which leaves a hole.
inline CellTable table_by_sides() {
  CellTable table;
  for (unsigned inside = 0; inside < table.size(); ++inside)
    table[inside] = views::cell_surface(inside, 0b010101);
  return table;
}

// The border of each polygon is right, but its triangles are a fan from the first corner. Some
// diagonals of the fan lie on faces of the cell, where the neighbouring cell has the same
// diagonals, so that more than two triangles meet there.
inline CellTable table_of_fans() {
  CellTable table;
  for (unsigned inside = 0; inside < table.size(); ++inside) {
    std::map<int, int> next;
    std::vector<CellTriangle>& fans = table[inside].triangles;
    const auto& triangles = views::consistent_table()[inside].triangles;
    const auto has = [&](int a, int b) {
      return std::ranges::any_of(triangles, [&](const CellTriangle& t) {
        return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
      });
    };
    for (const CellTriangle& t : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (!has(t[(k + 1) % 3], t[k])) next[t[k]] = t[(k + 1) % 3];
      }
    }
    while (!next.empty()) {
      const int start = next.begin()->first;
      int at = next[start];
      while (next[at] != start) {
        fans.push_back({std::uint8_t(start), std::uint8_t(at), std::uint8_t(next[at])});
        const int after = next[at];
        next.erase(at);
        at = after;
      }
      next.erase(at);
      next.erase(start);
    }
  }
  return table;
}

// ---- ties ----

// Puts each vertex of the mesh exactly where the field, taken as linear along each lattice edge,
// has the level. If a lattice corner has exactly this level, the vertices on all of its edges
// coincide there.
inline PolygonMesh placed_exactly(PolygonMesh mesh, const ScalarField& field, double level) {
  for (views::Vector3d& p : mesh.positions) {
    int axis = 0;
    while (p[axis] == std::floor(p[axis])) ++axis;
    std::array<int, 3> from{int(std::floor(p.x())), int(std::floor(p.y())), int(std::floor(p.z()))},
        to = from;
    ++to[std::size_t(axis)];
    const double a = field(from[0], from[1], from[2]), b = field(to[0], to[1], to[2]);
    if (std::isfinite(a) && std::isfinite(b))
      p[axis] = from[std::size_t(axis)] + (level - a) / (b - a);
  }
  return mesh;
}

// Merges vertices at the same place, and removes triangles that then have a vertex twice.
inline PolygonMesh welded(const PolygonMesh& mesh) {
  PolygonMesh all;
  std::map<std::array<double, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> number;
  for (const views::Vector3d& p : mesh.positions) {
    const auto [place, is_new] =
        places.try_emplace({p.x(), p.y(), p.z()}, std::uint32_t(all.positions.size()));
    if (is_new) all.positions.push_back(p);
    number.push_back(place->second);
  }
  for (views::PolygonCorners t : mesh.polygons) {
    for (std::uint32_t& corner : t) corner = number[corner];
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) all.polygons.push_back(t);
  }
  return all;
}

// ---- layered images ----

// The list of samples of one pixel, which changes as polygons are added and deleted. Each member
// has the right value until a mutant (deliberately wrong code) changes it.
struct PixelList {
  bool keeps_all = true;          // false: only the nearest sample
  bool sorts = true;              // false: in the order of arrival
  bool breaks_ties_by_id = true;  // false: of samples at the same depth, the last is in front
  bool deletes_behind = true;     // false: hidden samples are not deleted
};

class NaiveIdLayers {
public:
  NaiveIdLayers(int width, int height, const PixelList& rule)
      : rule_(rule), width_(width), pixels_(std::size_t(width) * std::size_t(height)) {}

  void add(views::PolygonId id, const views::PolygonFootprint& footprint) {
    footprint.for_each_pixel([&](views::IdPixel at, float distance) {
      views::IdSamples& here = pixels_[index(at)];
      const views::IdSample sample{distance, id};
      if (!rule_.keeps_all) {
        if (here.empty() || sample < here.front()) here = {sample};
        return;
      }
      auto place = here.end();
      if (rule_.sorts) {
        place = std::ranges::find_if(here, [&](const views::IdSample& other) {
          return rule_.breaks_ties_by_id ? sample < other : distance <= other.distance;
        });
      }
      here.insert(place, sample);
    });
  }
  void remove(views::PolygonId id, const views::PolygonFootprint& footprint) {
    footprint.for_each_pixel([&](views::IdPixel at, float) {
      views::IdSamples& here = pixels_[index(at)];
      if (!rule_.deletes_behind) {
        if (!here.empty() && here.front().id == id) here.erase(here.begin());
        return;
      }
      std::erase_if(here, [&](const views::IdSample& sample) { return sample.id == id; });
    });
  }
  const views::IdSamples& samples(views::IdPixel at) const { return pixels_[index(at)]; }

private:
  std::size_t index(views::IdPixel at) const {
    return std::size_t(at.y) * std::size_t(width_) + std::size_t(at.x);
  }
  PixelList rule_;
  int width_;
  std::vector<views::IdSamples> pixels_;
};

}  // namespace glassbox::study::naive
