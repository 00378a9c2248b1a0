// Colours of fragments, vectorised: the formulas of raster/formulas/surface.h, and the encoding to
// bytes. All fragments of a call belong to one draw; each has a small triangle of its own, or all
// share a large one.

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
  Floats level_of_detail;  // not set if the sampler uses only the base level
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

// A vector of fragments, with the members that formulas/surface.h needs. Unused results are
// optimised away.
template <class Channels, class Attributes, class Texels>
struct FragmentInLanes : UnobservedFragment {
  using Float = Floats;
  static constexpr std::size_t kChannels = Channels::kCount;

  const Channels& channels;
  const ShadeDraw& draw;
  const DrawTextures& textures;
  const Lighting* light;  // null: the lit colour is not needed
  const Attributes& attributes;
  const Texels& texels;

  HWY_INLINE std::size_t first_channel() const { return channels.first(); }
  template <class T>
  HWY_INLINE std::array<T, kChannels> wanted(const std::array<T, 3>& three) const {
    return channels.pick(three);
  }

  HWY_INLINE const Material& material() const { return *draw.material; }
  HWY_INLINE bool has_vertex_color() const { return draw.color_indices != nullptr; }
  HWY_INLINE SurfaceOf<Channels> vertex_color() const {
    return {channels.pick(attributes.color()), attributes.alpha()};
  }
  HWY_INLINE bool has_texture() const { return textures.color != nullptr; }
  HWY_INLINE SurfaceOf<Channels> texel() const {
    const auto texel = texels.color();
    return {color_of(texel), alpha_of(texel)};
  }

  HWY_INLINE bool is_lit() const { return draw.light != LightAt::kNowhere; }
  HWY_INLINE const Lighting& lighting() const { return *light; }
  HWY_INLINE bool has_highlights() const { return draw.highlights; }
  HWY_INLINE Float3 normal() const { return attributes.normal(); }
  HWY_INLINE Float3 position() const { return attributes.position(); }
  HWY_INLINE bool is_lit_at_vertices() const { return Attributes::is_lit_at_vertices(draw); }
  HWY_INLINE LightOf<Channels> light_of_vertices() const {
    return light_of(channels, attributes.light_of_vertices(draw, *light));
  }

  HWY_INLINE bool emits() const { return HWY_UNLIKELY(draw.emits); }
  HWY_INLINE const std::array<float, 3>& emission() const { return draw.emission; }
  HWY_INLINE bool has_emission_texture() const { return textures.emission != nullptr; }
  HWY_INLINE ColorOf<Channels> emission_texel() const { return color_of(texels.emission()); }
};

// The surface's colour after lighting, with its emission added. Its alpha has no meaning where only
// some of the channels are computed.
template <class Channels, class Attributes, class Texels>
HWY_INLINE SurfaceOf<Channels> shaded_surface(const ShadeDraw& draw, const DrawTextures& textures,
                                              const ResolveJob& job, const Attributes& attributes,
                                              const Texels& texels) {
  const Channels channels(job);
  using Fragment = FragmentInLanes<Channels, Attributes, Texels>;
  const Fragment at{{}, channels, draw, textures, job.lighting, attributes, texels};
  SurfaceOf<Channels> surface = surface_color(at);
  surface.color = shaded_color(at, surface.color);
  return surface;
}
template <class Channels, class Source>
HWY_INLINE SurfaceOf<Channels> shaded_surface(const ShadeDraw& draw, const DrawTextures& textures,
                                              const ResolveJob& job, const Source& source) {
  const Channels channels(job);
  return shaded_surface<Channels>(
      draw, textures, job, source,
      TexelsOfSource<Channels, Source>{channels, draw, textures, source});
}

