// Colours of fragments: attributes, texture and light, vectorised (render/staged/fragment_color.h
// has them for one fragment). All fragments of a call belong to one draw; each has a small triangle
// of its own, or all share a large one.

#if defined(GLASSBOX_SHADE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SHADE_INL_H_
#undef GLASSBOX_SHADE_INL_H_
#else
#define GLASSBOX_SHADE_INL_H_
#endif

#include <glassbox/raster/lanes/large_source-inl.h>
#include <glassbox/raster/lanes/shared_source-inl.h>
#include <glassbox/raster/lanes/small_source-inl.h>
#include <glassbox/raster/lanes/texture-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

HWY_INLINE Floats distance_of(const ResolveJob& job, Floats depth, Floats inverse_w) {
  if (job.perspective) return least(1.0f / inverse_w, Floats(std::numeric_limits<float>::max()));
  return parallel_distance(depth, job.reversed, job.near, job.far);
}

// ---- colour ----

inline std::int32_t bytes_of(const ColorMask& mask) {
  const Rgba8 bytes{std::uint8_t(mask.r ? 255 : 0), std::uint8_t(mask.g ? 255 : 0),
                    std::uint8_t(mask.b ? 255 : 0), std::uint8_t(mask.a ? 255 : 0)};
  return std::bit_cast<std::int32_t>(bytes);
}

// The textures of a draw. They are fetched before its pixels' numbers are in registers, because
// making a mip chain is a call that would spill the registers.
struct DrawTextures {
  DrawTextures() = default;
  explicit DrawTextures(const ShadeDraw& draw)
      : color(draw.texture != nullptr ? &draw.texture->get() : nullptr),
        emission(draw.emission_texture != nullptr ? &draw.emission_texture->get() : nullptr) {}

  const MipChain* color = nullptr;
  const MipChain* emission = nullptr;
};

// The place at which a texture is sampled.
struct TexturePoint {
  Float2 texcoord;
  Floats level_of_detail;  // set for samplers that do not use the base level alone
};

template <class Source>
HWY_INLINE TexturePoint texture_point(const MipChain& texture, const Sampler& sampler,
                                      const Source& source) {
  TexturePoint point{source.texcoord(), 0.0f};
  if (HWY_LIKELY(samples_base_only(sampler))) return point;
  const TextureGradientOf<Floats> gradient =
      gradient_at(source.texture_planes(), point.texcoord, source.at().inverse_w);
  point.level_of_detail = level_of_detail(gradient, texture.width, texture.height);
  return point;
}

template <class Channels>
HWY_INLINE typename Channels::Texels sampled(const Channels& channels, const MipChain& texture,
                                             const Sampler& sampler, const TexturePoint& point) {
  const TextureInLanes<Channels> texels(texture, channels);
  if (HWY_LIKELY(samples_base_only(sampler))) return sample_base(texels, sampler, point.texcoord);
  return sample_texture(texels, sampler, point.texcoord, point.level_of_detail);
}

// The texels of a source, sampled when they are used.
template <class Channels, class Source>
struct TexelsOfSource {
  HWY_INLINE typename Channels::Texels color() const {
    return sampled(channels, *textures.color, *draw.sampler,
                   texture_point(*textures.color, *draw.sampler, source));
  }
  HWY_INLINE typename Channels::Texels emission() const {
    return sampled(channels, *textures.emission, *draw.emission_sampler,
                   texture_point(*textures.emission, *draw.emission_sampler, source));
  }
  const Channels& channels;
  const ShadeDraw& draw;
  const DrawTextures& textures;
  const Source& source;
};

// Material times vertex colour times texture, and the alpha of the same factors. Unused ones are
// optimised away.
template <class Channels>
struct SurfaceColor {
  ColorOf<Channels> color;
  Floats alpha;  // not used for opaque surfaces
};

