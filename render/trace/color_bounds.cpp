#include <glassbox/render/trace/color_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/raster/color_bounds.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox {
namespace {

using bounded::Bounded;
using bounded::BoundedOf;
using bounded::with_bound_from;
using Bounded3 = std::array<Bounded, 3>;

// ---- fragments ----

// Returns weights 1 and 2 with their bounds. Bound 5 of SPEC C uses for every weight the largest
// relative error of the three 1/w. That is too much if one corner is next to the eye: its 1/w has a
// large error, but the corner has hardly any weight in most of the triangle. So let w_k be the
// exact weights for the computed 1/w. The exact 1/w are (1 + e_k) times the computed ones, with
// |e_k| <= r_k. Then
//   |w_k (1 + e_k)/(1 + sum w_j e_j) - w_k| <= w_k (r_k + s)/(1 - s),   s = sum w_j r_j
// In addition, the run's weights have a rounding error of 10 u (formulas/interpolate.h), or 4 u
// where perspective changes nothing (u is the unit roundoff, 2^-24).
std::array<Bounded, 2> weights_of(const TriangleSetup& setup, const SetupBounds& vertices,
                                  const Fragment& place, const FragmentBounds& bounds) {
  constexpr double kOwn = 10 * 0x1p-24 * (1 + 0x1p-18);
  std::array<double, 3> r{};
  double s = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    r[k] = vertices.inverse_w[k] / std::abs(double(setup.inverse_w[k]));
    s += bounded::times(double(place.weights[k]) * (1 + kOwn), r[k]);
  }
  std::array<Bounded, 2> weights;
  for (std::size_t k = 1; k < 3; ++k) {
    const double weight = double(place.weights[k]);
    const double inherited = s < 1 ? bounded::times(weight * (1 + kOwn), r[k] + s) / (1 - s)
                                   : std::numeric_limits<double>::infinity();
    weights[k - 1] = {place.weights[k],
                      std::min(bounds.weights[k], (inherited + kOwn * weight) * bounded::kRoundUp)};
  }
  return weights;
}

template <std::size_t N>
void set_run_values(const std::array<float, N>& values, std::array<Bounded, N>& same) {
  for (std::size_t i = 0; i < N; ++i) same[i] = with_bound_from(values[i], same[i]);
}

void set_run_values(const Varyings& run, BoundedVaryings& same) {
  set_run_values(run.normal, same.normal);
  set_run_values(run.position, same.position);
  set_run_values(run.diffuse, same.diffuse);
  set_run_values(run.specular, same.specular);
  set_run_values(run.color, same.color);
  set_run_values(run.texcoord, same.texcoord);
}

}  // namespace

// A fragment whose numbers have error bounds (base/bounded.h), with the members that
// formulas/surface.h needs.
struct PieceColors::BoundedFragment : bounded::UnobservedFragment {
  using Float = Bounded;
  static constexpr std::size_t kChannels = 3;

  const PieceColors& piece;
  const TracedFragment& fragment;
  const BoundedVaryings& at;
  Bounded inverse_w;
  std::optional<double>& bound_of_sample;

  static constexpr std::size_t first_channel() { return 0; }
  template <class T>
  static const std::array<T, 3>& wanted(const std::array<T, 3>& three) {
    return three;
  }
  bounded::SurfaceColorOf<Bounded> look_up(const LazyMipChain& texture,
                                           const Sampler& sampler) const {
    const auto [r, g, b, a] = piece.sample(texture.get(), sampler, fragment, at, inverse_w);
    return {{r, g, b}, a};
  }

  const Material& material() const { return *piece.draw_.material; }
  static constexpr bool has_vertex_color() { return true; }  // it is white if the mesh has none
  bounded::SurfaceColorOf<Bounded> vertex_color() const {
    return {{at.color[0], at.color[1], at.color[2]}, at.color[3]};
  }
  bool has_texture() const { return piece.draw_.texture != nullptr; }
  bounded::SurfaceColorOf<Bounded> texel() const {
    const auto texel = look_up(*piece.draw_.texture, *piece.draw_.sampler);
    bound_of_sample = texel.color[0].bound;
    return texel;
  }

  bool is_lit() const { return needs_normals(piece.draw_, piece.settings_); }
  const Lighting& lighting() const { return piece.lighting_; }
  static constexpr bool has_highlights() { return true; }
  const Bounded3& normal() const { return at.normal; }
  const Bounded3& position() const { return at.position; }
  bool is_lit_at_vertices() const { return piece.settings_.shading != Shading::kPhong; }
  ReflectionOf<Bounded> light_of_vertices() const { return {at.diffuse, at.specular}; }

  bool emits() const { return piece.draw_.emits() && shows_light(piece.draw_, piece.settings_); }
  const std::array<float, 3>& emission() const { return piece.draw_.emission; }
  bool has_emission_texture() const { return piece.draw_.emission_texture != nullptr; }
  Bounded3 emission_texel() const {
    return look_up(*piece.draw_.emission_texture, *piece.draw_.emission_sampler).color;
  }
};