// Computes only the colour. It is not inlined, so it is compiled once for all callers that shade
// only a few pixels.
template <class Channels, class Source>
HWY_NOINLINE ColorOf<Channels> shaded_color_by_call(const ShadeDraw& draw,
                                                    const DrawTextures& textures,
                                                    const ResolveJob& job, const Source& source) {
  return shaded_surface<Channels>(draw, textures, job, source).color;
}

// Encodes a colour and packs its bytes into one integer with alpha 255. Channels that are not in
// job.channels are 0.
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
struct SampledTexels {
  typename Channels::Texels color() const { return of_color; }
  typename Channels::Texels emission() const { return of_emission; }
  typename Channels::Texels of_color, of_emission;
};

template <class Source>
HWY_INLINE void find_texture_points(const ShadeDraw& draw, const DrawTextures& textures,
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
                            SampledTexels<Channels>& texels) {
  if (textures.color != nullptr) {
    texels.of_color = sampled(channels, *textures.color, *draw.sampler, points.color);
  }
  if (HWY_UNLIKELY(textures.emission != nullptr)) {
    texels.of_emission =
        sampled(channels, *textures.emission, *draw.emission_sampler, points.emission);
  }
}

// Whether the stored bytes are linear light, in all three colour channels.
inline bool stores_linear_light(const ResolveJob& job) {
  return job.transfer == Transfer::kNone && job.channels.r && job.channels.g && job.channels.b;
}

// Shades vectors of textured pixels. A single vector would wait for gathers and divisions, one
// after the other, for as long as all its other work takes; and its computation has more
// instructions than the processor looks ahead. So each step is done for several vectors in turn:
// while one waits, the next ones are computed.
template <class Channels, class Source, class SourceOf>
HWY_INLINE void shade_in_steps(const ShadeDraw& draw, const DrawTextures& textures,
                               const ResolveJob& job, std::size_t count, const SourceOf& source_of,
                               Ints* colors) {
  typename Source::Fragments fragments[kBlockVectors];
  TexturePoints points[kBlockVectors];
  SampledTexels<Channels> texels[kBlockVectors];
  const Channels channels(job);
  for (std::size_t i = 0; i < count; ++i) {
    const Source source = source_of(i);
    fragments[i] = source.fragments();
    find_texture_points(draw, textures, source, points[i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    find_texels(channels, draw, textures, points[i], texels[i]);
  }
  if constexpr (Channels::kHasAlpha) {
    using Fragment = FragmentInLanes<Channels, typename Source::Fragments, SampledTexels<Channels>>;
    const Fragment any{{}, channels, draw, textures, job.lighting, fragments[0], texels[0]};
    if (stores_linear_light(job) && is_texel_alone(any)) {
      for (std::size_t i = 0; i < count; ++i) {
        colors[i] = linear_bytes_of(texels[i].color()) | std::int32_t(0xff000000u);
      }
      return;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    colors[i] =
        encoded(shaded_surface<Channels>(draw, textures, job, fragments[i], texels[i]).color, job);
  }
}

// Computes the colours of `count` vectors, at most kBlockVectors; source_of(i) makes the source of
// vector i. Vectors without textures wait less, so they are not shaded in steps, which would cost
// more time than they save.
template <class Channels, class Source, class SourceOf>
HWY_INLINE void shade_vectors(const ShadeDraw& draw, const DrawTextures& textures,
                              const ResolveJob& job, std::size_t count, const SourceOf& source_of,
                              Ints* colors) {
  if (textures.color != nullptr || textures.emission != nullptr) {
    return shade_in_steps<Channels, Source>(draw, textures, job, count, source_of, colors);
  }
  for (std::size_t i = 0; i < count; ++i) {
    colors[i] = encoded(shaded_color_by_call<Channels>(draw, textures, job, source_of(i)), job);
  }
}

template <class Channels, class Source>
HWY_INLINE Ints shade(const ShadeDraw& draw, const DrawTextures& textures, const ResolveJob& job,
                      const Source& source) {
  return encoded(shaded_surface<Channels>(draw, textures, job, source).color, job);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
