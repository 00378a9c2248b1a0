// The edge functions of D-3 in six arithmetics, over lanes: what is timed.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace glassbox::study {

enum class EdgeArithmetic {
  kFloatDifference,  // dx (py - y0) - dy (px - x0)
  kFloatPlane,       // (a px + b py) + c
  kFloatFma,         // the difference form, its second product and the subtraction in one rounding
  kDouble,           // the plane form
  kInt32Tile,        // E/256, rounded down, from the corner of the tile on
  kInt64,
};

inline constexpr int kEdgeTile = 64;  // px

// A triangle's edges as seen from the corner of a tile; lengths in 1/256 px.
struct TileEdges {
  std::array<std::int32_t, 3> x0{}, y0{}, dx{}, dy{};
  std::array<std::int32_t, 3> bias{};  // 1 where points on the edge belong to the neighbour
};

// How many pixel centres of the tile the triangles cover, added up. The processor's widest vectors.
std::int64_t count_covered(EdgeArithmetic arithmetic, std::span<const TileEdges> triangles);

}  // namespace glassbox::study
