#include <glassbox/render/tile/draw_method.h>

#include <algorithm>

#include <glassbox/render/vertex_stage.h>

namespace glassbox {

namespace {

const char* why_staged(const Draw& draw, const RenderSettings& settings) {
  if (settings.wireframe) return "lines are drawn one after the other";
  if (settings.show == Show::kNormal || settings.show == Show::kUv) {
    return "a picture of normals or texture coordinates";
  }
  if (settings.show == Show::kOverdraw) return "every fragment is counted";
  if (draw.material->alpha_mode == AlphaMode::kBlend) return "it is blended with what lies behind";
  if (draw.material->alpha_mode == AlphaMode::kMask)
    return "its alpha decides which fragments there are";
  return nullptr;
}

bool shines(const Material& material) {
  return std::ranges::any_of(material.specular, [](float s) { return s != 0; });
}

bool depends_on_place(const EyeLight& light) {
  return light.kind != LightKind::kDirectional;
}

}  // namespace

DrawMethod choose_method(const Draw& draw, const Lighting& lighting,
                         const RenderSettings& settings) {
  DrawMethod method;
  method.staged_because = why_staged(draw, settings);

  const bool both = draw.material->double_sided;
  method.keep_front = settings.cull != Cull::kFront;
  method.keep_back = settings.cull == Cull::kNone || settings.cull == Cull::kFront ||
                     (settings.cull == Cull::kMaterial && both);

  const bool painted = settings.show == Show::kColor;
  method.texture = painted && draw.texture != nullptr;
  method.vertex_colors = painted && draw.prepared->indices.has_colors;
  if (needs_normals(draw, settings)) {
    const bool per_vertex =
        settings.shading == Shading::kFlat || settings.shading == Shading::kGouraud;
    method.light = per_vertex ? LightAt::kVertices : LightAt::kFragments;
    method.highlights = shines(*draw.material);
    method.eye_positions = per_vertex || (method.highlights && lighting.perspective) ||
                           std::ranges::any_of(lighting.lights, depends_on_place);
    if (per_vertex) method.large_because = "light is computed at the vertices";
  }
  if (draw.prepared->indices.mixed)
    method.large_because = "some of its corners have attributes that others lack";
  if (method.texture && !draw.prepared->indices.has_texcoords)
    method.large_because = "its corners do not say where in the texture they lie";
  return method;
}

}  // namespace glassbox
