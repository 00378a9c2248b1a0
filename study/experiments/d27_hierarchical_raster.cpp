// D-27: ways to walk over the pixels of a triangle. All of them are exact; they differ in how much they look at in vain.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include <glassbox/images/image.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/lanes/kernels.h>

#include "study/experiments/experiments.h"
#include "study/experiments/shapes.h"

namespace glassbox::study {

namespace {

constexpr PixelRect kWindow{0, 0, kShapesSide, kShapesSide};
using Counts = Image<std::uint16_t>;  // how many triangles cover each pixel
using Triangles = std::vector<TriangleSetup>;

std::int64_t value_at(const EdgeFunction& edge, int x, int y) {
  return edge.at(std::int64_t(x) * kSubpixels + kPixelCentre,
                 std::int64_t(y) * kSubpixels + kPixelCentre);
}

// The smallest value that counts as covered.
std::int64_t least(const EdgeFunction& edge) {
  return edge.owns_zero ? 0 : 1;
}

// ---- the ways ----

// Every pixel of the box asks all three edges from the start.
void walk_box(const TriangleSetup& t, Counts& counts) {
  const PixelRect box = intersect(t.bounds, kWindow);
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      if (std::ranges::all_of(t.edges,
                              [&](const EdgeFunction& e) { return e.covers(value_at(e, x, y)); }))
        ++counts.at(x, y);
    }
  }
}

// The pipeline's staged coverage: one addition for each edge and pixel of the box.
void walk_incrementally(const TriangleSetup& t, Counts& counts) {
  for_each_covered(t, kWindow, [&](const Coverage& pixel) { ++counts.at(pixel.x, pixel.y); });
}

