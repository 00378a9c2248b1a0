// Compares ways to visit the pixels of a triangle (D-27). All of them are exact; they differ in the
// number of pixels that they test in vain.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include <glassbox/images/image.h>

#include "study/experiment/experiment.h"
#include "study/experiments/d27_walks.h"
#include "study/experiments/random_triangles.h"

namespace glassbox::study {

namespace d27 {

// ---- the reference ----

__extension__ typedef __int128 Int128;

// Counts how many triangles cover each pixel, by the definition: the edges' coefficients in 128
// bits, for every pixel of the window, without bounding boxes.
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

  // Computed on the first request.
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

// Enough triangles for a call to take at least a fraction of a millisecond.
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
                   .work = std::move(work),
                   .items = double(kind->triangles.size()) * times});
  };
  const int times = size < 10 ? 64 : 8;
  for (const auto& [name, walk] : kTraversals) {
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

}  // namespace d27

Experiment d27_hierarchical_raster() {
  using namespace d27;
  return {
      .id = "D-27",
      .name = "Hierarchical rasterization: which pixels are tested",
      .question = "From which size on does it pay to test blocks of pixels before single pixels?",
      .axis = "size of the triangles",
      .axis_unit = "px",
      .error = "pixels that are wrongly covered or wrongly not covered",
      .error_unit = "pixels",
      .reference =
          "the definition (edge functions and top-left rule) in 128 bits at every pixel of the "
          "picture",
      .theory =
          "All ways compute in integers, so no pixel is wrong. A box of side L has L^2 pixels. A "
          "compact triangle covers up to half of them, and a sliver only L/2, which is the worst "
          "case: O(L^2) tests for O(L) pixels. Blocks test O(L) pixels along the edges, and rows "
          "need three divisions each.",
      .item = "triangle",
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
