// Lab 13: your part. student.h says what each function must do, handout.md why.
#include "student.h"

#include <algorithm>
#include <cmath>

namespace lab_13 {

// ---- task 13.1: the order of the layers ----

Order classify(const std::vector<Place>& cameras, const Box& box) {
  // BEGIN SOLUTION
  const auto all = [&](auto test) { return std::all_of(cameras.begin(), cameras.end(), test); };
  using Axis = double Place::*;
  const Axis axes[] = {&Place::x, &Place::y, &Place::z};
  Order order;
  int orders = 0;
  bool all_inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Axis axis = axes[i];
    const double low = box.low.*axis, high = box.high.*axis;
    if (all([&](const Place& c) { return c.*axis < low; })) order.away[i] = 1;
    if (all([&](const Place& c) { return c.*axis > high; })) order.away[i] = -1;
    orders += order.away[i] != 0;
    all_inside =
        all_inside && all([&](const Place& c) { return c.*axis >= low && c.*axis <= high; });
  }
  constexpr Kind kKinds[] = {Kind::kSurrounded, Kind::kHalfSpace, Kind::kQuadrant, Kind::kOctant};
  order.kind = orders == 0 && all_inside ? Kind::kEmbedded : kKinds[orders];
  return order;
  // STUB: return {};  // all beyond the same face, along how many axes?
  // END SOLUTION
}

// ---- task 13.2: are these one colour? ----

Statistics statistics(const std::vector<Colour>& colours) {
  // BEGIN SOLUTION
  Statistics result;
  double squares = 0, count = 0;
  for (const Colour& colour : colours) {
    ++count;
    for (std::size_t k = 0; k < 3; ++k) {
      const double before = colour[k] - result.mean[k];
      result.mean[k] += before / count;
      squares += before * (colour[k] - result.mean[k]);
    }
  }
  if (count > 1) result.deviation = std::sqrt(squares / (3 * (count - 1)));
  return result;
  // STUB: return {{NAN, NAN, NAN}, NAN};  // Welford's recurrence, or two passes
  // END SOLUTION
}

// ---- task 13.3: the verdict ----

Verdict judge(const std::vector<std::vector<Pixel>>& pictures, const Threshold& threshold) {
  // BEGIN SOLUTION
  std::vector<Colour> all;
  double deviations = 0;
  int views = 0;
  for (const std::vector<Pixel>& pixels : pictures) {
    std::vector<Colour> seen;
    bool has_object = pixels.empty();
    for (const Pixel& pixel : pixels) {
      has_object = has_object || !pixel.is_background;
      if (!pixel.is_background && !pixel.is_hidden) seen.push_back(pixel.colour);
    }
    if (!has_object) return Verdict::kBackground;
    if (seen.empty()) continue;
    ++views;
    deviations += statistics(seen).deviation;
    all.insert(all.end(), seen.begin(), seen.end());
  }
  if (views == 0) return Verdict::kHidden;
  if (views == 1) return Verdict::kAlone;
  const double most = threshold.k1 * (deviations / views) + threshold.k2;
  return statistics(all).deviation < most ? Verdict::kColoured : Verdict::kInconsistent;
  // STUB: return Verdict::kUnknown;  // background, hidden, alone; then sigma < k1 M + k2
  // END SOLUTION
}

// ---- task 13.4: the pixels of a voxel ----

