#include "views/polygons/coloring.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <unordered_map>
#include <unordered_set>

#include <fmt/format.h>

#include <glassbox/base/elapsed.h>
#include <glassbox/base/elementary.h>

#include "views/polygons/cell_table.h"

namespace glassbox::views {

namespace {

Rgba8 mean_of(const PolygonObservation& seen) {
  const auto mean = [&](std::size_t c) {
    return std::uint8_t((2 * seen.sums[c] + seen.pixels) / (2 * seen.pixels));
  };
  return {mean(0), mean(1), mean(2), 255};
}

// The voxel behind a polygon: among the full voxels at the corners of the polygon's cell, the one
// whose centre is nearest to the polygon's middle; of equally near ones the first.
VoxelPosition voxel_behind(const EditableSurface& surface, const WorldPolygon& polygon) {
  const CellPosition cell = surface.cell_of(polygon.id);
  const Vector3d middle = (polygon.corners[0] + polygon.corners[1] + polygon.corners[2]) / 3;
  VoxelPosition nearest;
  double least = INFINITY;
  for (int corner = 0; corner < 8; ++corner) {
    const VoxelPosition voxel{cell.x + (corner & 1), cell.y + (corner >> 1 & 1),
                              cell.z + (corner >> 2)};
    if (!surface.occupancy().has(voxel)) continue;
    const double distance = (surface.occupancy().grid().centre(voxel) - middle).squaredNorm();
    if (!(distance < least)) continue;
    least = distance;
    nearest = voxel;
  }
  return nearest;
}

// Whether any picture has background at the pixel that shows this point of the world.
bool is_outside_object(const PictureSet& set, const Vector3d& world) {
  return std::ranges::any_of(set.pictures, [&](const CalibratedPicture& picture) {
    if (picture.matte.pixels.empty()) return false;
    const Vector3d at = project(picture.camera, world);
    const double x = std::floor(at.x()), y = std::floor(at.y());
    if (!(at.z() > 0) || !(x >= 0 && x < picture.matte.width && y >= 0 && y < picture.matte.height))
      return false;
    return picture.matte.at(int(x), int(y)) == 0;
  });
}

// How much of the pixels' colours a set of polygons leaves unexplained.
struct Residual {
  // In squared levels: the squared distances of the pixels from their polygon's mean colour, and
  // kMismatchPenalty for each pixel that shows a polygon but has background, or the other way
  // round.
  double squares = 0;
  std::int64_t polygons = 0;  // polygons that are seen
  std::int64_t pixels = 0;

  // Each seen polygon has its own colour, which is three free numbers, so with more polygons
  // `squares` is always smaller. By the Bayesian information criterion (Schwarz 1978) each free
  // number has to reduce it by the logarithm of the number of pixels, in units of the variance that
  // one colour may have.
  double with_cost(std::int64_t of_pixels, double variance) const {
    return squares + 3 * double(polygons) * logarithm(double(of_pixels)) * variance;
  }
};
// The expected squared distance of two random colours between 0 and 255: 2 * 255^2 / 12 for each of
// three channels.
constexpr double kMismatchPenalty = 3 * 255.0 * 255.0 / 6;

// Tests whether the pictures are explained better without a voxel: by the polygons that then
// replace the voxel's polygons, and by polygons behind it.
class TrialCarving {
public:
  TrialCarving(const PictureSet& set, EditableSurface& surface, double threshold)
      : set_(set), surface_(surface), variance_(threshold * threshold) {}

