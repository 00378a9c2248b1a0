// Which line or point a fragment comes from that is no triangle's.
#pragma once

#include <cstdint>

#include <glassbox/render/engine/observer.h>

namespace glassbox {

// An edge is that of a triangle, from its corner `edge` to the next.
enum class LineKind : std::uint8_t { kEdge, kLine, kPoint };

// `number`: of the triangle in the whole scene; of lines and points an index into those of their mesh.
inline FragmentSource source_of_line(LineKind kind, std::uint32_t number, std::uint32_t edge = 0) {
  return {number, kind == LineKind::kEdge ? edge : 2 + std::uint32_t(kind), false};
}

inline LineKind line_kind(const FragmentSource& source) {
  return source.piece < 3 ? LineKind::kEdge : LineKind(source.piece - 2);
}
inline std::uint32_t edge_of(const FragmentSource& source) {
  return source.piece;
}

}  // namespace glassbox