std::int64_t floor_div(std::int64_t a, std::int64_t b) {  // b > 0
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

// One span for each row, its ends by exact integer division.
void walk_rows(const TriangleSetup& t, Counts& counts) {
  const PixelRect box = intersect(t.bounds, kWindow);
  for (int y = box.y0; y < box.y1; ++y) {
    std::int64_t x0 = box.x0, x1 = box.x1;
    for (const EdgeFunction& e : t.edges) {
      const std::int64_t first = value_at(e, 0, y) - least(e),
                         step = e.a * kSubpixels;  // first + step x >= 0
      if (step > 0) x0 = std::max(x0, floor_div(-first + step - 1, step));
      if (step < 0) x1 = std::min(x1, floor_div(first, -step) + 1);
      if (step == 0 && first < 0) x1 = x0;
    }
    for (std::int64_t x = x0; x < x1; ++x) ++counts.at(int(x), y);
  }
}

// Blocks of 8 x 8 pixels: given up, taken whole, or looked at pixel by pixel. The extremes of an edge function over a block
// are at its corners.
void walk_blocks(const TriangleSetup& t, Counts& counts) {
  constexpr int kSide = 8;
  const PixelRect box = intersect(t.bounds, kWindow);
  for (int by = box.y0 / kSide * kSide; by < box.y1; by += kSide) {
    for (int bx = box.x0 / kSide * kSide; bx < box.x1; bx += kSide) {
      bool outside = false, inside = true;
      for (const EdgeFunction& e : t.edges) {
        const std::int64_t first = value_at(e, bx, by) - least(e);
        const std::int64_t right = e.a * kSubpixels * (kSide - 1),
                           down = e.b * kSubpixels * (kSide - 1);
        outside = outside ||
                  first + std::max<std::int64_t>(right, 0) + std::max<std::int64_t>(down, 0) < 0;
        inside = inside &&
                 first + std::min<std::int64_t>(right, 0) + std::min<std::int64_t>(down, 0) >= 0;
      }
      if (outside) continue;
      const PixelRect block = intersect({bx, by, bx + kSide, by + kSide}, box);
      if (inside) {
        for (int y = block.y0; y < block.y1; ++y) {
          for (int x = block.x0; x < block.x1; ++x) ++counts.at(x, y);
        }
      } else {
        for_each_covered(t, block, [&](const Coverage& pixel) { ++counts.at(pixel.x, pixel.y); });
      }
    }
  }
}

using Walk = void (*)(const TriangleSetup&, Counts&);
struct NamedWalk {
  const char* name;
  Walk walk;
};
constexpr NamedWalk kWalks[] = {{"whole box, edges anew", walk_box},
                                {"whole box, incremental", walk_incrementally},
                                {"scan lines", walk_rows},
                                {"8x8 blocks", walk_blocks}};

// ---- the tile engine's kernel ----

// Draws into one tile as large as the window; where a triangle is seen tells which pixels it covers.
void draw_over_lanes(const TriangleSetup& t, Reference reference, TileBuffer& tile) {
  static const Kernels& best = kernels(best_target());
  FragmentCounts ignored;
  best.draw_large(t, reference, tile, ignored);
}

void count_over_lanes(const TriangleSetup& t, TileBuffer& tile, Counts& counts) {
  constexpr Reference kDrawn = kLargeReference;
  tile.clear(kWindow, DepthFormat::kFloat32);
  draw_over_lanes(t, kDrawn, tile);
  for (int y = 0; y < kShapesSide; ++y) {
    for (int x = 0; x < kShapesSide; ++x) {
      const TileBlock& block = tile.block(tile.block_index(x / kBlockSide, y / kBlockSide));
      const Reference seen =
          block.plain ? block.reference : tile.reference()[tile.pixel_index(x, y)];
      counts.at(x, y) = std::uint16_t(counts.at(x, y) + (seen == kDrawn));
    }
  }
}

// ---- the reference ----

__extension__ typedef __int128 Int128;

// The definition, from the edges' own coefficients in 128 bits, for every pixel of the window, boxes not looked at.
void count_by_definition(const TriangleSetup& t, Counts& counts) {
  for (int y = 0; y < kShapesSide; ++y) {
    for (int x = 0; x < kShapesSide; ++x) {
      bool covered = true;
      for (const EdgeFunction& e : t.edges) {
        const Int128 value = Int128(e.a) * (256 * x + 128) + Int128(e.b) * (256 * y + 128) + e.c;
        const bool top = e.a == 0 && e.b > 0, left = e.a > 0;
        covered = covered && (value > 0 || (value == 0 && (top || left)));
      }
      counts.at(x, y) = std::uint16_t(counts.at(x, y) + covered);
    }
  }
}

double differences(const Counts& one, const Counts& other) {
  double sum = 0;
  for (std::size_t i = 0; i < one.pixels.size(); ++i)
    sum += std::abs(int(one.pixels[i]) - int(other.pixels[i]));
  return sum;
}

// ---- scenes ----

struct Kind {
  std::string name;
  Triangles triangles;
  std::optional<Counts> reference = {};

  // Counted when it is first asked for.
  const Counts& by_definition() {
    if (!reference) {
      reference.emplace(kShapesSide, kShapesSide);
      for (const TriangleSetup& t : triangles) count_by_definition(t, *reference);
    }
    return *reference;
  }
};

Kind make_kind(const std::string& name, double size, int count) {
  const auto stream = std::uint64_t(27000 + size);
  Triangles compact = random_triangles(Shape::kCompact, size, stream, count);
  Triangles slivers = random_triangles(Shape::kSliver, size, stream + 500, count);
  if (name == "compact") return {name, std::move(compact)};
  if (name == "slivers") return {name, std::move(slivers)};
  compact.insert(compact.end(), slivers.begin(), slivers.end());
  return {name, std::move(compact)};
}

// Enough triangles that a call takes a fraction of a millisecond and more.
int count_for(double size, Effort effort) {
  const int usual = effort == Effort::kQuick ? 48 : 256;
  return size >= 100 ? usual / 4 : usual;
}

void add_kind(const std::shared_ptr<Kind>& kind, double size, std::vector<Configuration>& all) {
  const auto add = [&](std::string series, std::function<double()> error,
                       std::function<void(int)> work, int times) {
    all.push_back({.series = std::move(series),
                   .parameter = size,
                   .scene = kind->name,
                   .error = std::move(error),
                   .predicted_error = 0,
                   .finding = {},
                   .work = std::move(work),
                   .items = double(kind->triangles.size()) * times});
  };
  const int times = size < 10 ? 64 : 8;
  for (const auto& [name, walk] : kWalks) {
    const auto counts = std::make_shared<Counts>(kShapesSide, kShapesSide);
    add(
        name,
        [=, walk = walk] {
          Counts mine(kShapesSide, kShapesSide);
          for (const TriangleSetup& t : kind->triangles) walk(t, mine);
          return differences(mine, kind->by_definition());
        },
        [=, walk = walk](int) {
          for (int i = 0; i < times; ++i) {
            for (const TriangleSetup& t : kind->triangles) walk(t, *counts);
          }
        },
        times);
  }
  const auto tile = std::make_shared<TileBuffer>(kShapesSide);
  add(
      "8x8 blocks over lanes",
      [=] {
        Counts mine(kShapesSide, kShapesSide);
        for (const TriangleSetup& t : kind->triangles) count_over_lanes(t, *tile, mine);
        return differences(mine, kind->by_definition());
      },
      [=](int) {
        for (int i = 0; i < times; ++i) {
          tile->clear(kWindow, DepthFormat::kFloat32);
          for (std::size_t k = 0; k < kind->triangles.size(); ++k)
            draw_over_lanes(kind->triangles[k], kLargeReference + Reference(k), *tile);
        }
      },
      times);
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<double> sizes{2, 8, 32, 128};
  if (effort == Effort::kFull) sizes = {2, 4, 8, 16, 32, 64, 128, 192};
  std::vector<Configuration> all;
  for (const char* name : {"compact", "slivers", "mix"}) {
    for (const double size : sizes) {
      add_kind(std::make_shared<Kind>(make_kind(name, size, count_for(size, effort))), size, all);
    }
  }
  return all;
}

}  // namespace

Experiment d27_hierarchical_raster() {
  return {
      .id = "D-27",
      .name = "Hierarchical raster: which pixels are looked at",
      .question = "From which size on does it pay to ask blocks of pixels before pixels?",
      .axis = "size of the triangles",
      .axis_unit = "px",
      .error = "pixels that are counted as covered and are not, or the other way round",
      .error_unit = "pixels",
      .reference =
          "the definition (edge functions and top-left rule) in 128 bits at every pixel of the "
          "picture",
      .theory =
          "All are integers: 0. A box of side L has L^2 pixels, of which a compact triangle covers "
          "up to a half and a sliver L/2 "
          "(its worst case, O(L^2) for O(L)); blocks look at O(L) along the edges, rows divide 3 "
          "times.",
      .item = "triangle",
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
