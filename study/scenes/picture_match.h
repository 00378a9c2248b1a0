// Whether two programs have drawn the same thing.
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>

namespace glassbox::study {

struct Picture {
  Image<Rgba8> color;
  Image<std::uint8_t> covered;  // 1 where the last pass drew anything
};

struct JudgedPicture {
  Picture picture;
  // 1 where another triangle, or nothing, is seen at one of the pixel's eight neighbours.
  Image<std::uint8_t> edge;
};

// Sets 1 where the depth is not that of an empty buffer.
void mark_covered(const Image<std::uint32_t>& depth, Image<std::uint8_t>& covered);
// Sets 1 where `id` has two values or more in the pixel's 3 x 3 neighbourhood.
void mark_edges(const Image<std::uint32_t>& id, Image<std::uint8_t>& edge);

// A channel of the same colour may differ by so much: both round a byte once, and llvmpipe's light and texture filters
// have some 8 bits of their own.
inline constexpr int kSameColor = 2;  // 1/255

struct PictureMatch {
  std::uint64_t pixels = 0;
  std::uint64_t covered = 0, peer_covered = 0;
  std::uint64_t coverage_differs = 0;
  // Of the pixels that both or neither covers: by more than kSameColor.
  std::uint64_t color_differs = 0;
  std::uint64_t away_from_edges = 0;  // of these two, those that are not at an edge
  int largest_elsewhere = 0;          // 1/255, where neither differs

  std::uint64_t differing() const { return coverage_differs + color_differs; }
  // Two programs snap an edge's ends up to 1/256 px apart, so that a pixel of the outline changes sides with a
  // probability of about 2/256. The scenes' outlines are below 2 (width + height) = 6000 px at 1920 x 1080: 47 pixels,
  // of which one in ten thousand of the picture, 207, is four times as many.
  std::uint64_t allowed() const { return pixels / 10000; }
  bool same() const { return away_from_edges == 0 && differing() <= allowed(); }
};

// Both pictures have the same size.
PictureMatch match(const JudgedPicture& ours, const Picture& theirs);

}  // namespace glassbox::study
