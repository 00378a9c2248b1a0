// Copies quads of pixels to and from the rows of images, and rows into the picture.

#if defined(GLASSBOX_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_ROWS_INL_H_
#undef GLASSBOX_ROWS_INL_H_
#else
#define GLASSBOX_ROWS_INL_H_
#endif

#include <algorithm>
#include <cstring>
#include <type_traits>

#include <hwy/cache_control.h>

#include <glassbox/images/image.h>
#include <glassbox/raster/lanes/quads-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// The size of a cache line in bytes and in words of 32 bits.
inline constexpr std::ptrdiff_t kLineBytes = 64, kLineWords = kLineBytes / 4;

// Calls work(row, columns) for the quad's rows that are on the screen. Almost all quads are wholly
// on the screen, and copying a number of bytes that the compiler knows is one instruction.
template <class Work>
HWY_INLINE void for_each_row(const PixelRect& window, int x, int y, const Work& work) {
  if (HWY_LIKELY(x + kQuadSide <= window.x1 && y + kQuadSide <= window.y1)) {
    for (int row = 0; row < kQuadSide; ++row) {
      work(row, std::integral_constant<std::size_t, kQuadSide>());
    }
    return;
  }
  const auto columns = std::size_t(std::min(kQuadSide, window.x1 - x));
  const int rows = std::min(kQuadSide, window.y1 - y);
  for (int row = 0; row < rows; ++row) work(row, columns);
}

// The rows of memory into which the tile's colours, depths, distances or triangle numbers are
// written: rows of the framebuffer's image, or rows of the tile's own memory (tile_buffer.h), which
// are copied to the image as whole cache lines.
struct Rows {
  std::uint32_t* first = nullptr;
  std::ptrdiff_t pitch = 0;  // from row to row, in words
  int x0 = 0, y0 = 0;        // the pixel that `first` points to

  std::uint32_t* at(int x, int y) const { return first + (y - y0) * pitch + (x - x0); }
};
template <class Pixel>
Rows rows_of(Image<Pixel>& image) {
  static_assert(sizeof(Pixel) == sizeof(std::uint32_t));
  return {reinterpret_cast<std::uint32_t*>(image.pixels.data()), image.width, 0, 0};
}

template <class From>
HWY_INLINE void store_quad(const From* from, const Rows& rows, const PixelRect& window, int x,
                           int y) {
  static_assert(sizeof(std::uint32_t) == sizeof(From));
  std::uint32_t* to = rows.at(x, y);
  for_each_row(window, x, y, [&](int row, auto columns) HWY_ATTR {
    std::memcpy(to + row * rows.pitch, from + row * kQuadSide, columns * sizeof(From));
  });
}

// Copies rows `from`, `pitch` words apart (0: the same row again), to the picture without going
// through the cache: no later step of this frame reads them, and cache lines that are written as a
// whole need not be read first.
template <class Pixel>
HWY_INLINE void stream_rows(const std::uint32_t* from, std::ptrdiff_t pitch,
                            const PixelRect& window, Image<Pixel>& image) {
  const hn::RebindToUnsigned<DF> words;
  const Rows rows = rows_of(image);
  const std::ptrdiff_t width = window.x1 - window.x0;
  for (int y = window.y0; y < window.y1; ++y, from += pitch) {
    std::uint32_t* to = rows.at(window.x0, y);
    const auto past_line = std::ptrdiff_t(reinterpret_cast<std::uintptr_t>(to) % kLineBytes / 4);
    const std::ptrdiff_t begin = std::min(width, (kLineWords - past_line) % kLineWords);
    const std::ptrdiff_t end = begin + (width - begin) / kLineWords * kLineWords;
    std::copy(from, from + begin, to);
    for (std::ptrdiff_t i = begin; i < end; i += std::ptrdiff_t(kLanes)) {
      hn::Stream(hn::LoadU(words, from + i), words, to + i);
    }
    std::copy(from + end, from + width, to + end);
  }
}

template <class To>
HWY_INLINE void load_quad(To* to, const Rows& rows, const PixelRect& window, int x, int y) {
  static_assert(sizeof(To) == sizeof(std::uint32_t));
  const std::uint32_t* from = rows.at(x, y);
  for_each_row(window, x, y, [&](int row, auto columns) HWY_ATTR {
    std::memcpy(to + row * kQuadSide, from + row * rows.pitch, columns * sizeof(To));
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
