#include "views/layers/ray_surfaces.h"

#include <Eigen/Geometry>

#include <glassbox/raster/blend.h>
#include <glassbox/raster/light_formulas.h>

namespace glassbox::views {

namespace {

// Interpolates a property of the corners. `of` returns the property of a corner as an array.
template <std::size_t N, class Of>
std::array<float, N> mean_of(const RayHit& hit, const Draw& draw, const Triangle& triangle,
                             const Of& of) {
  std::array<double, N> sum{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<float, N> here = of(draw.mesh->corners[triangle.corners[k]]);
    for (std::size_t i = 0; i < N; ++i) sum[i] += hit.weights[k] * double(here[i]);
  }
  std::array<float, N> mean;
  for (std::size_t i = 0; i < N; ++i) mean[i] = float(sum[i]);
  return mean;
}

std::array<float, 2> texcoord_of(const Mesh& mesh, const Corner& corner) {
  if (corner.texcoord == kNone) return {0, 0};
  return {mesh.texcoords[corner.texcoord].u, mesh.texcoords[corner.texcoord].v};
}

std::array<float, 2> texcoord_at(const RayHit& hit, const Draw& draw, const Triangle& triangle) {
  return mean_of<2>(hit, draw, triangle,
                    [&](const Corner& corner) { return texcoord_of(*draw.mesh, corner); });
}

}  // namespace

std::vector<TriangleCorners> RaySurfaces::corners_of(const DrawList& list,
                                                     std::vector<TriangleReference>& references) {
  std::vector<TriangleCorners> all;
  for (std::uint32_t d = 0; d < list.draws.size(); ++d) {
    const Draw& draw = list.draws[d];
    const std::vector<Triangle>& triangles = draw.triangulation->triangles;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      TriangleCorners corners;
      bool finite = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point<Object>& p =
            draw.mesh->positions[draw.mesh->corners[triangles[i].corners[k]].position];
        const Point<Eye, double> eye = draw.eye_from_object * Point<Object, double>(p.x, p.y, p.z);
        corners[k] = {eye.x, eye.y, eye.z};
        // A triangle with such a corner is left out; a rasterizer would not draw it either.
        finite = finite && corners[k].cwiseAbs().maxCoeff() < kFarthest;
      }
      if (!finite) continue;
      all.push_back(corners);
      references.push_back({d, i});
    }
  }
  return all;
}

RaySurfaces::RaySurfaces(const Scene& scene, const View& view, const RenderSettings& settings)
    : view_(view),
      settings_(settings),
      prepared_(prepare_scene(scene, settings.transfer)),
      list_(make_draw_list(scene, prepared_, view)),
      caster_(corners_of(list_, triangle_references_)) {
  for (const Draw& draw : list_.draws) tables_.push_back(make_eye_space_tables(draw, settings_));
}

// The mip level at which a texel is as large as a pixel of the view, measured on the surface. The
// ray with direction r meets the surface's plane, n . P = c, at the point P = r c / (n . r). When r
// moves by one pixel, P moves by the derivative of this. From that movement follow the changes of
// the corners' weights and of the texture coordinates.
float RaySurfaces::detail_at(const MipChain& texture, const RayHit& hit, const Draw& draw,
                             const Triangle& triangle) const {
  const TriangleCorners& corners = caster_.corners(hit.triangle);
  const Eigen::Vector3d a = corners[1] - corners[0], b = corners[2] - corners[0];
  const Eigen::Vector3d normal = a.cross(b), at = caster_.hit_point(hit);
  std::array<std::array<float, 2>, 3> uv;
  for (std::size_t k = 0; k < 3; ++k)
    uv[k] = texcoord_of(*draw.mesh, draw.mesh->corners[triangle.corners[k]]);
  // The size of a pixel at distance 1, in x and y.
  const std::array<double, 2> pixel{
      2 / (double(view_.viewport.width()) * view_.clip_from_eye.at(0, 0)),
      2 / (double(view_.viewport.height()) * view_.clip_from_eye.at(1, 1))};
  TextureGradient gradient;
  for (int axis = 0; axis < 2; ++axis) {
    const double step = -at.z() * pixel[std::size_t(axis)];
    const Eigen::Vector3d moved =
        step * (Eigen::Vector3d::Unit(axis) - at * (normal[axis] / normal.dot(at)));
    const double second = normal.dot(moved.cross(b)) / normal.squaredNorm(),
                 third = normal.dot(a.cross(moved)) / normal.squaredNorm();
    auto& along = axis == 0 ? gradient.along_x : gradient.along_y;
    for (std::size_t i = 0; i < 2; ++i) {
      along[i] = float(second * (double(uv[1][i]) - double(uv[0][i])) +
                       third * (double(uv[2][i]) - double(uv[0][i])));
    }
  }
  return level_of_detail(gradient, texture.width, texture.height);
}