  // Removes the voxel and returns the polygons that have changed; or leaves the surface as it is,
  // and returns nothing.
  std::vector<PolygonId> carve(const VoxelPosition& voxel) {
    const std::vector<WorldPolygon> own = around(voxel);
    std::vector<PolygonId> changed = surface_.set_voxel(voxel, false), asked = changed;
    for (const WorldPolygon& polygon : own) asked.push_back(polygon.id);
    std::ranges::sort(asked);
    asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
    Residual without = residual_of(asked);
    without.squares += kMismatchPenalty * double(uncovered_by(own));
    surface_.set_voxel(voxel, true);
    const Residual with = residual_of(asked);
    // The surfaces with and without the voxel show the same pixels, except for some at the edges of
    // polygons, which two polygons show or none. The larger number is used for both surfaces.
    const std::int64_t pixels = std::max({with.pixels, without.pixels, std::int64_t(1)});
    if (!(without.with_cost(pixels, variance_) < with.with_cost(pixels, variance_))) return {};
    return surface_.set_voxel(voxel, false);
  }

private:
  std::vector<WorldPolygon> around(const VoxelPosition& voxel) const {
    std::vector<WorldPolygon> all;
    for (const CellPosition& cell : surface_.cells_around(voxel)) {
      const auto here = surface_.polygons_of(cell);
      all.insert(all.end(), here.begin(), here.end());
    }
    return all;
  }

  Residual residual_of(const std::vector<PolygonId>& ids) const {
    Residual sum;
    for (const PolygonId id : ids) {
      if (!surface_.has(id)) continue;
      const PolygonObservation seen = observe_polygon(set_, surface_, surface_.polygon(id));
      sum.squares += seen.residual() + kMismatchPenalty * double(seen.background);
      sum.polygons += seen.pixels > 0;
      sum.pixels += seen.pixels + seen.background;
    }
    return sum;
  }

  // Counts the pixels of the object that show no polygon any more at the places of these polygons.
  std::int64_t uncovered_by(const std::vector<WorldPolygon>& polygons) const {
    std::int64_t uncovered = 0;
    for (std::size_t i = 0; i < set_.pictures.size(); ++i) {
      const CalibratedPicture& picture = set_.pictures[i];
      for (const WorldPolygon& polygon : polygons) {
        PolygonFootprint(picture.camera, picture.color.width, picture.color.height, polygon.corners)
            .for_each_pixel([&](IdPixel at, float) {
              uncovered += surface_.layers()[i].front(at) == nullptr &&
                           (picture.matte.pixels.empty() || picture.matte.at(at.x, at.y) != 0);
            });
      }
    }
    return uncovered;
  }

  const PictureSet& set_;
  EditableSurface& surface_;
  double variance_;
};

class Carving {
public:
  Carving(const PictureSet& set, EditableSurface& surface, const PolygonColoringSettings& settings)
      : set_(set),
        surface_(surface),
        settings_(settings),
        trial_(set, surface, settings.threshold) {}

  // Returns false if the layered images need more than `most_bytes`.
  bool run(PolygonColoring& result, double most_bytes) {
    for (const PolygonId id : surface_.polygons()) ask(id);
    while (!waiting_.empty()) {
      if (surface_.layer_bytes() > most_bytes) return false;
      const PolygonId id = waiting_.front();
      waiting_.pop_front();
      is_waiting_.erase(id);
      if (!surface_.has(id)) continue;
      ++result.examined;
      const WorldPolygon polygon = surface_.polygon(id);
      const PolygonObservation seen = observe_polygon(set_, surface_, polygon);
      const VoxelPosition behind = voxel_behind(surface_, polygon);
      // A polygon is half a voxel in front of the middle of the voxel behind it. So the polygon may
      // be outside of the object's outline although the voxel is not; therefore the voxel's middle
      // is tested.
      const bool is_beside = seen.background > 0 &&
                             is_outside_object(set_, surface_.occupancy().grid().centre(behind));
      // One picture alone cannot show that colours are inconsistent.
      const bool is_inconsistent = seen.views > 1 && seen.deviation() > settings_.threshold;
      if (!is_beside && !is_inconsistent) continue;
      const std::vector<PolygonId> changed =
          is_beside ? surface_.set_voxel(behind, false) : trial_.carve(behind);
      if (changed.empty()) {
        ++result.kept;
        continue;
      }
      ++(is_beside ? result.carved_by_background : result.carved_by_color);
      for (const PolygonId other : changed) ask(other);
    }
    return true;
  }

private:
  void ask(PolygonId id) {
    if (is_waiting_.insert(id).second) waiting_.push_back(id);
  }

