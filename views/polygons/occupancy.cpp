#include "views/polygons/occupancy.h"

#include <algorithm>
#include <bit>

namespace glassbox::views {

Occupancy::Occupancy(const VoxelGrid& grid)
    : grid_(grid), bits_(std::size_t(grid.voxels() + 63) / 64, 0) {}

void Occupancy::set(const VoxelPosition& at, bool full) {
  const std::size_t i = index(at);
  const std::uint64_t bit = std::uint64_t(1) << (i % 64);
  bits_[i / 64] = full ? bits_[i / 64] | bit : bits_[i / 64] & ~bit;
}

void Occupancy::fill(const VoxelRun& run) {
  for (int i = 0; i < run.count; ++i) set(run.at(i), true);
}

void Occupancy::fill(std::span<const VoxelRun> runs, std::span<const Verdict> verdicts) {
  std::size_t next = 0;
  for (const VoxelRun& run : runs) {
    for (int i = 0; i < run.count; ++i) {
      const Verdict verdict = verdicts[next++];
      if (verdict == Verdict::kColored || verdict == Verdict::kHidden) set(run.at(i), true);
    }
  }
}

std::int64_t Occupancy::full() const {
  std::int64_t full = 0;
  for (const std::uint64_t bits : bits_) full += std::popcount(bits);
  return full;
}

ScalarField Occupancy::field() const {
  ScalarField field(grid_.count[0], grid_.count[1], grid_.count[2]);
  for (std::size_t i = 0; i < field.values.size(); ++i)
    field.values[i] = double(bits_[i / 64] >> (i % 64) & 1);
  return field;
}

ScalarField Occupancy::smooth_field() const {
  ScalarField field(grid_.count[0], grid_.count[1], grid_.count[2]);
  for (int z = 0; z < grid_.count[2]; ++z) {
    for (int y = 0; y < grid_.count[1]; ++y) {
      for (int x = 0; x < grid_.count[0]; ++x) {
        int full = 0;
        for (int k = -1; k <= 1; ++k) {
          for (int j = -1; j <= 1; ++j) {
            for (int i = -1; i <= 1; ++i) full += has({x + i, y + j, z + k});
          }
        }
        // The surface is at the level 1/2, which is 13.5 of 27 voxels, so no fraction is exactly at
        // it.
        const double share = full / 27.0;
        field.at(x, y, z) =
            has({x, y, z}) ? std::max(share, 14 / 27.0) : std::min(share, 13 / 27.0);
      }
    }
  }
  return field;
}

}  // namespace glassbox::views
