#include <glassbox/mesh/triangulate.h>

#include <cmath>
#include <span>

#include <glassbox/mesh/ear_clipping.h>
#include <glassbox/mesh/even_odd.h>
#include <glassbox/mesh/exact.h>

namespace glassbox {
namespace {

using Positions = std::vector<Point<Object>>;

// ---- which way a polygon faces, exactly ----

enum class Axis { kX, kY, kZ };

// The coordinate axis along which a polygon shows the largest area, and the side from which it is
// counter-clockwise.
struct Facing {
  Axis axis = Axis::kZ;
  int sign = 0;  // 0: no area at all
};

// The point projected along an axis, seen from the axis' positive end, right-handed.
FlatPoint projected_along(Axis axis, const Point<Object>& p) {
  switch (axis) {
    case Axis::kX:
      return {p.y, p.z};
    case Axis::kY:
      return {p.z, p.x};
    default:
      return {p.x, p.y};
  }
}

// The point projected so that the polygon is counter-clockwise. If the polygon is counter-clockwise
// from the axis' negative end, the projection is mirrored.
FlatPoint projected_to_front(const Facing& facing, const Point<Object>& p) {
  const FlatPoint flat = projected_along(facing.axis, p);
  return facing.sign > 0 ? flat : FlatPoint{flat.y, flat.x};
}

// Twice the area inside a closed outline, seen along an axis.
double exact_area(const Positions& outline, Axis axis) {
  ExactSum area;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const FlatPoint a = projected_along(axis, outline[i]);
    const FlatPoint b = projected_along(axis, outline[i + 1 == outline.size() ? 0 : i + 1]);
    area.add_product(a.x, b.y);
    area.subtract_product(a.y, b.x);
  }
  return area.approximation();
}

// Twice the area inside an outline in double, by Newell's sums relative to the first corner, with a
// bound of the rounding error (docs/references.md, bound 6, and one more unit for the rounding of
// the bound itself).
struct BoundedArea {
  double value = 0;
  double error = 0;
};
BoundedArea rounded_area(const Positions& outline, Axis axis) {
  const FlatPoint origin = projected_along(axis, outline[0]);
  double value = 0, magnitude = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const FlatPoint a = projected_along(axis, outline[i]);
    const FlatPoint b = projected_along(axis, outline[i + 1 == outline.size() ? 0 : i + 1]);
    const double ax = double(a.x) - origin.x, ay = double(a.y) - origin.y;
    const double bx = double(b.x) - origin.x, by = double(b.y) - origin.y;
    const double term = (ax - bx) * (ay + by);
    value += term;
    magnitude += (std::abs(ax) + std::abs(bx)) * (std::abs(ay) + std::abs(by));
  }
  return {value, double(outline.size() + 8) * 0x1p-53 * magnitude};
}

Facing facing_of(const Positions& outline) {
  Facing best;
  double largest = 0;
  bool certain = false;
  for (const Axis axis : {Axis::kX, Axis::kY, Axis::kZ}) {
    const BoundedArea area = rounded_area(outline, axis);
    if (std::abs(area.value) <= largest) continue;
    largest = std::abs(area.value);
    best = {axis, area.value > 0 ? 1 : -1};
    certain = largest > area.error;
  }
  if (certain) return best;

  best = {};
  largest = 0;
  for (const Axis axis : {Axis::kX, Axis::kY, Axis::kZ}) {
    const double area = exact_area(outline, axis);
    if (std::abs(area) <= largest) continue;
    largest = std::abs(area);
    best = {axis, area > 0 ? 1 : -1};
  }
  return best;
}

// Whether the points are exactly collinear in space: without area along all three axes.
bool without_area(const Point<Object>& a, const Point<Object>& b, const Point<Object>& c) {
  for (const Axis axis : {Axis::kZ, Axis::kX, Axis::kY}) {
    if (orientation(projected_along(axis, a), projected_along(axis, b), projected_along(axis, c)) !=
        0)
      return false;
  }
  return true;
}

// ---- quads ----

double squared_distance(const Point<Object>& a, const Point<Object>& b) {
  const double x = double(a.x) - b.x, y = double(a.y) - b.y, z = double(a.z) - b.z;
  return x * x + y * y + z * z;
}

void add_squared_distance(ExactSum& sum, const Point<Object>& a, const Point<Object>& b,
                          float factor) {
  const auto add_square = [&](float u, float v) {
    // The terms of (u - v)^2, times the factor. Multiplying a product by 1, -1 or 2 is exact.
    sum.add(factor * (double(u) * u));
    sum.add(factor * (double(v) * v));
    sum.add(-2 * factor * (double(u) * v));
  };
  add_square(a.x, b.x);
  add_square(a.y, b.y);
  add_square(a.z, b.z);
}

// Whether the diagonal from corner 1 is strictly shorter than the one from corner 0, decided
// exactly: diagonals of equal length must be found equal on every machine and wherever the quad is.
bool second_diagonal_is_shorter(const Positions& quad) {
  const double from_0 = squared_distance(quad[0], quad[2]);
  const double from_1 = squared_distance(quad[1], quad[3]);
  // Each squared distance has a relative error of at most 5 u (u is the unit roundoff 2^-53): 3 u
  // for each square, because its difference is rounded, and 2 u for the two sums. 2^-49 = 16 u is
  // enough for both distances.
  if (std::abs(from_0 - from_1) > 0x1p-49 * (from_0 + from_1)) return from_1 < from_0;
  ExactSum difference;
  add_squared_distance(difference, quad[1], quad[3], 1);
  add_squared_distance(difference, quad[0], quad[2], -1);
  return difference.sign() < 0;
}

