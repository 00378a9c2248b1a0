#include "study/scenes/picture_match.h"

#include <algorithm>
#include <cstdlib>

#include <glassbox/raster/depth.h>

namespace glassbox::study {

namespace {

int largest_difference(const Rgba8& a, const Rgba8& b) {
  const auto apart = [](std::uint8_t x, std::uint8_t y) { return std::abs(int(x) - int(y)); };
  return std::max({apart(a.r, b.r), apart(a.g, b.g), apart(a.b, b.b), apart(a.a, b.a)});
}

bool differs_around(const Image<std::uint32_t>& id, int x, int y) {
  const std::uint32_t here = id.at(x, y);
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, id.height - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, id.width - 1); ++u) {
      if (id.at(u, v) != here) return true;
    }
  }
  return false;
}

}  // namespace

void mark_covered(const Image<std::uint32_t>& depth, Image<std::uint8_t>& covered) {
  for (std::size_t i = 0; i < depth.pixels.size(); ++i) {
    if (depth.pixels[i] != kEmptyDepth) covered.pixels[i] = 1;
  }
}

void mark_edges(const Image<std::uint32_t>& id, Image<std::uint8_t>& edge) {
  for (int y = 0; y < id.height; ++y) {
    for (int x = 0; x < id.width; ++x) {
      if (differs_around(id, x, y)) edge.at(x, y) = 1;
    }
  }
}

PictureMatch match(const JudgedPicture& ours, const Picture& theirs) {
  PictureMatch found;
  found.pixels = ours.edge.pixels.size();
  for (std::size_t i = 0; i < found.pixels; ++i) {
    const bool covered = ours.picture.covered.pixels[i] != 0;
    const bool peer_covered = theirs.covered.pixels[i] != 0;
    const int apart = largest_difference(ours.picture.color.pixels[i], theirs.color.pixels[i]);
    found.covered += covered;
    found.peer_covered += peer_covered;
    if (covered != peer_covered) {
      ++found.coverage_differs;
    } else if (apart > kSameColor) {
      ++found.color_differs;
    } else {
      found.largest_elsewhere = std::max(found.largest_elsewhere, apart);
      continue;
    }
    found.away_from_edges += ours.edge.pixels[i] == 0;
  }
  return found;
}

}  // namespace glassbox::study
