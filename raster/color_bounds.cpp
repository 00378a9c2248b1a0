#include <glassbox/raster/color_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/base/elementary.h>
#include <glassbox/base/rounding.h>

namespace glassbox {
namespace {

using bounded::Bounded;

constexpr double kU = unit_roundoff<float>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Covers the errors of the logarithms and powers of the C library, which are accurate to much
// better than 2^-40.
constexpr double kRoundUp = 1 + 0x1p-40;

// ---- which texels ----

// If the error of a coordinate is this many texels or more, any texel value is taken as possible.
constexpr double kMaxTexels = 8;

std::int64_t remainder_of(std::int64_t i, std::int64_t period) {
  const std::int64_t rest = i % period;
  return rest < 0 ? rest + period : rest;
}

std::int32_t wrapped_texel(Wrap wrap, std::int64_t i, std::int32_t size) {
  if (wrap == Wrap::kClampToEdge) {
    return std::int32_t(std::clamp<std::int64_t>(i, 0, size - 1));
  }
  if (wrap == Wrap::kRepeat) return std::int32_t(remainder_of(i, size));
  const std::int64_t j = remainder_of(i, 2 * std::int64_t(size));
  return std::int32_t(j < size ? j : 2 * std::int64_t(size) - 1 - j);
}

// Returns what wrap_coordinate() would return without its rounding errors: the coordinate within
// its period, in double.
double wrapped_coordinate(Wrap wrap, double t) {
  switch (wrap) {
    case Wrap::kRepeat:
      return t - std::floor(t);
    case Wrap::kMirroredRepeat:
      return t - 2 * std::floor(t / 2);
    case Wrap::kClampToEdge:
      break;
  }
  return std::clamp(t, 0.0, 1.0);
}

struct Level {
  std::int32_t width = 1, height = 1;
  std::size_t first = 0;
};

Level level_of(const MipChain& texture, int k) {
  return {std::max(1, texture.width >> k), std::max(1, texture.height >> k),
          std::size_t(texture.first[std::size_t(k)])};
}

// The smallest and the largest value of each channel.
struct Range {
  std::array<int, 4> low{kFullTexel, kFullTexel, kFullTexel, kFullTexel}, high{};

  void include(const Texel& texel) {
    const std::array<int, 4> channels{texel.r, texel.g, texel.b, texel.a};
    for (std::size_t i = 0; i < 4; ++i) {
      low[i] = std::min(low[i], channels[i]);
      high[i] = std::max(high[i], channels[i]);
    }
  }
  double contrast() const {
    int most = 0;
    for (std::size_t i = 0; i < 4; ++i) most = std::max(most, high[i] - low[i]);
    return most;
  }
};

// Collects, level by level, which texels a sample may read if its coordinates vary within their
// error bounds.
class ReachableTexels {
public:
  ReachableTexels(const MipChain& texture, const Sampler& sampler,
                  const std::array<Bounded, 2>& texcoord)
      : texture_(texture), sampler_(sampler), texcoord_(texcoord) {}

  void add_level(int k, Filter filter) {
    const Level level = level_of(texture_, k);
    const Side across = side(sampler_.wrap_u, texcoord_[0], level.width, filter);
    const Side down = side(sampler_.wrap_v, texcoord_[1], level.height, filter);
    coarsest_ = std::max(coarsest_, k);
    if (!(across.off < kMaxTexels && down.off < kMaxTexels)) {
      may_choose_ = all_reachable_ = true;
      return;
    }
    if (filter == Filter::kLinear) {
      is_linear_ = true;
      texel_error_ = std::max(texel_error_, across.off + down.off);
    } else {
      may_choose_ |= across.first != across.last || down.first != down.last;
    }
    include_texels(level, across, down);
  }

  // kFullTexel if every texel may be reached.
  double contrast() const { return all_reachable_ ? kFullTexel : range_.contrast(); }
  // The sum of the errors along x and y, in texels, where filters are linear.
  double texel_error() const { return texel_error_; }
  bool may_choose() const { return may_choose_; }  // rounding decides which texel is the nearest
  bool is_linear() const { return is_linear_; }
  int coarsest() const { return coarsest_; }

private:
  // One side (width or height) of a level: the range first .. last of texels that may be read,
  // before wrapping, and the error of the sample's position in texels.
  struct Side {
    std::int64_t first = 0, last = 0;
    double off = 0;
  };

  static Side side(Wrap wrap, const Bounded& t, std::int32_t size, Filter filter) {
    const double off = double(size) * (t.bound + 3 * 0x1p-23) * kRoundUp;
    if (!(off < kMaxTexels)) return {0, 0, off};
    const bool linear = filter == Filter::kLinear;
    const double x = wrapped_coordinate(wrap, double(t.value)) * size - (linear ? 0.5 : 0);
    return {std::int64_t(std::floor(x - off)), std::int64_t(std::floor(x + off)) + linear, off};
  }

  void include_texels(const Level& level, const Side& across, const Side& down) {
    for (std::int64_t y = down.first; y <= down.last; ++y) {
      const auto row = std::size_t(wrapped_texel(sampler_.wrap_v, y, level.height));
      for (std::int64_t x = across.first; x <= across.last; ++x) {
        const auto column = std::size_t(wrapped_texel(sampler_.wrap_u, x, level.width));
        range_.include(texture_.texels[level.first + row * std::size_t(level.width) + column]);
      }
    }
  }

