#include <glassbox/raster/texture.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace glassbox {

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

Rgba mix(const Rgba& a, const Rgba& b, float t) {
  return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b),
          a.a + t * (b.a - a.a)};
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

Image<Rgba8> half(const Image<Rgba8>& image, Transfer transfer) {
  Image<Rgba8> smaller(std::max(1, image.width / 2), std::max(1, image.height / 2));
  for (int y = 0; y < smaller.height; ++y) {
    const Footprint rows = footprint(y, smaller.height, image.height);
    for (int x = 0; x < smaller.width; ++x) {
      const Footprint columns = footprint(x, smaller.width, image.width);
      Rgba sum{0, 0, 0, 0};
      for (int row = 0; row < rows.count; ++row) {
        for (int column = 0; column < columns.count; ++column) {
          const Rgba8& texel = image.at(columns.first + column, rows.first + row);
          add_scaled(sum, decode_texel(texel, transfer),
                     rows.weight[std::size_t(row)] * columns.weight[std::size_t(column)]);
        }
      }
      smaller.at(x, y) = encode_texel(sum, transfer);
    }
  }
  return smaller;
}

// ---- level of detail ----

// log2 of a positive finite number: the exponent, and a series in s = (m - 1)/(m + 1) for the mantissa m in
// [sqrt(1/2), sqrt(2)): log2 m = 2/ln 2 (s + s^3/3 + s^5/5 + s^7/7 + ...), |s| < 0.1716. What is left out is below
// 5e-8; a level of detail needs no more.
float log2_positive(float x) {
  int exponent = 0;
  float m = std::frexp(x, &exponent);  // [1/2, 1)
  if (m < 0.70710678f) {
    m *= 2.0f;
    --exponent;
  }
  const float s = (m - 1.0f) / (m + 1.0f);
  const float s2 = s * s;
  const float series = s * (1.0f + s2 * (1.0f / 3.0f + s2 * (1.0f / 5.0f + s2 * (1.0f / 7.0f))));
  return float(exponent) + 2.88539008f * series;
}

// ---- sampling ----

// The coordinate within one period of its wrap mode: [0, 1), or [0, 2] where every second copy is mirrored, or [0, 1].
// Exact but for negative ones near 0, which the sum may round up to the whole period: to the first texel's side.
float wrap_coordinate(Wrap wrap, float t) {
  if (!std::isfinite(t)) return 0.0f;
  switch (wrap) {
    case Wrap::kRepeat:
      return std::min(t - std::floor(t), 0x1.fffffep-1f);
    case Wrap::kMirroredRepeat:
      return t - 2.0f * std::floor(t * 0.5f);
    case Wrap::kClampToEdge:
      return std::clamp(t, 0.0f, 1.0f);
  }
  return 0.0f;
}

// A texel index that may be off either end by less than a period.
int wrap_texel(Wrap wrap, int i, int size) {
  switch (wrap) {
    case Wrap::kRepeat:
      return (i + size) % size;
    case Wrap::kMirroredRepeat: {
      const int j = (i + 2 * size) % (2 * size);
      return j < size ? j : 2 * size - 1 - j;
    }
    case Wrap::kClampToEdge:
      return std::clamp(i, 0, size - 1);
  }
  return 0;
}

Rgba sample_nearest(const Image<Rgba8>& image, const Sampler& sampler, float u, float v,
                    Transfer transfer, const ColorMask& wanted) {
  const int x = wrap_texel(sampler.wrap_u, int(std::floor(u * float(image.width))), image.width);
  const int y = wrap_texel(sampler.wrap_v, int(std::floor(v * float(image.height))), image.height);
  return decode_texel(image.at(x, y), transfer, wanted);
}

Rgba sample_linear(const Image<Rgba8>& image, const Sampler& sampler, float u, float v,
                   Transfer transfer, const ColorMask& wanted) {
  // Texel centres are at halves.
  const float x = u * float(image.width) - 0.5f;
  const float y = v * float(image.height) - 0.5f;
  const float left = std::floor(x);
  const float above = std::floor(y);
  const int x0 = wrap_texel(sampler.wrap_u, int(left), image.width);
  const int x1 = wrap_texel(sampler.wrap_u, int(left) + 1, image.width);
  const int y0 = wrap_texel(sampler.wrap_v, int(above), image.height);
  const int y1 = wrap_texel(sampler.wrap_v, int(above) + 1, image.height);
  const Rgba top = mix(decode_texel(image.at(x0, y0), transfer, wanted),
                       decode_texel(image.at(x1, y0), transfer, wanted), x - left);
  const Rgba bottom = mix(decode_texel(image.at(x0, y1), transfer, wanted),
                          decode_texel(image.at(x1, y1), transfer, wanted), x - left);
  return mix(top, bottom, y - above);
}

