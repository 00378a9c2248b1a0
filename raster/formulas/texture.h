// Computes samples of a texture, and how fast the texture coordinates change from pixel to pixel.

// The coordinate within one period of its wrap mode: [0, 1) for repeat, [0, 2] where every second
// copy is mirrored, [0, 1] for clamp. The result is exact except for negative coordinates near 0:
// there the difference may be rounded up to the end of the period, which is next to its beginning
// in the repeated texture. A coordinate that is not finite becomes 0.
template <Number F>
inline F wrap_coordinate(Wrap wrap, F t) {
  F wrapped = t;
  switch (wrap) {
    case Wrap::kRepeat:
      wrapped = least(t - floor(t), F(0x1.fffffep-1f));
      break;
    case Wrap::kMirroredRepeat:
      wrapped = t - 2.0f * floor(t * 0.5f);
      break;
    case Wrap::kClampToEdge:
      wrapped = clamped(t, F(0.0f), F(1.0f));
      break;
  }
  return select(is_finite(t), wrapped, F(0.0f));
}

// Wraps an index into [0, period). The index may be below 0 or above the end, by less than one
// period.
template <WholeNumber I, class Size>
inline I into_period(I i, Size period) {
  const I from_below = select(i < 0, i + period, i);
  return select(from_below < period, from_below, from_below - period);
}

// Wraps a texel index that may be outside at either end by less than one period. If all lanes use
// the same level, `size` is one number.
template <WholeNumber I, class Size>
inline I wrap_texel(Wrap wrap, I i, Size size) {
  const I last = size - 1;
  switch (wrap) {
    case Wrap::kRepeat:
      return into_period(i, size);
    case Wrap::kMirroredRepeat: {
      const I j = into_period(i, size + size);
      return select(last < j, (last + size) - j, j);
    }
    case Wrap::kClampToEdge:
      return greatest(I(0), least(i, last));
  }
  return i;
}

// Returns texel `i` and the one after it, wrapped, for -1 <= i < size. At the image's edge the
// neighbour is on the opposite edge, or is the edge's texel itself. (A wrapped coordinate below 1
// times a size stays below the size when it is rounded.)
template <WholeNumber I, class Size>
inline std::array<I, 2> wrap_neighbours(Wrap wrap, I i, Size size) {
  const I next = i + 1, last = size - 1;
  switch (wrap) {
    case Wrap::kRepeat:
      return {select(i < 0, last, i), select(last < next, I(0), next)};
    case Wrap::kMirroredRepeat:
      break;  // handled below: the texture and its mirror image repeat together
    case Wrap::kClampToEdge:
      return {greatest(I(0), i), least(next, last)};
  }
  return {wrap_texel(wrap, i, size), wrap_texel(wrap, next, size)};
}

// ---- between texels ----

// Converts the fraction t in [0, 1] (of the distance from one texel or level to the next) to units
// of 2^-15: rounded down, at most 32767.
template <Number F>
inline auto fraction_of(F t) {
  const auto fraction = to_integer(t * 32768.0f);
  return least(fraction, decltype(fraction)(32767));
}

// Mixes from a at f = 0 towards b at f = 2^15, rounded to nearest. The result is never outside [a,
// b], and it differs by at most 1.5 from the exact mix with the fraction t that f was rounded from.
template <class T>
inline T mix_whole(T a, T b, T f) {
  return a + times_fraction(b - a, f);
}

// Converts a texel's integers to light and alpha. Alpha is divided, so that the alpha of a byte is
// the float nearest to byte / 255, and a cutoff of that value keeps it.
template <WholeNumber I>
inline auto light_of_texel(I whole) {
  return to_float(whole) * (1.0f / kFullTexel);
}
template <WholeNumber I>
inline auto alpha_of_texel(I whole) {
  return to_float(whole) / float(kFullTexel);
}

// ---- one level ----

