// The formulas of the stages in arithmetic of 320 bits, and texture samples by exact weights from
// exact means.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <vector>

#include <glassbox/base/numbers.h>
#include <glassbox/raster/shading.h>
#include <glassbox/raster/stages.h>
#include <glassbox/raster/texture.h>

namespace glassbox::in_full {

using Big = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<320, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

template <class F>
concept Number = std::same_as<F, Big>;

using boost::multiprecision::abs;
using boost::multiprecision::floor;
using boost::multiprecision::sqrt;

inline Big select(bool condition, const Big& yes, const Big& no) {
  return condition ? yes : no;
}
inline bool none(bool condition) {
  return !condition;
}

#include <glassbox/base/formulas/common.h>
#include <glassbox/raster/formulas/blend.h>
#include <glassbox/raster/formulas/interpolate.h>
#include <glassbox/raster/formulas/lighting.h>
#include <glassbox/raster/formulas/texture.h>

// ---- textures ----

// The sRGB transfer function of IEC 61966-2-1.
inline double encoded(Transfer transfer, double light) {
  const double x = std::clamp(light, 0.0, 1.0);
  if (transfer == Transfer::kNone) return x;
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}
inline double decoded(Transfer transfer, double stored) {
  if (transfer == Transfer::kNone) return stored;
  return stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4);
}

// Light and alpha in double, correct to 2^-40.
using Light = std::array<double, 4>;

struct Level {
  int width = 0, height = 0;
  std::vector<Light> texels;
  const Light& at(int x, int y) const { return texels[std::size_t(y * width + x)]; }
};

inline Level level_of(const Image<Rgba8>& image, Transfer transfer) {
  Level level{image.width, image.height, {}};
  for (const Rgba8& c : image.pixels) {
    level.texels.push_back({decoded(transfer, c.r / 255.0), decoded(transfer, c.g / 255.0),
                            decoded(transfer, c.b / 255.0), c.a / 255.0});
  }
  return level;
}

// The part of texel `k` of the shorter row, as a share of it, that texel `i` of the longer row
// covers.
inline double covered(int k, int short_side, int i, int long_side) {
  const double low = double(k) * long_side / short_side,
               high = double(k + 1) * long_side / short_side;
  return std::max(0.0, std::min(high, i + 1.0) - std::max(low, double(i))) * short_side / long_side;
}

inline Level half_of(const Level& level) {
  Level half{std::max(1, level.width / 2), std::max(1, level.height / 2), {}};
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      Light sum{};
      for (int j = 0; j < level.height; ++j) {
        const double down = covered(y, half.height, j, level.height);
        if (down == 0) continue;
        for (int i = 0; i < level.width; ++i) {
          const double weight = down * covered(x, half.width, i, level.width);
          for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * level.at(i, j)[c];
        }
      }
      half.texels.push_back(sum);
    }
  }
  return half;
}

inline std::vector<Level> levels_of(const Image<Rgba8>& image, Transfer transfer) {
  std::vector<Level> levels{level_of(image, transfer)};
  while (levels.back().width > 1 || levels.back().height > 1) {
    levels.push_back(half_of(levels.back()));
  }
  return levels;
}

inline int wrapped(Wrap wrap, double i, int size) {
  if (wrap == Wrap::kClampToEdge) return int(std::clamp(i, 0.0, double(size - 1)));
  const double period = wrap == Wrap::kRepeat ? size : 2.0 * size;
  const double j = i - period * std::floor(i / period);
  return int(j < size ? j : 2.0 * size - 1 - j);
}

inline Light mixed(const Light& a, const Light& b, double t) {
  Light c;
  for (std::size_t i = 0; i < 4; ++i) c[i] = a[i] + t * (b[i] - a[i]);
  return c;
}

inline Light sample_level(const Level& level, const Sampler& sampler, Filter filter, double u,
                          double v) {
  if (sampler.wrap_u == Wrap::kClampToEdge) u = std::clamp(u, 0.0, 1.0);
  if (sampler.wrap_v == Wrap::kClampToEdge) v = std::clamp(v, 0.0, 1.0);
  const auto texel = [&](double x, double y) -> const Light& {
    return level.at(wrapped(sampler.wrap_u, x, level.width),
                    wrapped(sampler.wrap_v, y, level.height));
  };
  if (filter == Filter::kNearest) {
    return texel(std::floor(u * level.width), std::floor(v * level.height));
  }
  const double x = u * level.width - 0.5, y = v * level.height - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  return mixed(mixed(texel(left, top), texel(left + 1, top), x - left),
               mixed(texel(left, top + 1), texel(left + 1, top + 1), x - left), y - top);
}

inline Light sample(const std::vector<Level>& levels, const Sampler& sampler, double u, double v,
                    double level_of_detail) {
  if (!(level_of_detail > 0)) return sample_level(levels[0], sampler, sampler.magnify, u, v);
  if (sampler.mip == MipFilter::kNone)
    return sample_level(levels[0], sampler, sampler.minify, u, v);
  const double position = std::min(level_of_detail, double(levels.size() - 1));
  if (sampler.mip == MipFilter::kNearest) {
    return sample_level(levels[std::size_t(position + 0.5)], sampler, sampler.minify, u, v);
  }
  const std::size_t finer = std::size_t(position);
  const Light fine = sample_level(levels[finer], sampler, sampler.minify, u, v);
  if (position == double(finer)) return fine;
  return mixed(fine, sample_level(levels[finer + 1], sampler, sampler.minify, u, v),
               position - double(finer));
}

}  // namespace glassbox::in_full
