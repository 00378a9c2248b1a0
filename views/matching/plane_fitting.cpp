#include "views/matching/plane_fitting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "views/matching/winner.h"

namespace glassbox::views {

namespace {

using Eigen::Matrix3f;
using Eigen::Vector3f;

constexpr int kRadius = 5;  // px
// px: a pixel of the window is left out if its disparity is further than this from the plane.
constexpr float kNearPlane = 1.5f;
// The number of pixels in a window that are needed to fit a plane (three numbers) and a constant
// difference of grey.
constexpr int kFewest = 16;
// The difference from the centre in a channel, in sRGB codes (0 .. 255), at which a pixel has half
// the weight.
constexpr int kHalfWeightDifference = 10;
constexpr int kRefits = 2;  // steps of a fit that are tried

// Keeps a fit from changing the plane where there is no contrast. The terms added to the least
// squares compare noise of two codes of grey with a change of half a pixel in c, and of a quarter
// in a and b.
constexpr float kNoise = 2, kOffPlace = 0.5f, kOffSlope = 0.25f;

// c is the disparity at the pixel itself, a is its change for one pixel to the right, and b is its
// change for one pixel down.
struct Plane {
  float c = 0, a = 0, b = 0;
  float at(int dx, int dy) const { return c + a * float(dx) + b * float(dy); }
};

struct SupportPixel {
  int dx, dy;
  float weight;
};
struct SupportWindow {
  std::array<SupportPixel, (2 * kRadius + 1) * (2 * kRadius + 1)> pixels;
  int count = 0;
};

struct Fit {
  // The mean square of the remaining difference of grey, in codes squared.
  float cost = std::numeric_limits<float>::infinity();
  Vector3f step = Vector3f::Zero();  // change of c, a and b that lowers the cost
};

class Fitter {
public:
  Fitter(const ColorPlanes& left, const ColorPlanes& right,
         const Image<InvalidReason>& invalid_reasons, const Image<float>& disparity)
      : left_(left), right_(right), invalid_reasons_(invalid_reasons), found_(disparity) {}

  // The plane to begin with: its slopes are those of the disparities around the pixel.
  Plane first(int x, int y) const {
    Plane plane{found_.at(x, y), 0, 0};
    float xx = 0, yy = 0, xz = 0, yz = 0;
    for_window(x, y, [&](int dx, int dy, std::size_t at) {
      const float rise = found_.pixels[at] - plane.c;
      // Leaves out pixels that are probably on another surface: a slope is at most one px of
      // disparity per pixel. 0.5 is added for rounding.
      if (std::abs(rise) > float(std::abs(dx) + std::abs(dy)) + 0.5f) return;
      xx += float(dx * dx), yy += float(dy * dy);
      xz += float(dx) * rise, yz += float(dy) * rise;
    });
    if (xx > 0) plane.a = xz / xx;
    if (yy > 0) plane.b = yz / yy;
    return plane;
  }

  SupportWindow support(int x, int y, const Plane& plane) const {
    SupportWindow support;
    const std::size_t own = found_.index(x, y);
    for_window(x, y, [&](int dx, int dy, std::size_t at) {
      if (std::abs(found_.pixels[at] - plane.at(dx, dy)) > kNearPlane) return;
      const float unlike = float(channel_difference(left_, own, at)) / float(kHalfWeightDifference);
      support.pixels[std::size_t(support.count++)] = {dx, dy, 1 / (1 + unlike * unlike)};
    });
    return support;
  }

  // The remaining difference of grey, and the step (dc, da, db) that reduces it. With the
  // difference r of a left pixel's grey from the right picture's and the derivative I' of the right
  // grey along the row, the step makes r + I' (dc + da dx + db dy) as nearly constant as possible.
  Fit fit(int x, int y, const Plane& plane, const SupportWindow& support) const {
    float weights = 0, sum = 0, squares = 0;
    Vector3f slopes = Vector3f::Zero(), products = Vector3f::Zero();
    Matrix3f system = Matrix3f::Zero();
    int counted = 0;
    for (int i = 0; i < support.count; ++i) {
      const auto& [dx, dy, weight] = support.pixels[std::size_t(i)];
      const float place = float(x + dx) - plane.at(dx, dy);
      if (!(place >= 0 && place <= float(right_.width - 1))) continue;
      const auto [grey, slope] = sample(y + dy, place);
      const float rest = float(left_.grey[found_.index(x + dx, y + dy)]) - grey;
      const Vector3f change = slope * Vector3f(1, float(dx), float(dy));
      weights += weight, sum += weight * rest, squares += weight * rest * rest;
      slopes += weight * change, products += weight * rest * change;
      system += weight * change * change.transpose();
      ++counted;
    }
    if (counted < kFewest) return {};
    const float mean = sum / weights;
    system -= slopes * slopes.transpose() / weights;
    system.diagonal() += kNoise * kNoise *
                         Vector3f(1 / (kOffPlace * kOffPlace), 1 / (kOffSlope * kOffSlope),
                                  1 / (kOffSlope * kOffSlope));
    return {squares / weights - mean * mean, system.ldlt().solve(mean * slopes - products)};
  }

private:
  template <class One>
  void for_window(int x, int y, const One& one) const {
    const int left = std::max(-kRadius, -x), right = std::min(kRadius, found_.width - 1 - x);
    const int top = std::max(-kRadius, -y), bottom = std::min(kRadius, found_.height - 1 - y);
    for (int dy = top; dy <= bottom; ++dy) {
      for (int dx = left; dx <= right; ++dx) {
        const std::size_t at = found_.index(x + dx, y + dy);
        if (invalid_reasons_.pixels[at] == InvalidReason::kNone) one(dx, dy, at);
      }
    }
  }

