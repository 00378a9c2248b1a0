#include "views/glyphs/find_glyphs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <glassbox/base/trig.h>
#include <glassbox/images/srgb.h>

#include "views/glyphs/colors.h"

namespace glassbox::views {

namespace {

// ---- what is not paper ----

// The fraction of a pixel that a glyph covers. Every prototype is nearly dark in one channel, so
// the light in a pixel's darkest channel comes from the paper.
float cover_of(const Light& light, const Light& paper) {
  static const float kDark = decode_srgb(32);
  const float share = (1 - (light / paper).minCoeff()) / (1 - kDark);
  constexpr float kNoise = 0.04f;
  return share < kNoise ? 0 : std::min(share, 1.0f);
}

struct PixelBox {
  int left, top, right, bottom;  // the last column and the last row are included
};

struct Component {
  PixelBox box;
  std::vector<std::size_t> pixels;
};

constexpr std::int32_t kPaper = -1;

// A pixel belongs to a region if more than this fraction of it is covered. It is below 1/2, because
// a pixel in which three colours meet is not dark in any channel, so it seems to be half paper.
constexpr float kCovered = 0.35f;

// The connected regions of covered pixels (pixels that touch at sides or corners), and for each
// pixel the number of its region.
struct Components {
  std::vector<Component> all;
  Image<std::int32_t> labels;
};
Components components_of_picture(const Image<Rgba8>& picture, const Light& paper) {
  Components found;
  found.labels = Image<std::int32_t>(picture.width, picture.height, kPaper);
  std::vector<bool> is_covered;
  is_covered.reserve(picture.pixels.size());
  for (const Rgba8& pixel : picture.pixels)
    is_covered.push_back(cover_of(light_of(pixel), paper) > kCovered);
  std::vector<std::size_t> next;
  for (std::size_t first = 0; first < is_covered.size(); ++first) {
    if (!is_covered[first] || found.labels.pixels[first] != kPaper) continue;
    const auto number = std::int32_t(found.all.size());
    Component component{{picture.width, picture.height, -1, -1}, {}};
    found.labels.pixels[first] = number;
    next.push_back(first);
    while (!next.empty()) {
      const std::size_t at = next.back();
      next.pop_back();
      component.pixels.push_back(at);
      const int x = int(at % std::size_t(picture.width)), y = int(at / std::size_t(picture.width));
      PixelBox& box = component.box;
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x),
             std::max(box.bottom, y)};
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, picture.height - 1); ++j) {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, picture.width - 1); ++i) {
          const std::size_t beside = picture.index(i, j);
          if (!is_covered[beside] || found.labels.pixels[beside] != kPaper) continue;
          found.labels.pixels[beside] = number;
          next.push_back(beside);
        }
      }
    }
    found.all.push_back(std::move(component));
  }
  return found;
}

// ---- the ellipse of a region ----

class Moments2 {
public:
  void add(double x, double y, double weight) {
    sum_ += weight;
    first_ += weight * Vector2d(x, y);
    second_ += weight * Vector2d(x, y) * Vector2d(x, y).transpose();
  }
  double weight() const { return sum_; }
  Vector2d mean() const { return first_ / sum_; }
  Eigen::Matrix2d covariance() const { return second_ / sum_ - mean() * mean().transpose(); }

private:
  double sum_ = 0;
  Vector2d first_ = Vector2d::Zero();
  Eigen::Matrix2d second_ = Eigen::Matrix2d::Zero();
};

// The moments are of coordinates relative to the corner of the region's box, so that their squares
// are small and keep their digits.
Ellipse ellipse_of(const Moments2& moments, const PixelBox& box) {
  Ellipse ellipse;
  ellipse.centre = moments.mean() + Vector2d(box.left, box.top);
  // A pixel is a square and not a point, so the moments contain the square's own variance of 1/12.
  ellipse.moments = moments.covariance() - Eigen::Matrix2d::Identity() / 12;
  ellipse.area = moments.weight();
  // A line of pixels has no width; it gets the width of a pixel.
  constexpr double kLeast = 1.0 / 12;
  if (ellipse.moments.determinant() < kLeast * kLeast || ellipse.moments.trace() <= 0)
    ellipse.moments += kLeast * Eigen::Matrix2d::Identity();
  return ellipse;
}

// Measures one region and applies all rules to it.
class Reader {
public:
  Reader(const Image<Rgba8>& picture, const Components& components, std::int32_t number,
         const Light& paper, const FindSettings& settings)
      : picture_(picture),
        components_(components),
        number_(number),
        paper_(paper),
        settings_(settings) {}