  const MipChain& texture_;
  const Sampler& sampler_;
  const std::array<Bounded, 2>& texcoord_;
  Range range_;
  bool all_reachable_ = false, may_choose_ = false, is_linear_ = false;
  int coarsest_ = 0;
  double texel_error_ = 0;
};

// ---- which levels ----

// The lower and upper bound of the sample's position on the mip chain: 0 is the full image, 1 the
// next level.
struct Position {
  double low = 0, high = 0;
  bool may_be_magnified = false, may_be_minified = false;
};

Position position_of(const LevelBounds& level, int last) {
  return {std::clamp(level.low, 0.0, double(last)), std::clamp(level.high, 0.0, double(last)),
          !(level.low > 0), level.high > 0};
}

// The rounding error of position + 1/2: the unit roundoff, 2^-24, times at most 32 levels.
constexpr double kLevelRounding = 0x1p-19;

// Adds to `reach` the levels that a minified sample may come from. Returns whether rounding decides
// which of two levels is chosen.
bool add_minified_levels(const MipChain& texture, const Sampler& sampler, const Position& position,
                         ReachableTexels& reach) {
  if (sampler.mip == MipFilter::kNone) {
    reach.add_level(0, sampler.minify);
    return false;
  }
  const int last = texture.last_level();
  int first_level = int(std::floor(position.low)), last_level = int(std::ceil(position.high));
  if (sampler.mip == MipFilter::kNearest) {
    first_level = int(std::floor(position.low + 0.5 - kLevelRounding));
    last_level = int(std::floor(position.high + 0.5 + kLevelRounding));
  }
  first_level = std::clamp(first_level, 0, last);
  last_level = std::clamp(last_level, 0, last);
  for (int k = first_level; k <= last_level; ++k) reach.add_level(k, sampler.minify);
  return sampler.mip == MipFilter::kNearest && first_level != last_level;
}

// ---- the transfer function ----

// The sRGB encoding of IEC 61966-2-1, in bytes.
double encoded_bytes(Transfer transfer, double light) {
  const double x = std::clamp(light, 0.0, 1.0);
  if (transfer == Transfer::kNone) return 255 * x;
  return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * power(x, 1 / 2.4) - 0.055);
}

double decoded_bytes(Transfer transfer, double bytes) {
  const double x = std::clamp(bytes / 255, 0.0, 1.0);
  if (transfer == Transfer::kNone) return x;
  return x <= 0.04045 ? x / 12.92 : power((x + 0.055) / 1.055, 2.4);
}

}  // namespace

LevelBounds level_bounds(float level, const Bounded& squared_texels) {
  const double size = double(squared_texels.value), bound = squared_texels.bound;
  const double log = size > 0 ? logarithm_2(size) : 0;
  const double own =
      (0.5 * (5e-8 + 4 * kU + kU * (std::abs(log) + 1)) + kU * std::abs(log)) * kRoundUp;
  LevelBounds bounds{-kInfinity, kInfinity};
  if (size > bound) bounds.low = 0.5 * logarithm_2(size - bound) - own;
  if (size + bound <= std::numeric_limits<double>::max()) {
    // This is minus infinity where the footprint has no size at all.
    bounds.high = 0.5 * logarithm_2(size + bound) + own;
  }
  return {std::min(bounds.low, double(level)), std::max(bounds.high, double(level))};
}

double sample_bound(const MipChain& texture, const Sampler& sampler, Transfer transfer,
                    const std::array<Bounded, 2>& texcoord, const LevelBounds& level) {
  const Position position = position_of(level, texture.last_level());
  ReachableTexels reach(texture, sampler, texcoord);
  const bool one_filter = sampler.magnify == sampler.minify;
  bool may_choose = !one_filter && position.may_be_magnified && position.may_be_minified;
  if (position.may_be_magnified) reach.add_level(0, sampler.magnify);
  if (position.may_be_minified) {
    may_choose |= add_minified_levels(texture, sampler, position, reach);
  }
  may_choose |= reach.may_choose();

  const bool between_levels = sampler.mip == MipFilter::kLinear && position.high > 0;
  const double mixing = (reach.is_linear() ? 3 : 0) + (between_levels ? 1.5 : 0);
  const double levels_off = between_levels ? position.high - position.low : 0;
  const double texels = (transfer == Transfer::kNone ? 0 : 0.5) + reach.coarsest() * 0.53;
  const double by_place = may_choose ? 1 : std::min(1.0, reach.texel_error() + levels_off);
  const double units = texels + mixing + reach.contrast() * by_place;
  return (units / kFullTexel + 2 * kU) * kRoundUp;
}

double stored_bound(Transfer transfer, std::uint8_t stored, const Bounded& light) {
  const double low = encoded_bytes(transfer, double(light.value) - light.bound);
  const double high = encoded_bytes(transfer, double(light.value) + light.bound);
  if (!light.is_bounded()) return std::max(double(stored), 255 - double(stored));
  return std::max(std::abs(stored - low), std::abs(stored - high)) * kRoundUp + 0x1p-40;
}

Bounded light_of_stored(Transfer transfer, std::uint8_t stored, double bound) {
  const double light = decoded_bytes(transfer, stored);
  const double off = std::max(light - decoded_bytes(transfer, stored - bound),
                              decoded_bytes(transfer, stored + bound) - light);
  const float value = decode(transfer, stored);
  return {value, (off + kU) * kRoundUp};
}

}  // namespace glassbox
