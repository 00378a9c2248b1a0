#include <glassbox/render/fragments.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <glassbox/raster/blend.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/raster/line.h>
#include <glassbox/raster/point.h>
#include <glassbox/raster/snap.h>
#include <glassbox/render/distance.h>

namespace glassbox {

namespace {

// ---- colour ----

bool has_normal(const std::array<float, 3>& n) {
  return n[0] != 0 || n[1] != 0 || n[2] != 0;
}

// Base colour: material times vertex colour times texture.
Rgba surface_color(const FragmentStage& stage, const Varyings& at, float detail) {
  const Rgba& base = stage.draw.material->base_color;
  Rgba color{base.r * at.color[0], base.g * at.color[1], base.b * at.color[2],
             base.a * at.color[3]};
  if (stage.draw.texture != nullptr) {
    const Rgba texel = sample(*stage.draw.texture, *stage.draw.sampler, at.texcoord, detail,
                              stage.settings.transfer, stage.channels);
    color = {color.r * texel.r, color.g * texel.g, color.b * texel.b, color.a * texel.a};
  }
  return color;
}

Rgba lit(const FragmentStage& stage, const Rgba& base, const Varyings& at) {
  const Material& material = *stage.draw.material;
  // Lines and points without normals shine by themselves (glTF 2.0, 3.7.2.1).
  if (!needs_normals(stage.draw, stage.settings) || !has_normal(at.normal)) return base;
  const Reflection light =
      stage.settings.shading == Shading::kPhong
          ? illuminate(stage.lighting, at.position, at.normal, material.shininess)
          : Reflection{at.diffuse, at.specular};
  return {base.r * light.diffuse[0] + material.specular[0] * light.specular[0],
          base.g * light.diffuse[1] + material.specular[1] * light.specular[1],
          base.b * light.diffuse[2] + material.specular[2] * light.specular[2], base.a};
}

// A direction as a colour: each component from [-1, 1] to [0, 255].
Rgba8 picture_of_normal(const std::array<float, 3>& n) {
  const float squared = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
  const float scale = squared > 0.0f ? 0.5f / std::sqrt(squared) : 0.0f;
  return {encode_unorm8(n[0] * scale + 0.5f), encode_unorm8(n[1] * scale + 0.5f),
          encode_unorm8(n[2] * scale + 0.5f), 255};
}

// Texture coordinates modulo 1 as red and green.
Rgba8 picture_of_texcoord(const std::array<float, 2>& t) {
  return {encode_unorm8(t[0] - std::floor(t[0])), encode_unorm8(t[1] - std::floor(t[1])), 0, 255};
}

// ---- one fragment ----

void write(const FragmentStage& stage, const Fragment& fragment, std::uint32_t code,
           std::uint32_t id, const Rgba8& color, bool writes_depth) {
  Framebuffer& target = stage.target;
  const std::size_t pixel = target.depth.index(fragment.x, fragment.y);
  write_masked(stage.settings.mask, color, stage.color.pixels[pixel]);
  if (writes_depth) target.depth.pixels[pixel] = code;
  if (!target.distance.pixels.empty()) {
    target.distance.pixels[pixel] =
        distance_along_gaze(stage.view, fragment.depth, fragment.inverse_w);
  }
  if (!target.id.pixels.empty()) target.id.pixels[pixel] = id;
  if (!target.writes.pixels.empty()) ++target.writes.pixels[pixel];
  ++stage.statistics.written;
}

bool passes_depth_test(const FragmentStage& stage, const FragmentSource& source,
                       const Fragment& fragment, std::uint32_t code) {
  const std::size_t pixel = stage.target.depth.index(fragment.x, fragment.y);
  const std::uint32_t stored = stage.target.depth.pixels[pixel];
  bool passes = in_front(code, stored);
  if (stage.observer != nullptr) {
    stage.observer->compared(source, fragment, code, stored, passes);
  }
  return passes;
}

// What the pixel shows of a fragment: its light, or the quantity asked for in its place.
Rgba8 encoded(const FragmentStage& stage, const Varyings& at, const Rgba& surface,
              const Rgba8& before) {
  if (stage.settings.show == Show::kNormal) return picture_of_normal(at.normal);
  if (stage.settings.show == Show::kUv) return picture_of_texcoord(at.texcoord);
  Rgba color = lit(stage, surface, at);
  if (stage.observer != nullptr) stage.observer->lit(at, surface, color);
  if (stage.draw.material->alpha_mode == AlphaMode::kBlend) {
    color.a = std::clamp(color.a, 0.0f, 1.0f);  // vertex colours may exceed 1
    return blend_over(stage.settings.transfer, color, before, stage.channels);
  }
  color.a = 1.0f;
  return encode(stage.settings.transfer, color, stage.channels);
}

bool is_discarded(const Material& material, const Rgba& surface) {
  return material.alpha_mode == AlphaMode::kMask && !(surface.a >= material.alpha_cutoff);
}

// Pictures of normals and texture coordinates are opaque.
bool is_blended(const FragmentStage& stage) {
  return stage.draw.material->alpha_mode == AlphaMode::kBlend &&
         stage.settings.show != Show::kNormal && stage.settings.show != Show::kUv;
}

// What a primitive brings for each of its fragments.
struct Surface {
  std::array<Varyings, 3> vertices;      // interpolated with Fragment::weights
  std::optional<TexturePlanes> texture;  // of textured triangles
};

// Base-2 level of the mip chain that suits the fragment; 0 for lines and points.
float detail_at(const FragmentStage& stage, const Surface& surface, const Varyings& at,
                const Fragment& fragment) {
  if (!surface.texture) return 0.0f;
  const Image<Rgba8>& image = stage.draw.texture->levels.front();
  return level_of_detail(texture_gradient(*surface.texture, at.texcoord, fragment.inverse_w),
                         image.width, image.height);
}

// The way of a covered pixel through the last stages.
Fate process(const FragmentStage& stage, const FragmentSource& source, const Fragment& fragment,
             std::uint32_t id, const Surface& surface) {
  ++stage.statistics.covered;
  const std::uint32_t code = depth_code(stage.settings.depth, fragment.depth);
  if (!passes_depth_test(stage, source, fragment, code)) {
    ++stage.statistics.depth_failed;
    return Fate::kHidden;
  }
  const Varyings at = interpolate(surface.vertices, fragment.weights);
  Rgba base = surface_color(stage, at, detail_at(stage, surface, at, fragment));
  if (stage.observer != nullptr) stage.observer->textured(at, base);
  if (is_discarded(*stage.draw.material, base)) {
    ++stage.statistics.discarded;
    return Fate::kDiscarded;
  }
  const std::size_t pixel = stage.target.depth.index(fragment.x, fragment.y);
  const Rgba8 before = stage.color.pixels[pixel];
  Rgba8 after = encoded(stage, at, base, before);
  if (stage.observer != nullptr) stage.observer->encoded(fragment, before, after);
  const bool blended = is_blended(stage);
  if (blended) ++stage.statistics.blended;
  write(stage, fragment, code, id, after, !blended);
  return blended ? Fate::kBlended : Fate::kWritten;
}

void process_observed(const FragmentStage& stage, const FragmentSource& source,
                      const Fragment& fragment, std::uint32_t id, const Surface& surface) {
  const Fate fate = process(stage, source, fragment, id, surface);
  if (stage.observer != nullptr) stage.observer->ended(source, fragment, fate);
}

constexpr FragmentSource kNoTriangle{0, 0, false};

}  // namespace

ColorMask shaded_channels(const Draw& draw, const RenderSettings& settings) {
  ColorMask channels = settings.mask;
  channels.a = channels.a || draw.material->alpha_mode != AlphaMode::kOpaque;
  return channels;
}

void rasterise(const FragmentStage& stage, const ReadyTriangle& triangle) {
  Surface surface{triangle.vertices, {}};
  if (stage.draw.texture != nullptr) {
    surface.texture = texture_planes(triangle.setup,
                                     {triangle.vertices[0].texcoord, triangle.vertices[1].texcoord,
                                      triangle.vertices[2].texcoord});
  }
  const FragmentSource source{triangle.number, triangle.piece, true};
  for_each_covered(triangle.setup, stage.window, [&](const Coverage& pixel) {
    Fragment fragment = interpolate(triangle.setup, pixel);
    if (stage.observer != nullptr) stage.observer->interpolated(source, pixel, fragment);
    process_observed(stage, source, fragment, triangle.number + 1, surface);
  });
}

void rasterise(const FragmentStage& stage, const ReadyLine& line) {
  const Surface surface{{line.vertices[0], line.vertices[0], line.vertices[1]}, {}};
  for_each_line_pixel(snap(line.ends[0]), snap(line.ends[1]), stage.window,
                      [&](const LinePixel& pixel) {
                        const Fragment fragment = interpolate(line.ends, pixel);
                        process_observed(stage, kNoTriangle, fragment, line.id, surface);
                      });
}

void rasterise(const FragmentStage& stage, const ReadyPoint& point) {
  const PointPixel pixel = point_pixel(snap(point.position));
  const PixelRect& window = stage.window;
  if (pixel.x < window.x0 || pixel.x >= window.x1 || pixel.y < window.y0 || pixel.y >= window.y1)
    return;
  Fragment fragment;
  fragment.x = pixel.x;
  fragment.y = pixel.y;
  fragment.depth = point.position.position.z;
  fragment.inverse_w = point.position.inverse_w;
  const Surface surface{{point.vertex, point.vertex, point.vertex}, {}};
  process_observed(stage, kNoTriangle, fragment, 0, surface);
}

}  // namespace glassbox