  // The right picture's grey at a place between two pixels, and its derivative along the row, from
  // Catmull and Rom's cubic through four pixels.
  std::pair<float, float> sample(int y, float place) const {
    const std::uint8_t* row = right_.grey.data() + std::size_t(y) * std::size_t(right_.width);
    const int from = int(place), last = right_.width - 1;
    const float t = place - float(from);
    const float before = row[std::max(from - 1, 0)], near = row[from],
                far = row[std::min(from + 1, last)], behind = row[std::min(from + 2, last)];
    const float k1 = 0.5f * (far - before), k2 = before - 2.5f * near + 2 * far - 0.5f * behind,
                k3 = 1.5f * (near - far) + 0.5f * (behind - before);
    return {near + t * (k1 + t * (k2 + t * k3)), k1 + t * (2 * k2 + 3 * t * k3)};
  }

  const ColorPlanes &left_, &right_;
  const Image<InvalidReason>& invalid_reasons_;
  const Image<float>& found_;
};

constexpr std::array<std::pair<int, int>, 4> kAround{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

// The best of the pixel's own plane, its four neighbours' planes, and the planes that fits make
// from the best so far.
Plane best_nearby_plane(const Fitter& fitter, const Image<Plane>& planes,
                        const Image<InvalidReason>& invalid_reasons, float found, int x, int y) {
  Plane best = planes.at(x, y);
  const SupportWindow support = fitter.support(x, y, best);
  Fit fit = fitter.fit(x, y, best, support);
  const auto try_plane = [&](const Plane& plane) {
    if (!(std::abs(plane.c - found) <= kPlaneReach)) return;
    const Fit other = fitter.fit(x, y, plane, support);
    if (other.cost < fit.cost) best = plane, fit = other;
  };
  for (const auto& [dx, dy] : kAround) {
    const int column = x + dx, row = y + dy;
    if (column < 0 || row < 0 || column >= planes.width || row >= planes.height) continue;
    if (invalid_reasons.at(column, row) != InvalidReason::kNone) continue;
    const Plane& beside = planes.at(column, row);
    try_plane({beside.at(-dx, -dy), beside.a, beside.b});
  }
  for (int i = 0; i < kRefits; ++i) {
    try_plane({best.c + fit.step.x(), best.a + fit.step.y(), best.b + fit.step.z()});
  }
  return best;
}

}  // namespace

void fit_planes(const ColorPlanes& left, const ColorPlanes& right,
                const Image<InvalidReason>& invalid_reasons, int rounds, Image<float>& disparity) {
  const Image<float> found = disparity;
  const Fitter fitter(left, right, invalid_reasons, found);
  Image<Plane> planes(disparity.width, disparity.height);
  const auto for_pixels = [&](const auto& one) {
    tbb::parallel_for(0, disparity.height, [&](int y) {
      for (int x = 0; x < disparity.width; ++x) {
        if (invalid_reasons.at(x, y) == InvalidReason::kNone) one(x, y);
      }
    });
  };
  for_pixels([&](int x, int y) { planes.at(x, y) = fitter.first(x, y); });
  for (int round = 0; round < rounds; ++round) {
    const Image<Plane> before = planes;
    for_pixels([&](int x, int y) {
      planes.at(x, y) = best_nearby_plane(fitter, before, invalid_reasons, found.at(x, y), x, y);
    });
  }
  for_pixels([&](int x, int y) { disparity.at(x, y) = planes.at(x, y).c; });
}

}  // namespace glassbox::views