// The width or height of a level whose base has `side` texels in that direction.
template <WholeNumber I>
inline I side_of_level(int side, I level) {
  return greatest(I(1), shifted_right(I(side), level));
}

// sample_nearest() returns the texel that contains (u, v), sample_linear() the weighted mean of the
// four texels around it. A texture has texel(level, x, y), and texels have mix(), which mixes their
// channels by mix_whole(). The coordinates are already wrapped. Texel centres are at halves.
template <Number F, class Texture, class Size>
inline auto sample_nearest(const Texture& texture, const Sampler& sampler,
                           const TextureLevelOf<Size>& level, F u, F v) {
  const auto x = to_integer(floor(u * to_float(level.width)));
  const auto y = to_integer(floor(v * to_float(level.height)));
  return texture.texel(level, wrap_texel(sampler.wrap_u, x, level.width),
                       wrap_texel(sampler.wrap_v, y, level.height));
}

template <Number F, class Texture, class Size>
inline auto sample_linear(const Texture& texture, const Sampler& sampler,
                          const TextureLevelOf<Size>& level, F u, F v) {
  const F x = u * to_float(level.width) - 0.5f, y = v * to_float(level.height) - 0.5f;
  const F left = floor(x), above = floor(y);
  const auto column = to_integer(left), row = to_integer(above);
  const auto [x0, x1] = wrap_neighbours(sampler.wrap_u, column, level.width);
  const auto [y0, y1] = wrap_neighbours(sampler.wrap_v, row, level.height);
  const auto across = fraction_of(x - left), down = fraction_of(y - above);
  return mix(mix(texture.texel(level, x0, y0), texture.texel(level, x1, y0), across),
             mix(texture.texel(level, x0, y1), texture.texel(level, x1, y1), across), down);
}

template <Number F, class Texture, class Size>
inline auto sample_level(const Texture& texture, const Sampler& sampler, Filter filter,
                         const TextureLevelOf<Size>& level, F u, F v) {
  return filter == Filter::kNearest ? sample_nearest(texture, sampler, level, u, v)
                                    : sample_linear(texture, sampler, level, u, v);
}

// ---- level of detail ----

// The change of lambda_k / w_k (screen weight over w of vertex k) over one pixel, from the change
// of the edge function.
template <Number F>
inline F slope_over_w(F edge_step, F inverse_area, F inverse_w) {
  return edge_step * inverse_area * inverse_w;
}

// The changes of 1/w, u/w and v/w over one pixel in x and in y. `slopes`: [axis][vertex], from
// slope_over_w; `texcoords`: [vertex][u, v].
template <Number F, class Condition>
inline TexturePlanesOf<F> planes_over_w(const std::array<std::array<F, 3>, 2>& slopes,
                                        const std::array<std::array<F, 2>, 3>& texcoords,
                                        Condition affine) {
  TexturePlanesOf<F> planes;
  planes.origin = texcoords[0];
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::array<F, 3>& slope = slopes[axis];
    planes.inverse_w[axis] = select(affine, F(0.0f), slope[0] + slope[1] + slope[2]);
    for (std::size_t i = 0; i < 2; ++i) {
      planes.over_w[axis][i] = slope[1] * (texcoords[1][i] - texcoords[0][i]) +
                               slope[2] * (texcoords[2][i] - texcoords[0][i]);
    }
  }
  return planes;
}

template <Number F>
inline TextureGradientOf<F> gradient_at(const TexturePlanesOf<F>& planes,
                                        const std::array<F, 2>& texcoord, F inverse_w) {
  const F w = 1.0f / inverse_w;
  TextureGradientOf<F> gradient;
  for (std::size_t i = 0; i < 2; ++i) {
    const F from_origin = texcoord[i] - planes.origin[i];
    gradient.along_x[i] = (planes.over_w[0][i] - from_origin * planes.inverse_w[0]) * w;
    gradient.along_y[i] = (planes.over_w[1][i] - from_origin * planes.inverse_w[1]) * w;
  }
  return gradient;
}

