// Whether two programs have drawn the same thing.
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/images/image.h>

namespace glassbox::study {

struct Picture {
  Image<Rgba8> color;
  Image<std::uint8_t> covered;  // 1 where the last pass drew anything, at the pixel's centre
};

// How far two programs' pictures of a scene may be apart. docs/benchmark.md says where the numbers come from.
struct MatchBounds {
  // A channel of the same colour may differ by so much: both round a byte once, and llvmpipe's light and texture filters have
  // some 8 bits of their own.
  int same_color = 2;  // 1/255
  // Of the pixels away from edges so many may differ by more, and by how much at most.
  double beyond_share = 0;
  int beyond = 255;
  int samples = 1;  // of a pixel
  int eyes = 1;     // that draw into the picture, each with edges of its own
};

struct JudgedPicture {
  Picture picture;
  // 1 where another triangle, or nothing, is seen at one of the pixel's eight neighbours.
  Image<std::uint8_t> edge;
  MatchBounds bounds;
};

// Sets 1 where the depth is not that of an empty buffer.
void mark_covered(const Image<std::uint32_t>& depth, Image<std::uint8_t>& covered);

struct PictureMatch {
  MatchBounds bounds;
  std::uint64_t pixels = 0;
  std::uint64_t covered = 0, peer_covered = 0;
  // Edges that show: within a pixel of them are two colours that are not the same, or something and nothing.
  std::uint64_t edges = 0;
  std::uint64_t coverage_differs = 0;
  // Of the pixels that both or neither covers: by more than the bounds' same_color.
  std::uint64_t color_differs = 0;
  // Of these two, those that are not at an edge: covered otherwise, or coloured otherwise, and by how much at most.
  std::uint64_t covered_away_from_edges = 0, colored_away_from_edges = 0;
  int largest_away_from_edges = 0;  // 1/255
  int largest_elsewhere = 0;        // 1/255, where neither differs
  // By how much the colours away from edges differ: pixels, by 1/255.
  std::array<std::uint64_t, 256> differences{};

  std::uint64_t differing() const { return coverage_differs + color_differs; }
  std::uint64_t at_edges() const {
    return differing() - covered_away_from_edges - colored_away_from_edges;
  }
  std::uint64_t allowed_at_edges() const;
  bool same() const;
};

// Both pictures have the same size.
PictureMatch match(const JudgedPicture& ours, const Picture& theirs);

}  // namespace glassbox::study
