// Positions of the pixels of a quad (4 x 4 pixels) and of a block (four quads) as vectors.

#if defined(GLASSBOX_QUADS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_QUADS_INL_H_
#undef GLASSBOX_QUADS_INL_H_
#else
#define GLASSBOX_QUADS_INL_H_
#endif

#include <glassbox/raster/lanes/numbers-inl.h>
#include <glassbox/raster/lanes/tile_buffer.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

inline constexpr std::size_t kQuadVectors = kQuadPixels / kLanes;
inline constexpr std::size_t kBlockVectors = kBlockPixels / kLanes;

// Columns and rows of a quad's pixels i .. i + kLanes - 1 within the quad.
HWY_INLINE Ints quad_columns(std::size_t i) {
  return Ints(hn::Iota(kI, std::int32_t(i))) & 3;
}
HWY_INLINE Ints quad_rows(std::size_t i) {
  return shifted_right<2>(hn::Iota(kI, std::int32_t(i)));
}

// Columns and rows, within a block, of the pixels in one of the block's vectors.
HWY_INLINE Ints block_columns(std::size_t vector) {
  const auto quad = std::int32_t(vector / kQuadVectors);
  return quad_columns(vector % kQuadVectors * kLanes) + (quad % 2) * kQuadSide;
}
HWY_INLINE Ints block_rows(std::size_t vector) {
  const auto quad = std::int32_t(vector / kQuadVectors);
  return quad_rows(vector % kQuadVectors * kLanes) + (quad / 2) * kQuadSide;
}

// Which of pixels i .. i + kLanes - 1 of the quad at (x, y) are on the screen; a quad may extend
// beyond it.
HWY_INLINE IntMask on_screen(const PixelRect& window, int x, int y, std::size_t i) {
  return quad_columns(i) + x < window.x1 && quad_rows(i) + y < window.y1;
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
