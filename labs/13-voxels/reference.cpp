#include "labs/13-voxels/reference.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace glassbox::labs::voxels {

using namespace lab_13;

Order classify(const std::vector<Place>& cameras, const Box& box) {
  const std::array<double, 3> low{box.low.x, box.low.y, box.low.z},
      high{box.high.x, box.high.y, box.high.z};
  Order order;
  int orders = 0;
  bool is_outside = false;
  for (std::size_t i = 0; i < 3; ++i) {
    double least = INFINITY, greatest = -INFINITY;
    for (const Place& camera : cameras) {
      const double c = std::array<double, 3>{camera.x, camera.y, camera.z}[i];
      least = std::min(least, c);
      greatest = std::max(greatest, c);
    }
    order.away[i] = greatest < low[i] ? 1 : least > high[i] ? -1 : 0;
    orders += order.away[i] != 0;
    is_outside = is_outside || least < low[i] || greatest > high[i];
  }
  order.kind = orders == 3   ? Kind::kOctant
               : orders == 2 ? Kind::kQuadrant
               : orders == 1 ? Kind::kHalfSpace
               : is_outside  ? Kind::kSurrounded
                             : Kind::kEmbedded;
  return order;
}

Statistics statistics(const std::vector<Colour>& colours) {
  Statistics result;
  if (colours.empty()) return result;
  const auto count = static_cast<long double>(colours.size());
  long double squares = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    long double sum = 0;
    for (const Colour& colour : colours) sum += colour[k];
    const long double mean = sum / count;
    for (const Colour& colour : colours) squares += (colour[k] - mean) * (colour[k] - mean);
    result.mean[k] = double(mean);
  }
  if (colours.size() > 1) result.deviation = double(std::sqrt(squares / (3 * (count - 1))));
  return result;
}

namespace {

double largest(const std::vector<Colour>& colours) {
  double most = 0;
  for (const Colour& colour : colours)
    for (const double value : colour) most = std::max(most, std::abs(value));
  return most;
}

}  // namespace

// The bound: a sum of K numbers rounds K - 1 times, each time by u of at most K times the largest
// number, where u is the unit roundoff. The division by K leaves (K - 1) u of the largest number
// and rounds once more.
double mean_bound(const std::vector<Colour>& colours) {
  return (double(colours.size()) + 4) * kUnit * largest(colours);
}

// The bound: a variance of n values has a relative error of n u kappa with kappa^2 = 1 + mean^2 /
// deviation^2 (Chan, Golub and LeVeque 1983). Its root, the deviation, has half of that and a few
// roundings more; kappa times the deviation is at most the hypot() below. If all values are equal,
// a mean with an error of some u leaves a deviation of that size.
double deviation_bound(const std::vector<Colour>& colours, double deviation) {
  return (double(colours.size()) + 8) * kUnit * std::hypot(deviation, largest(colours));
}

Verdict judge(const std::vector<std::vector<Pixel>>& pictures, const Threshold& threshold) {
  const auto is_seen = [](const Pixel& pixel) { return !pixel.is_background && !pixel.is_hidden; };
  std::vector<std::vector<Colour>> views;
  for (const std::vector<Pixel>& pixels : pictures) {
    const bool all_background =
        std::ranges::all_of(pixels, [](const Pixel& pixel) { return pixel.is_background; });
    if (!pixels.empty() && all_background) return Verdict::kBackground;
    std::vector<Colour> seen;
    for (const Pixel& pixel : pixels)
      if (is_seen(pixel)) seen.push_back(pixel.colour);
    if (!seen.empty()) views.push_back(std::move(seen));
  }
  if (views.size() < 2) return views.empty() ? Verdict::kHidden : Verdict::kAlone;
  std::vector<Colour> together;
  double within = 0;
  for (const std::vector<Colour>& seen : views) {
    together.insert(together.end(), seen.begin(), seen.end());
    within += voxels::statistics(seen).deviation / double(views.size());
  }
  const bool is_one = voxels::statistics(together).deviation < threshold.k1 * within + threshold.k2;
  return is_one ? Verdict::kColoured : Verdict::kInconsistent;
}

