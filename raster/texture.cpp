#include <glassbox/raster/texture.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>

#include <glassbox/base/numbers.h>

namespace glassbox {

Rgba mix(const Rgba& a, const Rgba& b, float t) {
  return {mix(a.r, b.r, t), mix(a.g, b.g, t), mix(a.b, b.b, t), mix(a.a, b.a, t)};
}

#include <glassbox/raster/formulas/texture.h>

namespace {

Rgba decode_texel(const Rgba8& texel, Transfer transfer, const ColorMask& wanted = {}) {
  Rgba color{0, 0, 0, 0};
  if (wanted.r) color.r = decode(transfer, texel.r);
  if (wanted.g) color.g = decode(transfer, texel.g);
  if (wanted.b) color.b = decode(transfer, texel.b);
  if (wanted.a) color.a = decode_unorm8(texel.a);
  return color;
}

Rgba8 encode_texel(const Rgba& color, Transfer transfer) {
  return {encode(transfer, color.r), encode(transfer, color.g), encode(transfer, color.b),
          encode_unorm8(color.a)};
}

void add_scaled(Rgba& sum, const Rgba& color, float weight) {
  sum.r += weight * color.r;
  sum.g += weight * color.g;
  sum.b += weight * color.b;
  sum.a += weight * color.a;
}

// ---- mip chain ----

// The texels of a longer row that texel `i` of a shorter one covers, and how much of each.
struct Footprint {
  int first = 0;
  int count = 0;  // at most 3: 2n + 1 texels over n, each of which starts i/n texels late
  std::array<float, 3> weight{};  // sums to 1
};

Footprint footprint(int i, int short_side, int long_side) {
  // In units of 1 / short_side of a source texel, so that every bound is an integer.
  const std::int64_t low = std::int64_t(i) * long_side;
  const std::int64_t high = low + long_side;
  Footprint covered;
  covered.first = int(low / short_side);
  for (int texel = covered.first; std::int64_t(texel) * short_side < high; ++texel) {
    const std::int64_t texel_low = std::max(low, std::int64_t(texel) * short_side);
    const std::int64_t texel_high = std::min(high, std::int64_t(texel + 1) * short_side);
    covered.weight[std::size_t(covered.count++)] = float(texel_high - texel_low) / float(long_side);
  }
  return covered;
}

std::vector<Footprint> footprints(int short_side, int long_side) {
  std::vector<Footprint> covered;
  for (int i = 0; i < short_side; ++i) covered.push_back(footprint(i, short_side, long_side));
  return covered;
}

// Appends the level after the last.
void add_half(MipChain& chain, Transfer transfer) {
  const int last = chain.last_level();
  const int width = side_of_level(chain.width, last), height = side_of_level(chain.height, last);
  const std::vector<Footprint> columns = footprints(side_of_level(width, 1), width);
  const std::vector<Footprint> rows = footprints(side_of_level(height, 1), height);
  const auto first = std::size_t(chain.first.back());
  chain.first.push_back(std::int32_t(chain.texels.size()));
  for (const Footprint& down : rows) {
    for (const Footprint& across : columns) {
      Rgba sum{0, 0, 0, 0};
      for (int row = 0; row < down.count; ++row) {
        for (int column = 0; column < across.count; ++column) {
          const int texel = (down.first + row) * width + across.first + column;
          add_scaled(sum, decode_texel(chain.texels[first + std::size_t(texel)], transfer),
                     down.weight[std::size_t(row)] * across.weight[std::size_t(column)]);
        }
      }
      chain.texels.push_back(encode_texel(sum, transfer));
    }
  }
}

// ---- sampling ----

// The texels of a chain, in linear light.
class LinearTexture {
public:
  LinearTexture(const MipChain& chain, Transfer transfer, const ColorMask& wanted)
      : chain_(chain), transfer_(transfer), wanted_(wanted) {}

  int last_level() const { return chain_.last_level(); }
  TextureLevelOf<std::int32_t> base() const { return {chain_.width, chain_.height, 0}; }
  TextureLevelOf<std::int32_t> level(std::int32_t k) const {
    return {side_of_level(chain_.width, k), side_of_level(chain_.height, k),
            chain_.first[std::size_t(k)]};
  }
  Rgba texel(const TextureLevelOf<std::int32_t>& level, std::int32_t x, std::int32_t y) const {
    return decode_texel(chain_.texels[std::size_t(level.first + y * level.width + x)], transfer_,
                        wanted_);
  }

private:
  const MipChain& chain_;
  Transfer transfer_;
  const ColorMask& wanted_;
};

}  // namespace

MipChain make_mip_chain(const Image<Rgba8>& image, Transfer transfer, bool first_level_only) {
  assert(image.pixels.size() < std::size_t(1) << 30);
  MipChain chain{image.width, image.height, {0}, {}};
  // All levels together, unless the image is a strip: then the memory grows on the way.
  if (!first_level_only) chain.texels.reserve(image.pixels.size() / 3 * 4 + 4);
  chain.texels = image.pixels;
  const auto texels = [&](int level) {
    return side_of_level(chain.width, level) * side_of_level(chain.height, level);
  };
  while (!first_level_only && texels(chain.last_level()) > 1) add_half(chain, transfer);
  return chain;
}

const MipChain& LazyMipChain::make() const {
  std::call_once(once_, [&] {
    chain_ = make_mip_chain(image_, transfer_, first_level_only_);
    made_ = &chain_;
  });
  return chain_;
}

TexturePlanes texture_planes(const TriangleSetup& triangle,
                             const std::array<std::array<float, 2>, 3>& texcoords) {
  std::array<std::array<float, 3>, 2> slopes;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto slope = [&](std::int64_t step) {
      return slope_over_w(to_float(step * kSubpixels), triangle.inverse_area,
                          triangle.inverse_w[k]);
    };
    slopes[0][k] = slope(triangle.edges[k].a);
    slopes[1][k] = slope(triangle.edges[k].b);
  }
  return planes_over_w(slopes, texcoords, triangle.affine);
}

TextureGradient texture_gradient(const TexturePlanes& planes, const std::array<float, 2>& texcoord,
                                 float inverse_w) {
  return gradient_at(planes, texcoord, inverse_w);
}

float level_of_detail(const TextureGradient& gradient, int width, int height) {
  return level_of_detail<float>(gradient, width, height);
}

Rgba sample(const MipChain& texture, const Sampler& sampler, const std::array<float, 2>& texcoord,
            float level_of_detail, Transfer transfer, const ColorMask& wanted) {
  return sample_texture(LinearTexture(texture, transfer, wanted), sampler, texcoord,
                        level_of_detail);
}

}  // namespace glassbox
