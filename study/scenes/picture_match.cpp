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

// Whether one of the pixel's neighbours has another coverage or a visibly different colour.
bool shows_edge(const EnginePicture& ours, int x, int y) {
  const auto& [color, covered] = ours.picture;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, color.height - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, color.width - 1); ++u) {
      if (covered.at(u, v) != covered.at(x, y)) return true;
      if (largest_difference(color.at(u, v), color.at(x, y)) > ours.bounds.same_color) return true;
    }
  }
  return false;
}

std::uint64_t edges_shown(const EnginePicture& ours) {
  std::uint64_t count = 0;
  for (int y = 0; y < ours.edge.height; ++y) {
    for (int x = 0; x < ours.edge.width; ++x) {
      count += ours.edge.at(x, y) != 0 && shows_edge(ours, x, y);
    }
  }
  return count;
}

}  // namespace

void mark_covered(const Image<std::uint32_t>& depth, Image<std::uint8_t>& covered) {
  for (std::size_t i = 0; i < depth.pixels.size(); ++i) {
    if (depth.pixels[i] != kEmptyDepth) covered.pixels[i] = 1;
  }
}

// Two programs may snap the vertices of an edge up to 1/256 px apart. In each row or column that
// the edge crosses, the pixel nearest to the edge then changes sides with a probability of up to
// 2/256; the same is true for each of its samples and for each eye. Three pixels per row count as
// edge pixels, so the expected fraction of them that differ is 2/(3 * 256) = 2/768. This function
// allows half as many again (3/768 = 1/256), plus two pixels for pictures with hardly any edges,
// plus the fraction that is allowed away from edges.
std::uint64_t PictureMatch::allowed_at_edges() const {
  return 2 + edges * std::uint64_t(bounds.samples * bounds.eyes) / 256 +
         std::uint64_t(bounds.beyond_share * double(edges));
}

bool PictureMatch::same() const {
  return covered_away_from_edges == 0 && largest_away_from_edges <= bounds.beyond &&
         double(colored_away_from_edges) <= bounds.beyond_share * double(pixels) &&
         at_edges() <= allowed_at_edges();
}

PictureMatch match(const EnginePicture& ours, const Picture& theirs) {
  PictureMatch found;
  found.bounds = ours.bounds;
  found.pixels = ours.edge.pixels.size();
  found.edges = edges_shown(ours);
  for (std::size_t i = 0; i < found.pixels; ++i) {
    const bool covered = ours.picture.covered.pixels[i] != 0;
    const bool peer_covered = theirs.covered.pixels[i] != 0;
    const bool at_edge = ours.edge.pixels[i] != 0;
    const int apart = largest_difference(ours.picture.color.pixels[i], theirs.color.pixels[i]);
    found.covered += covered;
    found.peer_covered += peer_covered;
    if (!at_edge) ++found.differences[std::size_t(apart)];
    if (covered != peer_covered) {
      ++found.coverage_differs;
      found.covered_away_from_edges += !at_edge;
    } else if (apart > ours.bounds.same_color) {
      ++found.color_differs;
      found.colored_away_from_edges += !at_edge;
    } else {
      found.largest_elsewhere = std::max(found.largest_elsewhere, apart);
    }
    if (!at_edge) found.largest_away_from_edges = std::max(found.largest_away_from_edges, apart);
  }
  return found;
}

}  // namespace glassbox::study
