// Numbers at the corners of a lattice: how full space is there. Values of at least the level are
// inside.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace glassbox::views {

struct ScalarField {
  std::array<int, 3> count{0, 0, 0};  // corners along x, y, z
  std::vector<double> values;         // x changes fastest

  ScalarField(int nx, int ny, int nz, double value = 0)
      : count{nx, ny, nz}, values(std::size_t(nx) * std::size_t(ny) * std::size_t(nz), value) {}

  double& at(int x, int y, int z) { return values[index(x, y, z)]; }
  // Outside of the lattice the value is minus infinity.
  double operator()(int x, int y, int z) const {
    const bool is_there =
        x >= 0 && y >= 0 && z >= 0 && x < count[0] && y < count[1] && z < count[2];
    return is_there ? values[index(x, y, z)] : -std::numeric_limits<double>::infinity();
  }

private:
  std::size_t index(int x, int y, int z) const {
    return (std::size_t(z) * std::size_t(count[1]) + std::size_t(y)) * std::size_t(count[0]) +
           std::size_t(x);
  }
};

}  // namespace glassbox::views