template <class Channels, class Attributes, class Texels>
HWY_INLINE SurfaceColor<Channels> surface_color(const Channels& channels, const ShadeDraw& draw,
                                                const DrawTextures& textures,
                                                const Attributes& attributes,
                                                const Texels& texels) {
  const Rgba& base = draw.material->base_color;
  SurfaceColor<Channels> surface{channels.of(Rgb{Floats(base.r), Floats(base.g), Floats(base.b)}),
                                 Floats(base.a)};
  if (draw.color_indices != nullptr) {
    surface = {product(surface.color, channels.of(attributes.color())),
               surface.alpha * attributes.alpha()};
  }
  if (textures.color != nullptr) {
    const auto color = texels.color();
    surface.color = product(surface.color, color_of(color));
    if constexpr (Channels::kHasAlpha) surface.alpha = surface.alpha * alpha_of(color);
  }
  return surface;
}

template <class Channels, class Attributes>
HWY_INLINE ColorOf<Channels> lit(const Channels& channels, const ShadeDraw& draw,
                                 const ResolveJob& job, const Attributes& attributes,
                                 const ColorOf<Channels>& base) {
  if (draw.light == LightAt::kNowhere) return base;
  const Float3 normal = attributes.normal();
  const LightOf<Channels> light = attributes.template reflection<Channels>(draw, job, normal);
  return lit(base, normal, light, channels.of(draw.material->specular), draw.highlights);
}

template <class Channels, class Texels>
HWY_INLINE ColorOf<Channels> emission(const Channels& channels, const ShadeDraw& draw,
                                      const DrawTextures& textures, const Texels& texels) {
  const ColorOf<Channels> own = channels.of(
      Rgb{Floats(draw.emission[0]), Floats(draw.emission[1]), Floats(draw.emission[2])});
  if (textures.emission == nullptr) return own;
  return product(own, color_of(texels.emission()));
}

// The surface's colour after lighting, with its emission added.
template <class Channels, class Attributes, class Texels>
HWY_INLINE SurfaceColor<Channels> shining(const ShadeDraw& draw, const DrawTextures& textures,
                                          const ResolveJob& job, const Attributes& attributes,
                                          const Texels& texels) {
  const Channels channels(job);
  SurfaceColor<Channels> surface = surface_color(channels, draw, textures, attributes, texels);
  surface.color = lit(channels, draw, job, attributes, surface.color);
  if (HWY_UNLIKELY(draw.emits)) {
    surface.color = sum(surface.color, emission(channels, draw, textures, texels));
  }
  return surface;
}
template <class Channels, class Source>
HWY_INLINE SurfaceColor<Channels> shining(const ShadeDraw& draw, const DrawTextures& textures,
                                          const ResolveJob& job, const Source& source) {
  const Channels channels(job);
  return shining<Channels>(draw, textures, job, source,
                           TexelsOfSource<Channels, Source>{channels, draw, textures, source});
}

// The colour alone, for callers that shade fewer pixels than resolving does: compiled only once.
template <class Channels, class Source>
HWY_NOINLINE ColorOf<Channels> shining_by_call(const ShadeDraw& draw, const DrawTextures& textures,
                                               const ResolveJob& job, const Source& source) {
  return shining<Channels>(draw, textures, job, source).color;
}

// Packs a colour's bytes into one integer, opaque; channels that are not wanted are 0.
HWY_INLINE Ints encoded(const Rgb& color, const ResolveJob& job) {
  const auto byte = [&](bool wanted, Floats channel)
                        HWY_ATTR { return wanted ? encode(job.transfer, channel) : Ints(0); };
  return byte(job.channels.r, color[0]) | shifted_left<8>(byte(job.channels.g, color[1])) |
         (shifted_left<16>(byte(job.channels.b, color[2])) | std::int32_t(0xff000000u));
}
HWY_INLINE Ints encoded(const std::array<Floats, 2>& color, const ResolveJob& job) {
  const bool from_red = TwoChannels(job).first() == 0;
  Ints bytes = 0;
  if (from_red ? job.channels.r : job.channels.g) bytes = encode(job.transfer, color[0]);
  if (from_red ? job.channels.g : job.channels.b) {
    bytes = bytes | shifted_left<8>(encode(job.transfer, color[1]));
  }
  return (from_red ? bytes : shifted_left<8>(bytes)) | std::int32_t(0xff000000u);
}

// ---- several vectors of one draw ----

