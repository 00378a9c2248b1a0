#include "views/polygons/polygonise.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace glassbox::views {

namespace {

constexpr std::uint32_t kNoCorner = 0xffffffffu;

// The surface's corners on edges that begin in one of two layers of the lattice. An edge leads from
// its lower end along one of seven directions, whose three bits are the steps along x, y and z.
// Cubes only have the directions 1, 2 and 4; the others are diagonals, which tetrahedra have.
class EdgeCorners {
public:
  EdgeCorners(int width, int height)
      : width_(std::size_t(width)),
        layers_(2, std::vector<std::uint32_t>(7 * width_ * std::size_t(height), kNoCorner)) {}

  std::uint32_t& at(int x, int y, int z, int direction) {
    return layers_[std::size_t(z & 1)]
                  [(std::size_t(y) * width_ + std::size_t(x)) * 7 + std::size_t(direction - 1)];
  }
  // Forgets layer z, which is finished; layer z + 2 takes its place.
  void forget(int z) { std::ranges::fill(layers_[std::size_t(z & 1)], kNoCorner); }

private:
  std::size_t width_;
  std::vector<std::vector<std::uint32_t>> layers_;
};

class LatticeWalk {
public:
  // The triangles of a cell come from `table`; without a table, `polygoniser` decides.
  LatticeWalk(const ScalarField& field, double level, Polygoniser polygoniser,
              const CellTable* table = nullptr)
      : field_(field),
        level_(level),
        polygoniser_(polygoniser),
        table_(table),
        corners_(field.count[0] + 2, field.count[1] + 2) {}

  PolygonMesh run() {
    for (int z = -1; z < field_.count[2]; ++z) {
      for (int y = -1; y < field_.count[1]; ++y) {
        for (int x = -1; x < field_.count[0]; ++x) visit({x, y, z});
      }
      corners_.forget(z + 1);
    }
    return std::move(mesh_);
  }

private:
  using Place = std::array<int, 3>;

  double value(const Place& cell, int corner) const {
    return field_(cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2));
  }

  void visit(const Place& cell) {
    std::array<double, 8> values{};
    unsigned inside = 0;
    for (int corner = 0; corner < 8; ++corner) {
      values[std::size_t(corner)] = value(cell, corner);
      inside |= unsigned(values[std::size_t(corner)] >= level_) << corner;
    }
    if (inside == 0 || inside == 255) return;
    if (table_ != nullptr) return add(cell, values, (*table_)[inside]);
    switch (polygoniser_) {
      case Polygoniser::kConsistent:
        return add(cell, values, consistent_table()[inside]);
      case Polygoniser::kNaive:
        return add(cell, values, naive_table()[inside]);
      case Polygoniser::kSaddle: {
        const unsigned joined = joined_faces(values, inside);
        return add(cell, values,
                   joined == 0 ? consistent_table()[inside] : cell_surface(inside, joined));
      }
      case Polygoniser::kTetrahedra:
        return add_tetrahedra(cell, values, inside);
    }
  }

  // The ambiguous faces on which the inside corners are joined: those where the bilinear function f
  // is inside at its saddle point s. f(s) = (p q - r t) / (p + q - r - t), where p and q are the
  // values on one diagonal of the face, r and t those on the other, and the level is subtracted
  // from all of them. The two cells of a face have its four values in two orders; neither the sums
  // nor the products depend on the order.
  unsigned joined_faces(const std::array<double, 8>& values, unsigned inside) const {
    const unsigned ambiguous = ambiguous_faces(inside);
    unsigned joined = 0;
    for (std::size_t face = 0; face < 6; ++face) {
      if ((ambiguous >> face & 1) == 0) continue;
      const std::array<int, 4>& c = kCellFaces[face];
      const bool first_is_inside = (inside >> c[0] & 1) != 0;
      const auto above = [&](std::size_t i) {
        return values[std::size_t(c[(i + (first_is_inside ? 0 : 1)) % 4])] - level_;
      };
      // p and q are inside, so they are at least 0. The denominator is positive, or f(s) is 0 / 0
      // for a face that is flat at the level.
      const double p = above(0), q = above(2), r = above(1), t = above(3);
      if (p * q - r * t >= 0) joined |= 1u << face;
    }
    return joined;
  }

  // `from` and `to` are corners of the cell; `to` has all the bits of `from`.
  std::uint32_t corner_on(const Place& cell, const std::array<double, 8>& values, int from,
                          int to) {
    const int x = cell[0] + (from & 1), y = cell[1] + (from >> 1 & 1), z = cell[2] + (from >> 2);
    std::uint32_t& corner = corners_.at(x + 1, y + 1, z + 1, from ^ to);
    if (corner != kNoCorner) return corner;
    const double t = crossing(values[std::size_t(from)], values[std::size_t(to)], level_);
    const int step = from ^ to;
    const Vector3d direction(step & 1, step >> 1 & 1, step >> 2);
    corner = std::uint32_t(mesh_.positions.size());
    mesh_.positions.push_back(Vector3d(x, y, z) + t * direction);
    return corner;
  }

