// The timed edge functions of the edge-arithmetic experiment (D-3), vectorized in six kinds of
// arithmetic.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace glassbox::study {

enum class EdgeArithmetic {
  kFloatDifference,  // dx (py - y0) - dy (px - x0)
  kFloatPlane,       // (a px + b py) + c
  kFloatFma,         // like kFloatDifference; rounds the second product with the subtraction
  kDouble,           // like kFloatPlane
  kInt32Tile,        // E/256 (E: edge function), rounded down, from the tile's corner
  kInt64,
};

inline constexpr int kEdgeTile = 64;  // in px

// A triangle's edges relative to the corner of a tile; lengths are in 1/256 px.
struct TileEdges {
  std::array<std::int32_t, 3> x0{}, y0{}, dx{}, dy{};
  std::array<std::int32_t, 3> bias{};  // 1 if points on the edge belong to the neighbour
};

// The total number of pixel centres of the tile that the triangles cover. Uses the widest vectors
// of the processor.
std::int64_t count_covered(EdgeArithmetic arithmetic, std::span<const TileEdges> triangles);

}  // namespace glassbox::study