  const PictureSet& set_;
  EditableSurface& surface_;
  const PolygonColoringSettings& settings_;
  TrialCarving trial_;
  std::deque<PolygonId> waiting_;
  std::unordered_set<PolygonId> is_waiting_;
};

// Gives each polygon that no picture sees the mean colour of its coloured neighbours, and repeats
// this for the polygons next to them.
void color_unseen(const PolygonMesh& mesh, std::vector<PolygonColor>& colors) {
  std::unordered_map<std::uint64_t, std::array<std::uint32_t, 2>> beside;
  beside.reserve(3 * mesh.polygons.size() / 2);
  const auto key = [](std::uint32_t a, std::uint32_t b) {
    return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
  };
  for (std::uint32_t i = 0; i < mesh.polygons.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [place, is_first] =
          beside.try_emplace(key(mesh.polygons[i][k], mesh.polygons[i][(k + 1) % 3]),
                             std::array<std::uint32_t, 2>{i, i});
      if (!is_first) place->second[1] = i;
    }
  }
  std::vector<bool> has_color(colors.size());
  std::vector<std::uint32_t> without;
  for (std::uint32_t i = 0; i < colors.size(); ++i) {
    has_color[i] = colors[i].views > 0;
    if (!has_color[i]) without.push_back(i);
  }
  while (!without.empty()) {
    std::vector<std::pair<std::uint32_t, Rgba8>> found;
    std::vector<std::uint32_t> left;
    for (const std::uint32_t i : without) {
      int sum[3] = {0, 0, 0}, count = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& pair = beside[key(mesh.polygons[i][k], mesh.polygons[i][(k + 1) % 3])];
        const std::uint32_t other = pair[0] == i ? pair[1] : pair[0];
        if (!has_color[other]) continue;
        const Rgba8& c = colors[other].color;
        sum[0] += c.r;
        sum[1] += c.g;
        sum[2] += c.b;
        ++count;
      }
      if (count == 0) {
        left.push_back(i);
        continue;
      }
      const auto mean = [&](int c) { return std::uint8_t(sum[c] / count); };
      found.emplace_back(i, Rgba8{mean(0), mean(1), mean(2), 255});
    }
    if (found.empty()) break;  // a connected surface of which nothing is seen stays grey
    for (const auto& [i, color] : found) {
      colors[i].color = color;
      has_color[i] = true;
    }
    without = std::move(left);
  }
}

}  // namespace

double polygon_bytes(const VoxelGrid& grid, double polygons) {
  // The bits of the original solid and of what is left of it, a number for each voxel, and numbers
  // for the corners on the edges of two layers of voxels.
  const auto [nx, ny, nz] = grid.count;
  const double voxels = 2 * Occupancy::bytes_for(grid) + double(grid.voxels()) * sizeof(double) +
                        double(nx + 2) * (ny + 2) * 2 * 7 * sizeof(std::uint32_t);
  // A closed surface has half as many corners as polygons. The arrays of both grow while they are
  // filled, to at most twice the memory. Then there are the colours, and three sides for every two
  // polygons, each in a node of a hash table with a bucket that points to it (color_unseen). The
  // queue of polygons to be examined no longer exists then, and was smaller.
  constexpr double kMesh =
      2 * (sizeof(Vector3d) / 2.0 + sizeof(PolygonCorners)) + sizeof(PolygonColor);
  constexpr double kSides = 1.5 * (32 + 2 * sizeof(void*));
  return voxels + polygons * (kMesh + kSides);
}

double layer_bytes(const PictureSet& set) {
  double bytes = object_pixels_of(set) * IdLayers::kBytesOfPixel;
  for (const CalibratedPicture& picture : set.pictures)
    bytes += IdLayers::empty_bytes(picture.color.width, picture.color.height);
  return bytes;
}

double PolygonObservation::residual() const {
  if (pixels < 2) return 0;
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c)
    sum += double(squares[c]) - double(sums[c]) * double(sums[c]) / double(pixels);
  return std::max(0.0, sum);
}

