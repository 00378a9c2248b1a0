#include <glassbox/render/plan/draw_order.h>

#include <algorithm>

namespace glassbox {

std::size_t order_front_to_back(std::span<std::uint32_t> order, std::span<const DepthCodes> codes) {
  std::size_t moved = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::size_t first = i > kMaxOvertaken ? i - kMaxOvertaken : 0;
    std::size_t to = i;
    while (to > first && may_overtake(codes[order[i]], codes[order[to - 1]])) --to;
    std::rotate(order.begin() + std::ptrdiff_t(to), order.begin() + std::ptrdiff_t(i),
                order.begin() + std::ptrdiff_t(i + 1));
    moved += to < i;
  }
  return moved;
}

}  // namespace glassbox