// The points at which a fragment samples its draw's textures; set only for textures that the draw
// has.
struct TexturePoints {
  TexturePoint color, emission;
};
template <class Channels>
struct FoundTexels {
  typename Channels::Texels color() const { return of_color; }
  typename Channels::Texels emission() const { return of_emission; }
  typename Channels::Texels of_color, of_emission;
};

template <class Source>
HWY_INLINE void find_points(const ShadeDraw& draw, const DrawTextures& textures,
                            const Source& source, TexturePoints& points) {
  if (textures.color != nullptr) {
    points.color = texture_point(*textures.color, *draw.sampler, source);
  }
  if (HWY_UNLIKELY(textures.emission != nullptr)) {
    points.emission = texture_point(*textures.emission, *draw.emission_sampler, source);
  }
}
template <class Channels>
HWY_INLINE void find_texels(const Channels& channels, const ShadeDraw& draw,
                            const DrawTextures& textures, const TexturePoints& points,
                            FoundTexels<Channels>& texels) {
  if (textures.color != nullptr) {
    texels.of_color = sampled(channels, *textures.color, *draw.sampler, points.color);
  }
  if (HWY_UNLIKELY(textures.emission != nullptr)) {
    texels.of_emission =
        sampled(channels, *textures.emission, *draw.emission_sampler, points.emission);
  }
}

// Whether the result is the texels themselves, in linear bytes.
inline bool shows_texels(const ShadeDraw& draw, const DrawTextures& textures,
                         const ResolveJob& job) {
  const Rgba& base = draw.material->base_color;
  return textures.color != nullptr && !draw.emits && draw.light == LightAt::kNowhere &&
         draw.color_indices == nullptr && base.r == 1 && base.g == 1 && base.b == 1 &&
         job.transfer == Transfer::kNone && job.channels.r && job.channels.g && job.channels.b;
}

// A vector of textured pixels waits for gathers and divisions, one after the other, as long as all
// its other work takes; and it has more instructions than the processor looks ahead. So each step
// is done for several vectors in turn: while one waits, the next ones are computed.
template <class Channels, class Source, class SourceOf>
HWY_INLINE void shade_in_steps(const ShadeDraw& draw, const DrawTextures& textures,
                               const ResolveJob& job, std::size_t count, const SourceOf& source_of,
                               Ints* colors) {
  typename Source::Fragments fragments[kBlockVectors];
  TexturePoints points[kBlockVectors];
  FoundTexels<Channels> texels[kBlockVectors];
  const Channels channels(job);
  for (std::size_t i = 0; i < count; ++i) {
    const Source source = source_of(i);
    fragments[i] = source.fragments();
    find_points(draw, textures, source, points[i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    find_texels(channels, draw, textures, points[i], texels[i]);
  }
  if constexpr (Channels::kHasAlpha) {
    if (shows_texels(draw, textures, job)) {
      for (std::size_t i = 0; i < count; ++i) {
        colors[i] = linear_bytes_of(texels[i].color()) | std::int32_t(0xff000000u);
      }
      return;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    colors[i] = encoded(shining<Channels>(draw, textures, job, fragments[i], texels[i]).color, job);
  }
}

// Computes the colours of `count` vectors, at most kBlockVectors; source_of(i) makes their sources.
// Without textures the steps would cost more than the waiting.
template <class Channels, class Source, class SourceOf>
HWY_INLINE void shade_vectors(const ShadeDraw& draw, const DrawTextures& textures,
                              const ResolveJob& job, std::size_t count, const SourceOf& source_of,
                              Ints* colors) {
  if (textures.color != nullptr || textures.emission != nullptr) {
    return shade_in_steps<Channels, Source>(draw, textures, job, count, source_of, colors);
  }
  for (std::size_t i = 0; i < count; ++i) {
    colors[i] = encoded(shining_by_call<Channels>(draw, textures, job, source_of(i)), job);
  }
}

template <class Channels, class Source>
HWY_INLINE Ints shade(const ShadeDraw& draw, const DrawTextures& textures, const ResolveJob& job,
                      const Source& source) {
  return encoded(shining<Channels>(draw, textures, job, source).color, job);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