Rgba sample_level(const Image<Rgba8>& image, const Sampler& sampler, Filter filter, float u,
                  float v, Transfer transfer, const ColorMask& wanted) {
  return filter == Filter::kNearest ? sample_nearest(image, sampler, u, v, transfer, wanted)
                                    : sample_linear(image, sampler, u, v, transfer, wanted);
}

}  // namespace

MipChain make_mip_chain(const Image<Rgba8>& image, Transfer transfer, bool first_level_only) {
  MipChain chain;
  chain.levels.push_back(image);
  while (!first_level_only && (chain.levels.back().width > 1 || chain.levels.back().height > 1)) {
    chain.levels.push_back(half(chain.levels.back(), transfer));
  }
  return chain;
}

TexturePlanes texture_planes(const TriangleSetup& triangle,
                             const std::array<std::array<float, 2>, 3>& texcoords) {
  TexturePlanes planes;
  planes.origin = texcoords[0];
  for (std::size_t axis = 0; axis < 2; ++axis) {
    // d lambda_k over one pixel, times 1/w_k.
    std::array<float, 3> slope;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t step = axis == 0 ? triangle.edges[k].a : triangle.edges[k].b;
      slope[k] = float(step * kSubpixels) * triangle.inverse_area * triangle.inverse_w[k];
    }
    planes.inverse_w[axis] = triangle.affine ? 0.0f : slope[0] + slope[1] + slope[2];
    for (std::size_t i = 0; i < 2; ++i) {
      planes.over_w[axis][i] = slope[1] * (texcoords[1][i] - texcoords[0][i]) +
                               slope[2] * (texcoords[2][i] - texcoords[0][i]);
    }
  }
  return planes;
}

TextureGradient texture_gradient(const TexturePlanes& planes, const std::array<float, 2>& texcoord,
                                 float inverse_w) {
  const float w = 1.0f / inverse_w;
  const auto along = [&](std::size_t axis) {
    std::array<float, 2> change;
    for (std::size_t i = 0; i < 2; ++i) {
      change[i] =
          (planes.over_w[axis][i] - (texcoord[i] - planes.origin[i]) * planes.inverse_w[axis]) * w;
    }
    return change;
  };
  return {along(0), along(1)};
}

float level_of_detail(const TextureGradient& gradient, int width, int height) {
  const auto squared_texels = [&](const std::array<float, 2>& change) {
    const float x = change[0] * float(width);
    const float y = change[1] * float(height);
    return x * x + y * y;
  };
  const float longest =
      std::max(squared_texels(gradient.along_x), squared_texels(gradient.along_y));
  if (!(longest > 0.0f)) return -std::numeric_limits<float>::infinity();
  if (!std::isfinite(longest)) return std::numeric_limits<float>::max();
  return 0.5f * log2_positive(longest);
}

Rgba sample(const MipChain& texture, const Sampler& sampler, const std::array<float, 2>& texcoord,
            float level_of_detail, Transfer transfer, const ColorMask& wanted) {
  const float u = wrap_coordinate(sampler.wrap_u, texcoord[0]);
  const float v = wrap_coordinate(sampler.wrap_v, texcoord[1]);
  const auto level = [&](std::size_t k, Filter filter) {
    return sample_level(texture.levels[k], sampler, filter, u, v, transfer, wanted);
  };
  if (!(level_of_detail > 0.0f)) return level(0, sampler.magnify);
  if (sampler.mip == MipFilter::kNone) return level(0, sampler.minify);

  const float last = float(texture.levels.size() - 1);
  const float position = std::min(level_of_detail, last);
  if (sampler.mip == MipFilter::kNearest) {
    return level(std::size_t(std::floor(position + 0.5f)), sampler.minify);
  }
  const float finer = std::floor(position);
  if (finer == position) return level(std::size_t(finer), sampler.minify);
  return mix(level(std::size_t(finer), sampler.minify),
             level(std::size_t(finer) + 1, sampler.minify), position - finer);
}

}  // namespace glassbox