double PolygonObservation::deviation() const {
  return pixels < 2 ? 0 : std::sqrt(residual() / (3 * double(pixels - 1)));
}

PolygonObservation observe_polygon(const PictureSet& set, const EditableSurface& surface,
                                   const WorldPolygon& polygon) {
  PolygonObservation seen;
  for (std::size_t i = 0; i < set.pictures.size(); ++i) {
    const CalibratedPicture& picture = set.pictures[i];
    std::int64_t object = 0, background = 0;
    const PolygonFootprint footprint(picture.camera, picture.color.width, picture.color.height,
                                     polygon.corners);
    footprint.for_each_pixel([&](IdPixel at, float) {
      const IdSample* front = surface.layers()[i].front(at);
      if (front == nullptr || front->id != polygon.id) return;
      if (!picture.matte.pixels.empty() && picture.matte.at(at.x, at.y) == 0) {
        ++background;
        return;
      }
      ++object;
      const Rgba8& color = picture.color.at(at.x, at.y);
      const std::array<int, 3> levels{color.r, color.g, color.b};
      for (std::size_t c = 0; c < 3; ++c) {
        seen.sums[c] += levels[c];
        seen.squares[c] += std::int64_t(levels[c]) * levels[c];
      }
    });
    seen.pixels += object;
    seen.background += background;
    seen.views += object > 0;
  }
  return seen;
}

Result<PolygonColoring> color_polygons(const PictureSet& set, const Occupancy& occupancy,
                                       const PolygonColoringSettings& settings) {
  if (EditableSurface::is_too_large(occupancy.grid())) {
    return fail("--resolution",
                fmt::format("{} voxels may have more polygons than 32 bits can number",
                            occupancy.grid().voxels()),
                "ask for larger voxels");
  }
  if (occupancy.full() == 0) {
    return fail("the voxels", "none of them is coloured, so there is no surface",
                "raise --threshold, or see with `glassbox views voxels` which voxels are coloured");
  }
  const std::int64_t polygons = EditableSurface::count_polygons(occupancy);
  const double bytes = polygon_bytes(occupancy.grid(), double(polygons));
  const auto refused = [&](const std::string& what) {
    return fail(
        "--max-mb",
        fmt::format("{} polygons{} need more memory than this option allows", polygons, what),
        "use larger voxels or smaller pictures, or allow more memory");
  };
  if (bytes > settings.most_bytes) return refused("");
  const auto start = std::chrono::steady_clock::now();
  PolygonColoring result;
  result.grid = occupancy.grid();
  result.full_before = occupancy.full();
  const double for_layers = settings.most_bytes - bytes;
  EditableSurface surface(set, occupancy, settings.threads, for_layers);
  const bool fits = surface.layer_bytes() <= for_layers &&
                    (!settings.carves || Carving(set, surface, settings).run(result, for_layers));
  if (!fits) return refused(" and their layered images");
  result.full = surface.occupancy().full();
  for (const IdLayers& layers : surface.layers()) result.samples += layers.sample_count();
  const Occupancy& solid = surface.occupancy();
  // polygonise() visits the same cells in the same order, so polygon i of the mesh is the i-th of
  // the surface.
  result.mesh = polygonise(settings.is_smooth ? solid.smooth_field() : solid.field(), 0.5,
                           Polygoniser::kConsistent);
  result.colors.reserve(result.mesh.polygons.size());
  for (const PolygonId id : surface.polygons()) {
    const PolygonObservation seen = observe_polygon(set, surface, surface.polygon(id));
    PolygonColor color{{128, 128, 128, 255}, std::uint16_t(seen.views), float(seen.deviation())};
    if (seen.views > 0) color.color = mean_of(seen);
    result.unseen += seen.views == 0;
    result.colors.push_back(color);
  }
  color_unseen(result.mesh, result.colors);
  result.solid = solid;
  result.milliseconds = elapsed_ms(start);
  return result;
}

}  // namespace glassbox::views