struct QuadCut {
  bool from_corner_1 = false;
  bool proper = true;  // no triangle has the opposite winding
};

// The quality of a diagonal: 2 where both triangles have the winding of the outline, 1 where one
// has no area, 0 where one has the opposite winding.
int quality(int turn_a, int turn_b) {
  if (turn_a < 0 || turn_b < 0) return 0;
  return turn_a > 0 && turn_b > 0 ? 2 : 1;
}

QuadCut cut_quad(const Positions& quad, const Facing& facing) {
  std::array<FlatPoint, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = projected_to_front(facing, quad[i]);
  const int from_0 = quality(orientation(p[0], p[1], p[2]), orientation(p[0], p[2], p[3]));
  const int from_1 = quality(orientation(p[0], p[1], p[3]), orientation(p[1], p[2], p[3]));
  if (from_0 != from_1) return {from_1 > from_0, true};
  return {second_diagonal_is_shorter(quad), from_0 > 0};
}

// ---- faces ----

class Triangulator {
public:
  explicit Triangulator(const Mesh& mesh) : mesh_(mesh) {}

  Triangulation run() {
    for (face_ = 0; face_ < mesh_.faces.size(); ++face_) {
      first_number_ = result_.numbered;
      cut_face();
      result_.numbered += triangle_number_count(mesh_.faces[face_]);
    }
    return std::move(result_);
  }

private:
  void cut_face() {
    const Face face = mesh_.faces[face_];
    number_ = first_number_;
    read_outline(face);
    if (face.count == 3) {
      if (without_area(outline_[0], outline_[1], outline_[2])) {
        result_.degenerate_faces.push_back(face_);
      } else {
        keep({0, 1, 2});
      }
      return;
    }
    const Facing facing = face.count < 3 ? Facing{} : facing_of(outline_);
    if (facing.sign == 0) {
      result_.degenerate_faces.push_back(face_);
      return;
    }
    const bool proper = face.count == 4 ? emit_quad(facing) : emit_polygon(facing);
    if (!proper) result_.fallback_faces.push_back(face_);
  }

  void read_outline(const Face& face) {
    outline_.clear();
    for (std::uint32_t i = 0; i < face.count; ++i) {
      outline_.push_back(mesh_.positions[mesh_.corners[face.first + i].position]);
    }
  }

  bool emit_quad(const Facing& facing) {
    const QuadCut cut = cut_quad(outline_, facing);
    if (cut.from_corner_1) {
      emit({0, 1, 3});
      emit({1, 2, 3});
    } else {
      emit({0, 1, 2});
      emit({0, 2, 3});
    }
    return cut.proper;
  }

  bool emit_polygon(const Facing& facing) {
    flat_.clear();
    for (const Point<Object>& p : outline_) flat_.push_back(projected_to_front(facing, p));
    const EvenOdd even_odd = find_even_odd(flat_);
    if (even_odd.meeting == Meeting::kTouch) return emit_rings(even_odd.rings);
    const bool proper =
        clip_ears(flat_, [this](const std::array<std::uint32_t, 3>& c) { emit(c); }).proper;
    return proper && even_odd.meeting == Meeting::kNone;
  }

  // Cuts each part of the inside. The numbers that are left are those of triangles without area:
  // where corners are repeated, and in spikes.
  bool emit_rings(const std::vector<std::vector<std::uint32_t>>& rings) {
    bool proper = true;
    for (const std::vector<std::uint32_t>& ring : rings) {
      std::vector<FlatPoint> flat;
      for (const std::uint32_t corner : ring) flat.push_back(flat_[corner]);
      const auto cut = [&](const std::array<std::uint32_t, 3>& c) {
        emit({ring[c[0]], ring[c[1]], ring[c[2]]});
      };
      proper = clip_ears(flat, cut).proper && proper;
    }
    if (rings.empty()) {
      result_.degenerate_faces.push_back(face_);
    } else {
      result_.degenerate_triangles += first_number_ + std::uint32_t(outline_.size()) - 2 - number_;
    }
    return proper;
  }

  // Takes the next number for the triangle; keeps the triangle if it has an area.
  void emit(const std::array<std::uint32_t, 3>& corners) {
    if (without_area(outline_[corners[0]], outline_[corners[1]], outline_[corners[2]])) {
      ++result_.degenerate_triangles;
      ++number_;
    } else {
      keep(corners);
    }
  }

  void keep(const std::array<std::uint32_t, 3>& corners) {
    const std::uint32_t first = mesh_.faces[face_].first;
    result_.triangles.push_back(
        {{first + corners[0], first + corners[1], first + corners[2]}, face_, number_++});
  }

  const Mesh& mesh_;
  Triangulation result_;
  std::uint32_t face_ = 0;
  std::uint32_t first_number_ = 0;
  std::uint32_t number_ = 0;
  Positions outline_;            // of the current face
  std::vector<FlatPoint> flat_;  // the same, seen from the front
};

}  // namespace

Triangulation triangulate(const Mesh& mesh) {
  return Triangulator(mesh).run();
}

}  // namespace glassbox