  GlyphRegion run(const std::array<bool, kGlyphs>& is_on_wall) {
    const Component& component = components_.all[std::size_t(number_)];
    box_ = component.box;
    Moments2 moments;
    for (const std::size_t at : component.pixels)
      moments.add(double(int(at % std::size_t(picture_.width)) - box_.left) + 0.5,
                  double(int(at / std::size_t(picture_.width)) - box_.top) + 0.5, 1);
    GlyphRegion region;
    region.ellipse = ellipse_of(moments, box_);
    const bool is_whole = box_.left > 0 && box_.top > 0 && box_.right + 1 < picture_.width &&
                          box_.bottom + 1 < picture_.height;
    const auto breaks = [&](GlyphRule rule, bool is_kept) {
      if (is_kept || !settings_.is_enabled(rule) || region.broken) return;
      region.broken = rule;
    };
    breaks(GlyphRule::kWhole, is_whole);
    breaks(GlyphRule::kSize, region.ellipse.shorter_diameter() >= 0.75 * settings_.least_diameter);
    // A thin ring has few pixels compared with the filled ellipse of the same moments, whose area
    // is 4 pi sqrt(det(moments)), and the rest of that ellipse has no prototype's colour.
    const double area = 4 * kPi * std::sqrt(region.ellipse.moments.determinant());
    breaks(GlyphRule::kPrototypes,
           double(component.pixels.size()) >= settings_.least_prototypes * area);
    // A region that cannot be a glyph may be as large as the picture, so stop before the expensive
    // steps.
    if (region.broken) return region;
    const Light paper = paper_around(region.ellipse);
    region.ellipse = refined(region.ellipse, paper);
    breaks(GlyphRule::kSize, region.ellipse.shorter_diameter() >= settings_.least_diameter);
    classify(region, settings_.balances ? paper : Light(1, 1, 1));
    breaks(GlyphRule::kPrototypes,
           region.classified >= settings_.least_prototypes && region.identity >= 0);
    breaks(GlyphRule::kOthers, region.others <= settings_.most_others);
    bool has_shares = true;
    for (std::size_t i = 0; i < 3; ++i) {
      has_shares = has_shares && region.shares[i] >= settings_.least_shares[i] &&
                   region.shares[i] <= settings_.most_shares[i];
    }
    breaks(GlyphRule::kAreas, has_shares);
    breaks(GlyphRule::kCentroids,
           region.centroid_distance <=
               settings_.max_centroid_distance * region.ellipse.diameter() + 0.5);
    breaks(GlyphRule::kSpread, is_spread_);
    breaks(GlyphRule::kRanks, has_ranks_);
    breaks(GlyphRule::kSheet, region.identity >= 0 && is_on_wall[std::size_t(region.identity)]);
    // Without an identity a region is no glyph, even if the rule kPrototypes is switched off.
    if (!region.broken && region.identity < 0) region.broken = GlyphRule::kPrototypes;
    return region;
  }

private:
  // Calls `see` for the pixels within `radii` radii of the ellipse and inside the picture.
  template <class See>
  void for_each_near(const Ellipse& ellipse, double radii, See see) const {
    const double reach_x = 2 * radii * std::sqrt(ellipse.moments(0, 0)),
                 reach_y = 2 * radii * std::sqrt(ellipse.moments(1, 1));
    const auto clamped = [](double value, int most) {
      return int(std::clamp(value, 0.0, double(most)));
    };
    const int left = clamped(ellipse.centre.x() - reach_x, picture_.width - 1),
              right = clamped(ellipse.centre.x() + reach_x, picture_.width - 1),
              top = clamped(ellipse.centre.y() - reach_y, picture_.height - 1),
              bottom = clamped(ellipse.centre.y() + reach_y, picture_.height - 1);
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        const double radius = ellipse.radius_of({x + 0.5, y + 0.5});
        if (radius < radii) see(x, y, radius);
      }
    }
  }

  Light paper_around(const Ellipse& ellipse) const {
    constexpr double kFrom = 1.15, kTo = 1.45;
    std::array<std::vector<float>, 3> channels;
    for_each_near(ellipse, kTo, [&](int x, int y, double radius) {
      if (radius < kFrom || components_.labels.at(x, y) != kPaper) return;
      const Light light = light_of(picture_.at(x, y));
      for (std::size_t c = 0; c < 3; ++c) channels[c].push_back(light[Eigen::Index(c)]);
    });
    constexpr std::size_t kEnough = 8;
    if (channels[0].size() < kEnough) return paper_;
    Light paper;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto middle = channels[c].begin() + std::ptrdiff_t(channels[c].size() / 2);
      std::nth_element(channels[c].begin(), middle, channels[c].end());
      paper[Eigen::Index(c)] = std::max(*middle, 1e-3f);
    }
    return paper;
  }

  // The ellipse computed a second time: pixels well inside the first ellipse have the weight 1, and
  // pixels near its border the fraction that is covered.
  Ellipse refined(const Ellipse& first, const Light& paper) const {
    constexpr double kInside = 0.75, kReach = 1.45;
    Moments2 moments;
    for_each_near(first, kReach, [&](int x, int y, double radius) {
      const std::int32_t owner = components_.labels.at(x, y);
      if (owner != number_ && owner != kPaper) return;
      const float cover = radius < kInside ? 1 : cover_of(light_of(picture_.at(x, y)), paper);
      moments.add(x - box_.left + 0.5, y - box_.top + 0.5, double(cover));
    });
    return moments.weight() > 0 ? ellipse_of(moments, box_) : first;
  }

  void classify(GlyphRegion& region, const Light& paper) {
    // Maps the picture to the glyph's plane, where the glyph is a circle of radius 1.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(region.ellipse.moments);
    const Eigen::Matrix2d circle_from_pixels = axes.operatorInverseSqrt() / 2;
    std::array<Moments2, kPrototypes> classes;
    double all = 0, classified = 0;
    for_each_near(region.ellipse, 1, [&](int x, int y, double) {
      ++all;
      const Eigen::Array3f codes = codes_of(light_of(picture_.at(x, y)) / paper);
      const int prototype = prototype_of(codes, settings_.threshold);
      if (prototype == kNoPrototype) return;
      ++classified;
      const Vector2d at = circle_from_pixels * (Vector2d(x + 0.5, y + 0.5) - region.ellipse.centre);
      classes[std::size_t(prototype)].add(at.x(), at.y(), 1);
    });
    std::array<int, kPrototypes> order{0, 1, 2, 3, 4, 5};
    const auto weight = [&](int i) { return classes[std::size_t(i)].weight(); };
    std::ranges::stable_sort(order, std::greater(), weight);
    const double three = weight(order[0]) + weight(order[1]) + weight(order[2]);
    region.classified = all > 0 ? three / all : 0;
    region.others = classified > 0 ? 1 - three / classified : 0;
    if (weight(order[2]) == 0) return;
    const std::array<int, 3> by_weight{order[2], order[1], order[0]};  // ascending
    std::array<int, 3> by_spread = by_weight;
    const auto spread = [&](int i) {
      return std::sqrt(classes[std::size_t(i)].covariance().trace());
    };
    std::ranges::stable_sort(by_spread, std::less(), spread);
    for (std::size_t i = 0; i < 3; ++i) {
      region.shares[i] = weight(by_weight[i]) / three;
      for (std::size_t k = 0; k < i; ++k) {
        const Vector2d between =
            classes[std::size_t(by_weight[i])].mean() - classes[std::size_t(by_weight[k])].mean();
        region.centroid_distance =
            std::max(region.centroid_distance, between.norm() * region.ellipse.diameter() / 2);
      }
    }
    has_ranks_ = weight(by_spread[1]) >= settings_.rank_ratio * weight(by_spread[0]) &&
                 weight(by_spread[2]) >= settings_.rank_ratio * weight(by_spread[1]);
    is_spread_ = spread(by_spread[1]) >= settings_.spread_ratio * spread(by_spread[0]) &&
                 spread(by_spread[2]) >= settings_.spread_ratio * spread(by_spread[1]);
    region.code = by_spread;
    region.identity = identity_of(region.code).value_or(-1);
  }

  const Image<Rgba8>& picture_;
  const Components& components_;
  std::int32_t number_;
  Light paper_;
  const FindSettings& settings_;
  PixelBox box_{};
  bool has_ranks_ = false, is_spread_ = false;
};

}  // namespace

