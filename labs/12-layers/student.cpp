// Lab 12: your part. student.h says what each function must do, handout.md why.
#include "student.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/matrix.hpp>

namespace lab_12 {

// ---- task 12.1: lists of samples, packed ----

Layers pack(int width, int height, const std::vector<Sample>& samples, double epsilon) {
  // BEGIN SOLUTION
  std::vector<std::vector<Sample>> pixels(std::size_t(width) * std::size_t(height));
  for (const Sample& s : samples) {
    const int row = height - 1 - s.y;
    pixels[std::size_t(row) * std::size_t(width) + std::size_t(s.x)].push_back(s);
  }
  Layers layers{width, height, {0}, {}, {}};
  for (std::vector<Sample>& here : pixels) {
    std::stable_sort(here.begin(), here.end(),
                     [](const Sample& a, const Sample& b) { return a.depth > b.depth; });
    std::vector<Sample> kept;
    for (const Sample& s : here) {
      const bool stays = kept.empty() || double(kept.back().depth) - double(s.depth) >
                                             epsilon * double(kept.back().depth);
      if (stays) kept.push_back(s);
    }
    std::reverse(kept.begin(), kept.end());
    for (const Sample& s : kept) {
      layers.depth.push_back(s.depth);
      layers.colour.push_back(s.colour);
    }
    layers.first.push_back(int(layers.depth.size()));
  }
  return layers;
  // STUB: return {};  // bottom to top, left to right, back to front
  // END SOLUTION
}

// ---- task 12.2: from one picture to the other ----

Transform<Screen, Screen> warp_matrix(const Transform<Screen, World>& first,
                                      const Transform<Screen, World>& second) {
  // BEGIN SOLUTION
  const Transform<World, Screen> world_from_first(glm::inverse(first.columns));
  return second * world_from_first;
  // STUB: return Transform<Screen, Screen>(glm::dmat4(NAN));
  // END SOLUTION
}

// ---- task 12.3: a row, step by step ----

std::vector<Warped> warp_row(const Transform<Screen, Screen>& warp, int y,
                             const std::vector<std::vector<float>>& depths) {
  // BEGIN SOLUTION
  constexpr std::size_t kAnchor = 64;  // the sums start anew after so many px
  const auto column = [&](int j) {
    return Warped{float(warp.at(0, j)), float(warp.at(1, j)), float(warp.at(2, j)),
                  float(warp.at(3, j))};
  };
  const Warped step = column(0), depth = column(2);
  std::vector<Warped> all;
  Warped start;
  for (std::size_t x = 0; x < depths.size(); ++x) {
    if (x % kAnchor == 0) {
      const auto anew = [&](int i) {
        return float(warp.at(i, 0) * (double(x) + 0.5) + warp.at(i, 1) * (y + 0.5) + warp.at(i, 3));
      };
      start = {anew(0), anew(1), anew(2), anew(3)};
    }
    for (const float z : depths[x])
      all.push_back({start.x + z * depth.x, start.y + z * depth.y, start.z + z * depth.z,
                     start.w + z * depth.w});
    start = {start.x + step.x, start.y + step.y, start.z + step.z, start.w + step.w};
  }
  return all;
  // STUB: return {};  // a position for each sample
  // END SOLUTION
}

// ---- task 12.4: how large a sample is ----

Splat splat_size(double focal_ratio, double w, double cosine_first, double cosine_second) {
  // BEGIN SOLUTION
  constexpr double kMost = 64;
  if (cosine_first == 0) return {kMost, true};
  const double side = focal_ratio / w * std::sqrt(cosine_second / cosine_first);
  return {std::clamp(side, 1.0, kMost), side > kMost};
  // STUB: return {NAN, false};  // from focal lengths, distances and tilt; 1 to 64 px
  // END SOLUTION
}

// ---- task 12.5: samples that are visited later are nearer ----

std::vector<int> visiting_order(double epipole, double w, int count) {
  // BEGIN SOLUTION
  std::vector<int> growing, falling;
  for (int i = 0; i < count; ++i) {
    // One rounding, which keeps the sign: with two, an epipole beside a centre could seem on it.
    const bool grows = std::fma(-(i + 0.5), w, epipole) > 0;
    (grows ? growing : falling).push_back(i);
  }
  growing.insert(growing.end(), falling.rbegin(), falling.rend());
  return growing;
  // STUB: return {};  // towards the epipole, or away from it
  // END SOLUTION
}

// ---- task 12.6: squares in a picture ----

Image<Rgba8> draw(const Canvas& canvas) {
  // BEGIN SOLUTION
  Image<Rgba8> picture(canvas.width, canvas.height, canvas.background);
  Image<double> nearest(canvas.width, canvas.height, -INFINITY);
  for (const Placed& sample : canvas.samples) {
    const double w = sample.at.w;
    if (!(w > 0)) continue;
    const double x = sample.at.x / w, y = sample.at.y / w, z = sample.at.z / w;
    if (z > 1) continue;
    const double half = sample.side / 2;
    // Values are clamped before they are converted, because not every double fits into an int.
    const auto bounded = [](double v, int end) { return int(std::clamp(v, 0.0, double(end))); };
    const int left = bounded(std::floor(x - half + 0.5), canvas.width);
    const int right = bounded(std::floor(x + half + 0.5), canvas.width);
    const int top = bounded(std::floor(y - half + 0.5), canvas.height);
    const int bottom = bounded(std::floor(y + half + 0.5), canvas.height);
    for (int j = top; j < bottom; ++j) {
      for (int i = left; i < right; ++i) {
        const bool hidden = canvas.hiding == Hiding::kNearest && z <= nearest.at(i, j);
        if (hidden) continue;
        nearest.at(i, j) = z;
        picture.at(i, j) = sample.colour;
      }
    }
  }
  return picture;
  // STUB: return {};  // canvas.width x canvas.height pixels
  // END SOLUTION
}

}  // namespace lab_12
