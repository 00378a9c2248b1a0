// What a surface's colour is made of: material, vertex colour, texture; mask; light; emission. No one
// else says so: a material of another kind has its place here, and so has a stage between texture
// and blend. Formulas of one part are in files of their own:
#include <glassbox/raster/formulas/lighting.h>

// The functions ask a fragment, `at`, for what they need. Wherever colours are made it is a class:
//   StagedFragment   single numbers        render/staged/fragment_color.h
//   FragmentInLanes  as many as fit        raster/lanes/shade-inl.h
//   BoundedFragment  numbers with bounds   render/trace/color_bounds.cpp
//   RayFragment      where a ray arrives   views/layers/ray_surfaces.cpp
// Each has
//   Float                                  its numbers
//   kChannels, first_channel(), wanted()   how many channels of light are computed, from which on
//   material()                             all that the surface has everywhere
//   has_vertex_color(), vertex_color()
//   has_texture(), texel()                 what the texture has there
//   is_lit(), lighting(), has_highlights()
//   normal(), position()                   in eye space
//   is_lit_at_vertices(), light_of_vertices()
//   emits(), emission()                    a light of its own, where the surface is wholly bright
//   has_emission_texture(), emission_texel()
// and is asked for no number that the surface does not need.

// What watchers hear of, and may change: nothing. Fragments that are watched say otherwise.
struct UnwatchedFragment {
  template <class Light>
  void emitted(Light& /*own*/) const {}
};

// A colour in linear light, with alpha. Where not all channels are wanted, nobody asks for alpha.
template <class F, std::size_t kChannels = 3>
struct SurfaceColorOf {
  std::array<F, kChannels> color;
  F alpha;
};

template <class F, std::size_t kChannels>
inline SurfaceColorOf<F, kChannels> product(const SurfaceColorOf<F, kChannels>& a,
                                            const SurfaceColorOf<F, kChannels>& b) {
  return {product(a.color, b.color), a.alpha * b.alpha};
}

// The surface's own colour: material times vertex colour times texture.
template <class Fragment>
inline auto surface_color(const Fragment& at) {
  using F = typename Fragment::Float;
  const Rgba& base = at.material().base_color;
  SurfaceColorOf<F, Fragment::kChannels> surface{
      at.wanted(std::array<F, 3>{F(base.r), F(base.g), F(base.b)}), F(base.a)};
  if (at.has_vertex_color()) surface = product(surface, at.vertex_color());
  if (at.has_texture()) surface = product(surface, at.texel());
  return surface;
}

// Nothing but the texture has a part in what is seen.
template <class Fragment>
inline bool is_texel_alone(const Fragment& at) {
  const Rgba& base = at.material().base_color;
  return at.has_texture() && !at.has_vertex_color() && base.r == 1 && base.g == 1 && base.b == 1 &&
         !at.is_lit() && !at.emits();
}

// Of a material with a mask: whether the surface is there. Where alpha is no number it is not.
template <Number F>
inline auto reaches_cutoff(F alpha, const Material& material) {
  return alpha >= F(material.alpha_cutoff);
}

// The light at the fragment, before the surface's colours are multiplied in.
template <class Fragment, class Normal>
inline auto light_at(const Fragment& at, const Normal& normal) {
  if (at.is_lit_at_vertices()) return at.light_of_vertices();
  return reflected_light<Fragment::kChannels>(at.lighting(), at.position(), normal,
                                              at.material().shininess, at.has_highlights(),
                                              at.first_channel());
}

// The surface in the light.
template <class Fragment, class Color>
inline Color in_light(const Fragment& at, const Color& surface) {
  if (!at.is_lit()) return surface;
  const auto normal = at.normal();
  return lit(surface, normal, light_at(at, normal), at.wanted(at.material().specular),
             at.has_highlights());
}

// The light that the surface emits: its emission times the emission texture.
template <class Fragment>
inline auto own_light(const Fragment& at) {
  using F = typename Fragment::Float;
  const std::array<float, 3>& whole = at.emission();
  auto own = at.wanted(std::array<F, 3>{F(whole[0]), F(whole[1]), F(whole[2])});
  if (at.has_emission_texture()) own = product(own, at.emission_texel());
  return own;
}

// The surface's colour after lighting, with its emission added.
template <class Fragment, class Color>
inline Color shining(const Fragment& at, const Color& surface) {
  Color color = in_light(at, surface);
  if (at.emits()) {
    auto own = own_light(at);
    at.emitted(own);
    color = sum(color, own);
  }
  return color;
}
