// Pairs of pictures in which edges moved by a part of a pixel, with pixels that really changed
// among them, and which these are.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/stored_image.h>

namespace glassbox::test {

enum class ChangeKind : std::uint8_t { kOnPlain, kAtEdge };

// A pixel of the test that got another colour, at least 64 steps away in some channel.
struct ChangedPixel {
  PixelPosition at;
  ChangeKind kind = ChangeKind::kOnPlain;  // kAtEdge: less than 3 px from another colour
};

struct MovedPair {
  std::string name;  // "small-dark-text-0.3": the look, and by how far it moved in px
  double shift = 0;
  StoredImage reference, test;
  std::vector<ChangedPixel> changed;
  bool has_changed(int x, int y) const;
};

// The looks of the pictures: text of three sizes, dark and light, blended as browsers do (in the
// codes of sRGB) or as renderers do (in linear light), text on a gradient, and shapes. Glyphs are
// strokes of circles and segments. A pixel's coverage is that of 16 x 16 samples.
std::vector<std::string> moved_edge_looks();

// The picture of a look, drawn again after a movement by `shift` px in a direction that `seed`
// chooses. Then up to `changes` pixels get another colour, one half of them beside edges.
MovedPair moved_pair(const std::string& look, double shift, int changes, std::uint64_t seed,
                     int width = 240, int height = 150);

}  // namespace glassbox::test
