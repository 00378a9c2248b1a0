// Decides whether two programs have drawn the same picture.
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/images/image.h>

namespace glassbox::study {

struct Picture {
  Image<Rgba8> color;
  Image<std::uint8_t> covered;  // 1 where the last pass drew something at the pixel's centre
};

// The allowed differences between two programs' pictures of a scene. docs/benchmark.md explains the
// numbers.
struct MatchBounds {
  // Two colours count as the same if no channel differs by more than this: each program rounds to a
  // byte once, and the software renderer llvmpipe computes light and texture filters with about 8
  // bits.
  int same_color = 2;  // in 1/255
  // The fraction of the pixels away from edges that may differ by more than same_color, and the
  // largest difference that is allowed for them.
  double beyond_share = 0;
  int beyond = 255;
  int samples = 1;  // samples per pixel
  int eyes = 1;     // number of eyes drawn into the picture, each with its own edges
};

struct EnginePicture {
  Picture picture;
  // 1 where one of the pixel's eight neighbours shows another triangle, or nothing.
  Image<std::uint8_t> edge;
  MatchBounds bounds;
};

// Sets `covered` to 1 where the depth is not that of an empty buffer.
void mark_covered(const Image<std::uint32_t>& depth, Image<std::uint8_t>& covered);

struct PictureMatch {
  MatchBounds bounds;
  std::uint64_t pixels = 0;
  std::uint64_t covered = 0, peer_covered = 0;
  // The number of edge pixels at which an edge is visible: within one pixel of them there are two
  // different colours, or a covered and an uncovered pixel.
  std::uint64_t edges = 0;
  std::uint64_t coverage_differs = 0;
  // The number of pixels that both programs cover, or neither, and whose colours differ by more
  // than same_color of the bounds.
  std::uint64_t color_differs = 0;
  // The number of pixels away from edges that only one program covers, and the number of those with
  // colours that differ by more than same_color.
  std::uint64_t covered_away_from_edges = 0, colored_away_from_edges = 0;
  // The largest colour difference of a pixel away from edges, in 1/255.
  int largest_away_from_edges = 0;
  // The largest colour difference of all pixels that neither coverage_differs nor color_differs
  // counts, in 1/255.
  int largest_elsewhere = 0;
  // A histogram of the colour differences away from edges: entry i counts the pixels that differ by
  // i/255.
  std::array<std::uint64_t, 256> differences{};

  std::uint64_t differing() const { return coverage_differs + color_differs; }
  std::uint64_t at_edges() const {
    return differing() - covered_away_from_edges - colored_away_from_edges;
  }
  std::uint64_t allowed_at_edges() const;
  bool same() const;
};

// Compares two pictures of the same size.
PictureMatch match(const EnginePicture& ours, const Picture& theirs);

}  // namespace glassbox::study