Rgba RaySurfaces::texel_at(const LazyMipChain& texture, const Sampler& sampler,
                           const RayHit& hit) const {
  const Draw& draw = list_.draws[triangle_references_[hit.triangle].draw];
  const Triangle& triangle =
      draw.triangulation->triangles[triangle_references_[hit.triangle].triangle];
  const MipChain& chain = texture.get();
  const float detail = samples_base_only(sampler) ? 0 : detail_at(chain, hit, draw, triangle);
  return sample_mip_chain(chain, sampler, texcoord_at(hit, draw, triangle), detail);
}

// The normal in eye space, on the side from which the ray came.
std::array<float, 3> RaySurfaces::normal_at(const RayHit& hit) const {
  const TriangleReference& place = triangle_references_[hit.triangle];
  const Draw& draw = list_.draws[place.draw];
  const EyeSpaceTables& tables = tables_[place.draw];
  const Triangle& triangle = draw.triangulation->triangles[place.triangle];
  const float sign = hit.front == draw.mirrored ? -1.0f : 1.0f;
  return mean_of<3>(hit, draw, triangle, [&](const Corner& corner) {
    const Normal<Eye>& n =
        corner.normal == kNone ? tables.face_normals[triangle.face] : tables.normals[corner.normal];
    return std::array<float, 3>{sign * n.x, sign * n.y, sign * n.z};
  });
}

// The fragment where a ray hits, with the members that formulas/surface.h needs.
struct RaySurfaces::RayFragment : UnobservedFragment {
  using Float = float;
  static constexpr std::size_t kChannels = 3;

  const RaySurfaces& surfaces;
  const RayHit& hit;
  const Draw& draw;
  const Triangle& triangle;

  RayFragment(const RaySurfaces& of, const RayHit& at)
      : surfaces(of),
        hit(at),
        draw(of.list_.draws[of.triangle_references_[at.triangle].draw]),
        triangle(draw.triangulation->triangles[of.triangle_references_[at.triangle].triangle]) {}

  static constexpr std::size_t first_channel() { return 0; }
  template <class T>
  static const std::array<T, 3>& wanted(const std::array<T, 3>& three) {
    return three;
  }
  SurfaceColorOf<float> look_up(const LazyMipChain& texture, const Sampler& sampler) const {
    const auto [r, g, b, a] = surfaces.texel_at(texture, sampler, hit);
    return {{r, g, b}, a};
  }

  const Material& material() const { return *draw.material; }
  bool has_vertex_color() const { return !draw.mesh->colors.empty(); }
  SurfaceColorOf<float> vertex_color() const {
    const auto [r, g, b, a] = mean_of<4>(hit, draw, triangle, [&](const Corner& corner) {
      const Rgba c = corner.color == kNone ? Rgba() : draw.mesh->colors[corner.color];
      return std::array<float, 4>{c.r, c.g, c.b, c.a};
    });
    return {{r, g, b}, a};
  }
  bool has_texture() const { return draw.texture != nullptr; }
  SurfaceColorOf<float> texel() const { return look_up(*draw.texture, *draw.sampler); }

  bool is_lit() const { return needs_normals(draw, surfaces.settings_); }
  const Lighting& lighting() const { return surfaces.list_.lighting; }
  static constexpr bool has_highlights() { return true; }
  std::array<float, 3> normal() const { return surfaces.normal_at(hit); }
  std::array<float, 3> position() const {
    const Eigen::Vector3f at = surfaces.caster_.hit_point(hit).cast<float>();
    return {at.x(), at.y(), at.z()};
  }
  static constexpr bool is_lit_at_vertices() { return false; }
  static Reflection light_of_vertices() { return {}; }

  bool emits() const { return draw.emits() && shows_light(draw, surfaces.settings_); }
  const std::array<float, 3>& emission() const { return draw.emission; }
  bool has_emission_texture() const { return draw.emission_texture != nullptr; }
  std::array<float, 3> emission_texel() const {
    return look_up(*draw.emission_texture, *draw.emission_sampler).color;
  }
};

std::uint32_t RaySurfaces::number(const RayHit& hit) const {
  const TriangleReference& place = triangle_references_[hit.triangle];
  const Draw& draw = list_.draws[place.draw];
  return 1 + draw.first_number + draw.triangulation->triangles[place.triangle].number;
}

bool RaySurfaces::is_drawn_at(const RayHit& hit) const {
  const Draw& draw = list_.draws[triangle_references_[hit.triangle].draw];
  // A mirroring matrix reverses the winding, and exchanges inside and outside.
  if (is_culled(draw, settings_.cull, hit.front != draw.mirrored)) return false;
  const Material& material = *draw.material;
  return material.alpha_mode != AlphaMode::kMask ||
         reaches_cutoff(surface_color(RayFragment(*this, hit)).alpha, material);
}

Rgba8 RaySurfaces::color(const RayHit& hit) const {
  const RayFragment at(*this, hit);
  const auto [r, g, b] = shaded_color(at, surface_color(at).color);
  Rgba8 stored = settings_.background;
  write_masked(settings_.mask, encode(settings_.transfer, Rgba{r, g, b, 1}), stored);
  return stored;
}

}  // namespace glassbox::views