PieceColors::PieceColors(const Draw& draw, const DrawBounds& draw_bounds, const Lighting& lighting,
                         const RenderSettings& settings, const BoundsOfRun::KnownTriangle& known,
                         std::uint32_t piece)
    : draw_(draw),
      lighting_(lighting),
      settings_(settings),
      setup_(*known.triangle->pieces[piece].setup),
      setup_bounds_(setup_bounds(known.triangle->pieces[piece], known.bounds)) {
  const TracedTriangle& triangle = *known.triangle;
  const CornerStage stage{draw, draw_bounds, lighting, settings};
  std::array<BoundedVaryings, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] =
        face_corner_attributes(stage, triangle.face, draw.mesh->corners[triangle.corners[k].corner],
                               triangle.pieces[piece].front);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t at = triangle.pieces[piece].polygon[std::size_t(setup_.order[k])];
    vertices_[k] = at_vertex(corners, triangle.polygon[at].clip, known.bounds.polygon[at].clip);
  }
  if (draw.texture != nullptr || draw.emission_texture != nullptr) make_planes();
}

PieceColors::PieceColors(const Draw& draw, const Lighting& lighting, const RenderSettings& settings,
                         const TriangleSetup& setup, const SetupBounds& setup_bounds,
                         const std::array<BoundedVaryings, 3>& vertices)
    : draw_(draw),
      lighting_(lighting),
      settings_(settings),
      setup_(setup),
      setup_bounds_(setup_bounds),
      vertices_(vertices) {}

void PieceColors::make_planes() {
  has_slopes_ = true;
  std::array<std::array<Bounded, 2>, 3> texcoords;
  std::array<std::array<float, 2>, 3> values;
  std::array<Bounded3, 2> slopes;
  const double area = double(setup_.double_area);
  const Bounded inverse_area(setup_.inverse_area,
                             std::abs(double(setup_.inverse_area) - 1 / area) + 0x1p-52 / area);
  for (std::size_t k = 0; k < 3; ++k) {
    texcoords[k] = vertices_[k].texcoord;
    values[k] = {texcoords[k][0].value, texcoords[k][1].value};
    const Bounded inverse_w(setup_.inverse_w[k], setup_bounds_.inverse_w[k]);
    const auto slope = [&](std::int64_t step) {
      return bounded::slope_over_w(bounded::to_float(step * kSubpixels), inverse_area, inverse_w);
    };
    slopes[0][k] = slope(setup_.edges[k].a);
    slopes[1][k] = slope(setup_.edges[k].b);
  }
  planes_ = texture_planes(setup_, values);
  bounded_planes_ = bounded::planes_over_w(slopes, texcoords, false);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    // If the three computed w are equal, the run uses the slope 0 for 1/w; the exact w may differ.
    bounded_planes_.inverse_w[axis] =
        with_bound_from(planes_.inverse_w[axis], bounded_planes_.inverse_w[axis]);
  }
}

std::array<Bounded, 4> PieceColors::sample(const MipChain& texture, const Sampler& sampler,
                                           const TracedFragment& fragment,
                                           const BoundedVaryings& at,
                                           const Bounded& inverse_w) const {
  float level = 0;
  LevelBounds levels;
  if (has_slopes_) {
    level = level_of_detail(
        texture_gradient(planes_, fragment.at.texcoord, fragment.fragment.inverse_w), texture.width,
        texture.height);
    const auto gradient = bounded::gradient_at(bounded_planes_, at.texcoord, inverse_w);
    levels = level_bounds(
        level, bounded::greatest(
                   bounded::squared_texels(gradient.along_x, texture.width, texture.height),
                   bounded::squared_texels(gradient.along_y, texture.width, texture.height)));
  }
  const Rgba texel = glassbox::sample_mip_chain(texture, sampler, fragment.at.texcoord, level);
  const double bound = sample_bound(texture, sampler, settings_.transfer, at.texcoord, levels);
  return {Bounded(texel.r, bound), Bounded(texel.g, bound), Bounded(texel.b, bound),
          Bounded(texel.a, bound)};
}

ColorBounds PieceColors::at(const TracedFragment& fragment, const FragmentBounds& bounds) const {
  const Fragment& place = fragment.fragment;
  const Bounded inverse_w(place.inverse_w, bounds.inverse_w);
  const auto [weight1, weight2] = weights_of(setup_, setup_bounds_, place, bounds);
  ColorBounds colors;
  colors.at =
      combine(vertices_, [w1 = weight1, w2 = weight2](const auto& a, const auto& b, const auto& c) {
        return bounded::interpolate(a, b, c, w1, w2);
      });
  set_run_values(fragment.at, colors.at);
  const BoundedFragment asked{{}, *this, fragment, colors.at, inverse_w, colors.sample};
  auto surface = bounded::surface_color(asked);
  const Rgba& run = fragment.surface;
  set_run_values({run.r, run.g, run.b}, surface.color);
  surface.alpha = with_bound_from(run.a, surface.alpha);
  colors.surface = {surface.color[0], surface.color[1], surface.color[2], surface.alpha};
  colors.light = bounded::shaded_color(asked, surface.color);
  set_run_values({fragment.light.r, fragment.light.g, fragment.light.b}, colors.light);
  return colors;
}

}  // namespace glassbox