// log2 of a positive finite number: the exponent, plus a series in s = (m - 1)/(m + 1) for the
// mantissa m in [sqrt(1/2), sqrt(2)): log2 m = 2/ln 2 (s + s^3/3 + s^5/5 + s^7/7 + ...), |s| <
// 0.1716. The truncation error is below 5e-8; a level of detail needs no more.
template <Number F>
inline F log2_positive(F x) {
  const auto subnormal = x < 0x1p-126f;
  const auto bits = bits_of(select(subnormal, x * 0x1p23f, x));
  const F half_to_one = float_of((bits & 0x007fffff) | 0x3f000000);
  const auto low = half_to_one < 0.70710678f;
  const auto exponent = shifted_right<23>(bits) - 126 - one_where(low) - one_where(subnormal) * 23;
  const F m = select(low, half_to_one * 2.0f, half_to_one);
  const F s = (m - 1.0f) / (m + 1.0f);
  const F s2 = s * s;
  const F series = s * (1.0f + s2 * (1.0f / 3.0f + s2 * (1.0f / 5.0f + s2 * (1.0f / 7.0f))));
  return to_float(exponent) + 2.88539008f * series;
}

template <Number F>
inline F squared_texels(const std::array<F, 2>& change, int width, int height) {
  const F x = change[0] * float(width);
  const F y = change[1] * float(height);
  return x * x + y * y;
}

// log2 of the longer side of a pixel's footprint, in texels of level 0.
template <Number F>
inline F level_of_detail(const TextureGradientOf<F>& gradient, int width, int height) {
  const F longest = greatest(squared_texels(gradient.along_x, width, height),
                             squared_texels(gradient.along_y, width, height));
  const F level = select(is_finite(longest), 0.5f * log2_positive(longest),
                         F(std::numeric_limits<float>::max()));
  return select(longest > 0.0f, level, F(-std::numeric_limits<float>::infinity()));
}

// ---- between levels ----

// Samples the level whose texels are about as large as the pixel, or mixes the two levels around
// that size. `position` is in 0 .. last_level.
template <Number F, class Texture>
inline auto sample_minified(const Texture& texture, const Sampler& sampler, F u, F v, F position) {
  const Filter filter = sampler.minify;
  if (sampler.mip == MipFilter::kNone) {
    return sample_level(texture, sampler, filter, texture.base(), u, v);
  }
  if (sampler.mip == MipFilter::kNearest) {
    const auto nearest = to_integer(floor(position + 0.5f));
    return sample_level(texture, sampler, filter, texture.level(nearest), u, v);
  }
  const F finer = floor(position), beyond = position - finer;
  const auto texel = sample_level(texture, sampler, filter, texture.level(to_integer(finer)), u, v);
  if (none(beyond > 0.0f)) return texel;
  const auto coarser = to_integer(least(finer + 1.0f, F(float(texture.last_level()))));
  return mix(texel, sample_level(texture, sampler, filter, texture.level(coarser), u, v),
             fraction_of(beyond));
}

// Returns one filtered sample. A texture has base(), and level(k) for k in 0 .. last_level().
template <Number F, class Texture>
inline auto sample_texture(const Texture& texture, const Sampler& sampler,
                           const std::array<F, 2>& texcoord, F level_of_detail) {
  const F u = wrap_coordinate(sampler.wrap_u, texcoord[0]);
  const F v = wrap_coordinate(sampler.wrap_v, texcoord[1]);
  const auto magnified = !(level_of_detail > 0.0f);
  const F last = float(texture.last_level());
  const F position = select(magnified, F(0.0f), least(level_of_detail, last));
  if (sampler.magnify == sampler.minify || none(magnified)) {
    return sample_minified(texture, sampler, u, v, position);
  }
  const auto base = sample_level(texture, sampler, sampler.magnify, texture.base(), u, v);
  if (none(!magnified)) return base;
  return select(magnified, base, sample_minified(texture, sampler, u, v, position));
}
