#include <glassbox/raster/texture.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>

#include <glassbox/base/numbers.h>

namespace glassbox {

#include <glassbox/raster/formulas/texture.h>

Texel mix(const Texel& a, const Texel& b, std::int32_t f) {
  const auto channel = [&](std::int32_t from, std::int32_t to) {
    return std::int16_t(mix_whole(from, to, f));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), channel(a.a, b.a)};
}

namespace {

// ---- texels of images ----

std::int16_t nearest_whole(float x) {
  return std::int16_t(x + 0.5f);
}

// The texel value of each stored byte.
using TexelOfByte = std::array<std::int16_t, 256>;

TexelOfByte texel_of_byte(Transfer transfer) {
  TexelOfByte whole{};
  for (std::size_t byte = 0; byte < whole.size(); ++byte) {
    whole[byte] = nearest_whole(decode(transfer, std::uint8_t(byte)) * float(kFullTexel));
  }
  return whole;
}

void append_texels(MipChain& chain, const Image<Rgba8>& image, Transfer transfer) {
  const TexelOfByte color = texel_of_byte(transfer), alpha = texel_of_byte(Transfer::kNone);
  for (const Rgba8& stored : image.pixels) {
    chain.texels.push_back({color[stored.r], color[stored.g], color[stored.b], alpha[stored.a]});
  }
}

// ---- mip chain ----

// The texels of a longer row that texel `i` of a shorter row covers, and their weights.
struct Footprint {
  int first = 0;
  // At most 3: if 2n + 1 texels become n texels, each new texel covers 2 + 1/n old texels, and new
  // texel i begins i/n of a texel after the start of old texel 2i.
  int count = 0;
  std::array<float, 3> weight{};  // sums to 1
};

Footprint footprint(int i, int short_side, int long_side) {
  // `low` and `high` are in units of 1 / short_side of a source texel, so that they are integers.
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

void add_scaled(std::array<float, 4>& sum, const Texel& texel, float weight) {
  sum[0] += weight * float(texel.r);
  sum[1] += weight * float(texel.g);
  sum[2] += weight * float(texel.b);
  sum[3] += weight * float(texel.a);
}

// Appends the next smaller level of the chain.
void add_half(MipChain& chain) {
  const int last = chain.last_level();
  const int width = side_of_level(chain.width, last), height = side_of_level(chain.height, last);
  const std::vector<Footprint> columns = footprints(side_of_level(width, 1), width);
  const std::vector<Footprint> rows = footprints(side_of_level(height, 1), height);
  const auto first = std::size_t(chain.first.back());
  chain.first.push_back(std::int32_t(chain.texels.size()));
  for (const Footprint& down : rows) {
    for (const Footprint& across : columns) {
      std::array<float, 4> sum{};
      for (int row = 0; row < down.count; ++row) {
        for (int column = 0; column < across.count; ++column) {
          const int texel = (down.first + row) * width + across.first + column;
          add_scaled(sum, chain.texels[first + std::size_t(texel)],
                     down.weight[std::size_t(row)] * across.weight[std::size_t(column)]);
        }
      }
      chain.texels.push_back({nearest_whole(sum[0]), nearest_whole(sum[1]), nearest_whole(sum[2]),
                              nearest_whole(sum[3])});
    }
  }
}

// ---- sampling ----

// The interface to a mip chain that formulas/texture.h expects.
class Levels {
public:
  explicit Levels(const MipChain& chain) : chain_(chain) {}

  int last_level() const { return chain_.last_level(); }
  TextureLevelOf<std::int32_t> base() const { return {chain_.width, chain_.height, 0}; }
  TextureLevelOf<std::int32_t> level(std::int32_t k) const {
    return {side_of_level(chain_.width, k), side_of_level(chain_.height, k),
            chain_.first[std::size_t(k)]};
  }
  Texel texel(const TextureLevelOf<std::int32_t>& level, std::int32_t x, std::int32_t y) const {
    return chain_.texels[std::size_t(level.first + y * level.width + x)];
  }

private:
  const MipChain& chain_;
};

}  // namespace

Rgba light_of(const Texel& texel) {
  const auto light = [](std::int32_t whole) { return light_of_texel(whole); };
  return {light(texel.r), light(texel.g), light(texel.b), alpha_of_texel(std::int32_t(texel.a))};
}

Rgba8 stored_texel(const Texel& texel, Transfer transfer) {
  const Rgba light = light_of(texel);
  return {encode(transfer, light.r), encode(transfer, light.g), encode(transfer, light.b),
          encode_unorm8(light.a)};
}

MipChain make_mip_chain(const Image<Rgba8>& image, Transfer transfer, bool first_level_only) {
  assert(image.pixels.size() < std::size_t(1) << 27);
  MipChain chain{image.width, image.height, {0}, {}};
  // Reserve memory for all levels at once. Only for a very narrow image is it too little; then the
  // memory grows later.
  chain.texels.reserve(first_level_only ? image.pixels.size() : image.pixels.size() / 3 * 4 + 4);
  append_texels(chain, image, transfer);
  const auto texels = [&](int level) {
    return side_of_level(chain.width, level) * side_of_level(chain.height, level);
  };
  while (!first_level_only && texels(chain.last_level()) > 1) add_half(chain);
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

Rgba sample_mip_chain(const MipChain& texture, const Sampler& sampler,
                      const std::array<float, 2>& texcoord, float level_of_detail) {
  return light_of(sample_texture(Levels(texture), sampler, texcoord, level_of_detail));
}

}  // namespace glassbox
