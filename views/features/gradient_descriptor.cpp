#include "views/features/gradient_descriptor.h"

#include <algorithm>
#include <cmath>

#include <glassbox/base/elementary.h>
#include <glassbox/base/trig.h>

namespace glassbox::views {

namespace {

constexpr double kTurn = 2 * kPi;

struct Gradient {
  double length = 0, angle = 0;  // the angle in radians, 0 to 2 pi
};

Gradient gradient_at(const Image<float>& grey, int x, int y) {
  const double gx = double(grey.at(x + 1, y)) - double(grey.at(x - 1, y));
  const double gy = double(grey.at(x, y + 1)) - double(grey.at(x, y - 1));
  const double angle = arctan2(gy, gx);
  return {std::sqrt(gx * gx + gy * gy), angle < 0 ? angle + kTurn : angle};
}

// Calls one(x, y, dx, dy) for the pixels inside the picture whose centres (dx, dy) are within
// `radius` px of a position.
template <class One>
void for_pixels_around(const Image<float>& grey, double x, double y, double radius,
                       const One& one) {
  const int left = std::max(1, int(x - radius)), top = std::max(1, int(y - radius));
  const int right = std::min(grey.width - 2, int(x + radius));
  const int bottom = std::min(grey.height - 2, int(y + radius));
  for (int row = top; row <= bottom; ++row) {
    for (int column = left; column <= right; ++column) {
      const double dx = column + 0.5 - x, dy = row + 0.5 - y;
      if (dx * dx + dy * dy <= radius * radius) one(column, row, dx, dy);
    }
  }
}

// ---- the direction ----

constexpr std::size_t kAngleBins = 36;
using AngleHistogram = std::array<double, kAngleBins>;

AngleHistogram angle_histogram(const Image<float>& grey, double x, double y) {
  constexpr double kRadius = 8, kSigma = 2.5;  // px
  AngleHistogram histogram{};
  for_pixels_around(grey, x, y, kRadius, [&](int column, int row, double dx, double dy) {
    const Gradient gradient = gradient_at(grey, column, row);
    const double weight = exponential(-(dx * dx + dy * dy) / (2 * kSigma * kSigma));
    const auto bin = std::size_t(gradient.angle * (double(kAngleBins) / kTurn)) % kAngleBins;
    histogram[bin] += weight * gradient.length;
  });
  return histogram;
}

// Each bin's mean with its two neighbours, on a circle.
AngleHistogram averaged(const AngleHistogram& histogram) {
  AngleHistogram result{};
  for (std::size_t i = 0; i < kAngleBins; ++i) {
    const double before = histogram[(i + kAngleBins - 1) % kAngleBins];
    const double after = histogram[(i + 1) % kAngleBins];
    result[i] = (before + histogram[i] + after) / 3;
  }
  return result;
}

struct Peak {
  double height = 0, angle = 0;
};

std::vector<Peak> peaks_of(const AngleHistogram& histogram) {
  std::vector<Peak> peaks;
  for (std::size_t i = 0; i < kAngleBins; ++i) {
    const double before = histogram[(i + kAngleBins - 1) % kAngleBins], own = histogram[i];
    const double after = histogram[(i + 1) % kAngleBins];
    if (!(own > before && own >= after)) continue;
    // The parabola through three values at -1, 0 and 1 has its peak here.
    const double beside = (before - after) / (2 * (before - 2 * own + after));
    peaks.push_back({own, (double(i) + 0.5 + beside) * (kTurn / double(kAngleBins))});
  }
  return peaks;
}

// ---- the histograms of the cells ----

// A position in the cells: the centre of the first cell is 0. Directions are in bins.
struct CellPosition {
  double column, row, direction;
};

using Bins = std::array<double, std::size_t(kCells* kCells* kDirections)>;

// Divides a value between the two bins nearest to the position in each of three coordinates.
void add_shares(const CellPosition& at, double value, Bins& bins) {
  const double column = std::floor(at.column), row = std::floor(at.row);
  const double direction = std::floor(at.direction);
  const double u = at.column - column, v = at.row - row, t = at.direction - direction;
  for (int i = 0; i < 8; ++i) {
    const int x = int(column) + (i & 1), y = int(row) + (i >> 1 & 1);
    if (x < 0 || x >= kCells || y < 0 || y >= kCells) continue;
    const int d = (int(direction) + (i >> 2)) % kDirections;
    const double share =
        ((i & 1) != 0 ? u : 1 - u) * ((i & 2) != 0 ? v : 1 - v) * ((i & 4) != 0 ? t : 1 - t);
    bins[std::size_t((y * kCells + x) * kDirections + d)] += share * value;
  }
}

Bins cell_histograms(const Image<float>& grey, double x, double y, double angle) {
  constexpr double kHalf = kCells / 2.0;  // from the feature to the cells' edge, in cells
  constexpr double kSigma = kHalf;        // cells
  const double radius = kCellSide * (kHalf + 0.5) * std::sqrt(2.0);
  const SinCos turn = sin_cos(angle);
  Bins bins{};
  for_pixels_around(grey, x, y, radius, [&](int column, int row, double dx, double dy) {
    const double along = (turn.cos * dx + turn.sin * dy) / kCellSide;
    const double across = (turn.cos * dy - turn.sin * dx) / kCellSide;
    if (std::abs(along) >= kHalf + 0.5 || std::abs(across) >= kHalf + 0.5) return;
    const Gradient gradient = gradient_at(grey, column, row);
    double relative = gradient.angle - angle;
    if (relative < 0) relative += kTurn;
    if (relative < 0) relative += kTurn;
    if (relative >= kTurn) relative -= kTurn;
    const double weight = exponential(-(along * along + across * across) / (2 * kSigma * kSigma));
    add_shares({along + kHalf - 0.5, across + kHalf - 0.5, relative * (kDirections / kTurn)},
               weight * gradient.length, bins);
  });
  return bins;
}

// Scales to length 1; zeros remain zeros.
void normalise(Bins& bins) {
  double squares = 0;
  for (const double value : bins) squares += value * value;
  if (!(squares > 0)) return;
  const double length = std::sqrt(squares);
  for (double& value : bins) value /= length;
}

}  // namespace

std::vector<double> gradient_angles(const Image<float>& grey, double x, double y) {
  std::vector<Peak> peaks = peaks_of(averaged(angle_histogram(grey, x, y)));
  if (peaks.empty()) return {0};
  std::ranges::stable_sort(peaks, [](const Peak& a, const Peak& b) { return a.height > b.height; });
  std::vector<double> angles{peaks[0].angle};
  if (peaks.size() > 1 && peaks[1].height >= kSecondPeak * peaks[0].height) {
    angles.push_back(peaks[1].angle);
  }
  return angles;
}

GradientDescriptor gradient_descriptor(const Image<float>& grey, double x, double y, double angle) {
  constexpr double kLargest = 0.2, kLength = 512;
  Bins bins = cell_histograms(grey, x, y, angle);
  normalise(bins);
  for (double& value : bins) value = std::min(value, kLargest);
  normalise(bins);
  GradientDescriptor descriptor;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    descriptor[i] = std::uint8_t(std::min(kLength * bins[i] + 0.5, 255.0));
  }
  return descriptor;
}

double distance(const GradientDescriptor& a, const GradientDescriptor& b) {
  int squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int difference = int(a[i]) - int(b[i]);
    squares += difference * difference;
  }
  return std::sqrt(double(squares));
}

}  // namespace glassbox::views
