// Axis-aligned boxes, which bound what is drawn.
#pragma once

#include <limits>

#include <glassbox/base/spaces.h>

namespace glassbox {

// All points p with low <= p <= high in every coordinate. A new box is empty and grows with
// include().
template <class Space>
struct Box {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Point<Space, double> low{kInfinity, kInfinity, kInfinity};
  Point<Space, double> high{-kInfinity, -kInfinity, -kInfinity};

  bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }

  void include(const Point<Space, double>& p) {
    if (p.x < low.x) low.x = p.x;
    if (p.y < low.y) low.y = p.y;
    if (p.z < low.z) low.z = p.z;
    if (p.x > high.x) high.x = p.x;
    if (p.y > high.y) high.y = p.y;
    if (p.z > high.z) high.z = p.z;
  }
  void include(const Point<Space, float>& p) {
    include(Point<Space, double>(double(p.x), double(p.y), double(p.z)));
  }
  void include(const Box& box) {
    if (box.empty()) return;
    include(box.low);
    include(box.high);
  }

  // Corner i in 0 .. 7: bit 0 of i chooses high x, bit 1 high y, bit 2 high z.
  Point<Space, double> corner(int i) const {
    return {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
            (i & 4) != 0 ? high.z : low.z};
  }
  // Low and high are halved before the sum, so that no finite box overflows.
  Point<Space, double> center() const {
    return {low.x * 0.5 + high.x * 0.5, low.y * 0.5 + high.y * 0.5, low.z * 0.5 + high.z * 0.5};
  }
  friend bool operator==(const Box&, const Box&) = default;
};

}  // namespace glassbox