namespace {

struct ProjectedPoint {
  long double u = 0, v = 0;
};
// Returns nothing where the point is not in front of the camera.
std::optional<ProjectedPoint> project(const Projection& p, long double x, long double y,
                                      long double z) {
  long double h[3];
  for (std::size_t i = 0; i < 3; ++i) h[i] = p[i][0] * x + p[i][1] * y + p[i][2] * z + p[i][3];
  if (!(h[2] > 0)) return std::nullopt;
  return ProjectedPoint{h[0] / h[2], h[1] / h[2]};
}

std::optional<PixelAt> centre_pixel(const Projection& p, const Voxel& voxel, int width,
                                    int height) {
  const auto at = project(p, voxel.x + 0.5L, voxel.y + 0.5L, voxel.z + 0.5L);
  if (!at || at->u < 0 || at->v < 0 || at->u >= width || at->v >= height) return std::nullopt;
  return PixelAt{int(at->u), int(at->v)};
}

}  // namespace

std::vector<PixelAt> footprint(const Projection& pixel_from_grid, const Voxel& voxel, int width,
                               int height) {
  if (!project(pixel_from_grid, voxel.x + 0.5L, voxel.y + 0.5L, voxel.z + 0.5L)) return {};
  const auto own = centre_pixel(pixel_from_grid, voxel, width, height);
  std::vector<ProjectedPoint> corners;
  for (int i = 0; i < 8; ++i) {
    const auto at =
        project(pixel_from_grid, voxel.x + (i & 1), voxel.y + (i >> 1 & 1), voxel.z + (i >> 2));
    if (at) corners.push_back(*at);
  }
  std::vector<PixelAt> pixels;
  bool has_own = false;
  for (int row = 0; row < height && corners.size() == 8; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto [left, right] = std::ranges::minmax(corners, {}, &ProjectedPoint::u);
      const auto [top, bottom] = std::ranges::minmax(corners, {}, &ProjectedPoint::v);
      const long double u = column + 0.5L, v = row + 0.5L;
      if (u < left.u || u > right.u || v < top.v || v > bottom.v) continue;
      pixels.push_back({column, row});
      has_own = has_own || (own && own->column == column && own->row == row);
    }
  }
  if (own && !has_own) pixels.push_back(*own);
  return pixels;
}

std::vector<Coloured> sweep(std::vector<Picture> pictures, const Grid& grid,
                            const Threshold& threshold) {
  // The number of a voxel's layer, in the order in which layers are visited.
  const auto layer_of = [&](const Voxel& v) {
    const int place = grid.axis == 0 ? v.x : grid.axis == 1 ? v.y : v.z;
    return grid.away > 0 ? place : grid.count[std::size_t(grid.axis)] - 1 - place;
  };
  std::vector<std::vector<Voxel>> layers(std::size_t(grid.count[std::size_t(grid.axis)]));
  for (int z = 0; z < grid.count[2]; ++z)
    for (int y = 0; y < grid.count[1]; ++y)
      for (int x = 0; x < grid.count[0]; ++x)
        layers[std::size_t(layer_of({x, y, z}))].push_back({x, y, z});
  std::vector<Coloured> coloured;
  for (const std::vector<Voxel>& layer : layers) {
    std::vector<Pixel*> to_hide;
    for (const Voxel& voxel : layer) {
      std::vector<Pixel*> here;
      std::vector<std::vector<Pixel>> seen;
      for (Picture& picture : pictures) {
        const auto at = centre_pixel(picture.pixel_from_grid, voxel, picture.width, picture.height);
        if (!at) continue;
        here.push_back(&picture.pixels[std::size_t(at->row * picture.width + at->column)]);
        seen.push_back({*here.back()});
      }
      if (voxels::judge(seen, threshold) != Verdict::kColoured) continue;
      std::vector<Colour> colours;
      for (const Pixel* pixel : here)
        if (!pixel->is_hidden) colours.push_back(pixel->colour);
      coloured.push_back({voxel, voxels::statistics(colours).mean});
      to_hide.insert(to_hide.end(), here.begin(), here.end());
    }
    for (Pixel* pixel : to_hide) pixel->is_hidden = true;
  }
  return coloured;
}

}  // namespace glassbox::labs::voxels