std::vector<PixelAt> footprint(const Projection& pixel_from_grid, const Voxel& voxel, int width,
                               int height) {
  // BEGIN SOLUTION
  struct Seen {
    double u, v, w;
  };
  const auto project = [&](double x, double y, double z) {
    std::array<double, 3> h{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& row = pixel_from_grid[i];
      h[i] = row[0] * x + row[1] * y + row[2] * z + row[3];
    }
    return Seen{h[0] / h[2], h[1] / h[2], h[2]};
  };
  const Seen middle = project(voxel.x + 0.5, voxel.y + 0.5, voxel.z + 0.5);
  if (!(middle.w > 0)) return {};
  const bool is_inside = middle.u >= 0 && middle.v >= 0 && middle.u < width && middle.v < height;
  const PixelAt own = is_inside ? PixelAt{int(middle.u), int(middle.v)} : PixelAt{-1, -1};
  double left = middle.u, right = middle.u, top = middle.v, bottom = middle.v;
  bool all_before = true;
  for (int corner = 0; corner < 8; ++corner) {
    const Seen p =
        project(voxel.x + (corner & 1), voxel.y + (corner >> 1 & 1), voxel.z + (corner >> 2));
    all_before = all_before && p.w > 0;
    left = std::min(left, p.u);
    right = std::max(right, p.u);
    top = std::min(top, p.v);
    bottom = std::max(bottom, p.v);
  }
  std::vector<PixelAt> pixels;
  bool has_own = !is_inside;
  if (all_before) {
    // Values are clamped before they are converted, because not every double fits into an int.
    const auto first = [](double low, int end) {
      return int(std::clamp(std::ceil(low - 0.5), 0.0, double(end)));
    };
    const auto last = [](double high, int end) {
      return int(std::clamp(std::floor(high - 0.5), -1.0, double(end - 1)));
    };
    for (int row = first(top, height); row <= last(bottom, height); ++row) {
      for (int column = first(left, width); column <= last(right, width); ++column) {
        pixels.push_back({column, row});
        has_own = has_own || (column == own.column && row == own.row);
      }
    }
  }
  if (!has_own) pixels.push_back(own);
  return pixels;
  // STUB: return {{-1, -1}};  // pixels in the rectangle, and that of the voxel's centre
  // END SOLUTION
}

// ---- task 13.5: layer after layer ----

std::vector<Coloured> sweep(std::vector<Picture> pictures, const Grid& grid,
                            const Threshold& threshold) {
  // BEGIN SOLUTION
  // The pixel that shows the voxel's centre; null if the centre is not in the picture.
  const auto pixel_of = [](Picture& picture, const Voxel& v) -> Pixel* {
    std::array<double, 3> h{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& row = picture.pixel_from_grid[i];
      h[i] = row[0] * (v.x + 0.5) + row[1] * (v.y + 0.5) + row[2] * (v.z + 0.5) + row[3];
    }
    const double x = h[0] / h[2], y = h[1] / h[2];
    const bool is_in = h[2] > 0 && x >= 0 && y >= 0 && x < picture.width && y < picture.height;
    if (!is_in) return nullptr;
    return &picture.pixels[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)];
  };
  std::vector<Coloured> coloured;
  const int layers = grid.count[std::size_t(grid.axis)];
  for (int k = 0; k < layers; ++k) {
    std::array<int, 3> low{0, 0, 0}, end = grid.count;
    low[std::size_t(grid.axis)] = grid.away > 0 ? k : layers - 1 - k;
    end[std::size_t(grid.axis)] = low[std::size_t(grid.axis)] + 1;
    const std::size_t before = coloured.size();
    for (int z = low[2]; z < end[2]; ++z) {
      for (int y = low[1]; y < end[1]; ++y) {
        for (int x = low[0]; x < end[0]; ++x) {
          std::vector<std::vector<Pixel>> seen;
          std::vector<Colour> colours;
          for (Picture& picture : pictures) {
            const Pixel* pixel = pixel_of(picture, {x, y, z});
            if (pixel == nullptr) continue;
            seen.push_back({*pixel});
            if (!pixel->is_background && !pixel->is_hidden) colours.push_back(pixel->colour);
          }
          if (judge(seen, threshold) != Verdict::kColoured) continue;
          coloured.push_back({{x, y, z}, statistics(colours).mean});
        }
      }
    }
    for (std::size_t i = before; i < coloured.size(); ++i) {
      for (Picture& picture : pictures) {
        Pixel* pixel = pixel_of(picture, coloured[i].at);
        if (pixel != nullptr) pixel->is_hidden = true;
      }
    }
  }
  return coloured;
  // STUB: return {};  // judge a layer, then hide the pixels of its coloured voxels
  // END SOLUTION
}

}  // namespace lab_13