std::string_view name_of(GlyphRule rule) {
  switch (rule) {
    case GlyphRule::kWhole:
      return "whole";
    case GlyphRule::kSize:
      return "size";
    case GlyphRule::kPrototypes:
      return "prototypes";
    case GlyphRule::kOthers:
      return "others";
    case GlyphRule::kAreas:
      return "areas";
    case GlyphRule::kCentroids:
      return "centroids";
    case GlyphRule::kSpread:
      return "spread";
    case GlyphRule::kRanks:
      return "ranks";
    case GlyphRule::kSheet:
      return "sheet";
  }
  return "";
}

double Ellipse::diameter() const {
  return 4 * std::sqrt(std::sqrt(moments.determinant()));
}

double Ellipse::shorter_diameter() const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(moments, Eigen::EigenvaluesOnly);
  return 4 * std::sqrt(std::max(0.0, axes.eigenvalues()[0]));
}

// On the border of a filled ellipse, the distance from the centre in units of the standard
// deviation (Mahalanobis distance) is 2.
double Ellipse::radius_of(const Vector2d& pixel) const {
  const Vector2d off = pixel - centre;
  const double a = moments(0, 0), b = moments(0, 1), d = moments(1, 1);
  const double squared =
      (d * off.x() * off.x() - 2 * b * off.x() * off.y() + a * off.y() * off.y()) / (a * d - b * b);
  return std::sqrt(std::max(0.0, squared)) / 2;
}

int FoundGlyphs::glyphs() const {
  return int(
      std::ranges::count_if(regions, [](const GlyphRegion& region) { return !region.broken; }));
}

FoundGlyphs find_glyphs(const Image<Rgba8>& picture, const FindSettings& settings,
                        const std::array<bool, kGlyphs>& is_on_wall) {
  FoundGlyphs found;
  if (picture.pixels.empty()) return found;
  const Light paper = paper_of(picture);
  const Components components = components_of_picture(picture, paper);
  constexpr std::size_t kMinPixels = 9;
  for (std::size_t i = 0; i < components.all.size(); ++i) {
    if (components.all[i].pixels.size() < kMinPixels) continue;
    found.regions.push_back(
        Reader(picture, components, std::int32_t(i), paper, settings).run(is_on_wall));
  }
  return found;
}

}  // namespace glassbox::views
