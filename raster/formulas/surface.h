// The colour of a surface, from its parts: material, vertex colour and texture; alpha mask; light;
// emission. It is defined only here: new kinds of material are added here, and so are new stages
// between texture and blend. The formulas of a single part are in files of their own:
#include <glassbox/raster/formulas/lighting.h>

// The functions get their inputs from a fragment, `at`. Each place that computes colours has its
// own class of fragments:
//   StagedFragment   single numbers        render/staged/fragment_color.h
//   FragmentInLanes  vectors of numbers    raster/lanes/shade-inl.h
//   BoundedFragment  numbers with bounds   render/trace/color_bounds.cpp
//   RayFragment      where a ray hits      views/layers/ray_surfaces.cpp
// Each class has these members:
//   Float                                  the type of its numbers
//   kChannels, first_channel()             how many colour channels are computed, and the first one
//   wanted()                               picks these channels from all three
//   material()                             the surface's material
//   has_vertex_color(), vertex_color()
//   has_texture(), texel()                 the texture's colour at the fragment
//   is_lit(), lighting(), has_highlights()
//   normal(), position()                   in eye space
//   is_lit_at_vertices(), light_of_vertices()
//   emits(), emission()                    the emitted light, where the emission texture is 1
//   has_emission_texture(), emission_texel()
// Members whose result the surface does not need are not called.

// The base class of fragments. An observer can change the emitted light in emitted(). In this class
// emitted() does nothing; the fragments of an observer define their own.
struct UnobservedFragment {
  template <class Light>
  void emitted(Light& /*own*/) const {}
};

// A colour in linear light, with alpha. Alpha is not used where only some of the channels are
// computed.
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

// Whether the colour is that of the texture, unchanged.
template <class Fragment>
inline bool is_texel_alone(const Fragment& at) {
  const Rgba& base = at.material().base_color;
  return at.has_texture() && !at.has_vertex_color() && base.r == 1 && base.g == 1 && base.b == 1 &&
         !at.is_lit() && !at.emits();
}

// For a material with an alpha mask: whether the fragment is kept. A fragment whose alpha is NaN is
// not kept.
template <Number F>
inline auto reaches_cutoff(F alpha, const Material& material) {
  return alpha >= F(material.alpha_cutoff);
}

// The light at the fragment, before it is multiplied by the surface's colours.
template <class Fragment, class Normal>
inline auto light_at(const Fragment& at, const Normal& normal) {
  if (at.is_lit_at_vertices()) return at.light_of_vertices();
  return reflected_light<Fragment::kChannels>(at.lighting(), at.position(), normal,
                                              at.material().shininess, at.has_highlights(),
                                              at.first_channel());
}

// The surface's colour after lighting.
template <class Fragment, class Color>
inline Color lit_color(const Fragment& at, const Color& surface) {
  if (!at.is_lit()) return surface;
  const auto normal = at.normal();
  return reflected_color(surface, normal, light_at(at, normal), at.wanted(at.material().specular),
                         at.has_highlights());
}

// The light that the surface emits: its emission times the emission texture.
template <class Fragment>
inline auto emitted_light(const Fragment& at) {
  using F = typename Fragment::Float;
  const std::array<float, 3>& whole = at.emission();
  auto own = at.wanted(std::array<F, 3>{F(whole[0]), F(whole[1]), F(whole[2])});
  if (at.has_emission_texture()) own = product(own, at.emission_texel());
  return own;
}

// The surface's colour after lighting, with its emission added.
template <class Fragment, class Color>
inline Color shaded_color(const Fragment& at, const Color& surface) {
  Color color = lit_color(at, surface);
  if (at.emits()) {
    auto own = emitted_light(at);
    at.emitted(own);
    color = sum(color, own);
  }
  return color;
}