  void add(const Place& cell, const std::array<double, 8>& values, const CellSurface& surface) {
    std::array<std::uint32_t, 13> corners;
    corners.fill(kNoCorner);
    std::size_t on_edges = 0;
    Vector3d sum = Vector3d::Zero();
    for (const CellTriangle& triangle : surface.triangles) {
      for (const std::uint8_t edge : triangle) {
        if (edge == kCellMiddle || corners[edge] != kNoCorner) continue;
        corners[edge] = corner_on(cell, values, kCellEdges[edge].from, kCellEdges[edge].to());
        sum += mesh_.positions[corners[edge]];
        ++on_edges;
      }
    }
    for (const CellTriangle& triangle : surface.triangles) {
      // A corner in the middle belongs to only one polygon, and is in the interior of the cell.
      if (triangle[2] == kCellMiddle && corners[kCellMiddle] == kNoCorner) {
        corners[kCellMiddle] = std::uint32_t(mesh_.positions.size());
        mesh_.positions.push_back(sum / double(on_edges));
      }
      mesh_.polygons.push_back({corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]});
    }
  }

  // Freudenthal's division into six tetrahedra: each goes from corner 0 to corner 7 by one step
  // along each axis, in one of six orders. Neighbouring cells have the same diagonals on their
  // common face.
  void add_tetrahedra(const Place& cell, const std::array<double, 8>& values, unsigned inside) {
    static constexpr std::array<std::array<int, 3>, 6> kOrders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (std::size_t k = 0; k < kOrders.size(); ++k) {
      const auto& [first, second, third] = kOrders[k];
      const std::array<int, 4> corners{0, 1 << first, 1 << first | 1 << second, 7};
      // The first three orders are cyclic permutations of x, y, z: tetrahedra of positive volume.
      add_tetrahedron(cell, values, inside, corners, k < 3);
    }
  }

  void add_tetrahedron(const Place& cell, const std::array<double, 8>& values, unsigned inside,
                       const std::array<int, 4>& corners, bool is_positive) {
    std::array<int, 4> in{}, out{};
    std::size_t ins = 0, outs = 0;
    for (const int corner : corners) {
      if ((inside >> corner & 1) != 0)
        in[ins++] = corner;
      else
        out[outs++] = corner;
    }
    if (ins == 0 || outs == 0) return;
    const auto on = [&](int a, int b) {
      return corner_on(cell, values, std::min(a, b), std::max(a, b));
    };
    // The winding of the triangles depends on whether the order (inside corners, then outside
    // corners) is an even permutation of the tetrahedron's corners.
    std::array<int, 4> order{};
    std::copy_n(in.begin(), ins, order.begin());
    std::copy_n(out.begin(), outs, order.begin() + std::ptrdiff_t(ins));
    const auto place = [&](int corner) {
      return std::ranges::find(corners, corner) - corners.begin();
    };
    int swaps = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) swaps += place(order[i]) > place(order[j]);
    }
    const bool forward = (swaps % 2 == 0) == is_positive;
    const auto add_polygon = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      mesh_.polygons.push_back(forward ? PolygonCorners{a, b, c} : PolygonCorners{a, c, b});
    };
    if (ins == 1) {
      add_polygon(on(in[0], out[0]), on(in[0], out[1]), on(in[0], out[2]));
    } else if (ins == 3) {
      add_polygon(on(in[0], out[0]), on(in[1], out[0]), on(in[2], out[0]));
    } else {
      const std::uint32_t a = on(in[0], out[0]), b = on(in[0], out[1]), c = on(in[1], out[1]),
                          d = on(in[1], out[0]);
      add_polygon(a, b, c);
      add_polygon(a, c, d);
    }
  }

  const ScalarField& field_;
  double level_;
  Polygoniser polygoniser_;
  const CellTable* table_;
  EdgeCorners corners_;
  PolygonMesh mesh_;
};

}  // namespace

std::string_view name_of(Polygoniser polygoniser) {
  constexpr std::string_view kNames[] = {"consistent", "naive", "saddle", "tetrahedra"};
  return kNames[std::size_t(polygoniser)];
}

double crossing(double from, double to, double level) {
  // Outside of the lattice there is no value to interpolate with, so the surface is half way.
  if (std::isinf(from) || std::isinf(to)) return 0.5;
  return std::clamp((level - from) / (to - from), kMinStep, 1 - kMinStep);
}

PolygonMesh polygonise(const ScalarField& field, double level, Polygoniser polygoniser) {
  return LatticeWalk(field, level, polygoniser).run();
}

PolygonMesh polygonise_with(const CellTable& table, const ScalarField& field, double level) {
  return LatticeWalk(field, level, Polygoniser::kConsistent, &table).run();
}

}  // namespace glassbox::views
