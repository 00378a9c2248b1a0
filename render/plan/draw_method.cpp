#include <glassbox/render/plan/draw_method.h>

#include <algorithm>

#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox {

namespace {

const char* why_staged(const RenderSettings& settings) {
  if (settings.wireframe) return "lines are drawn one after the other";
  if (settings.show == Show::kNormal || settings.show == Show::kUv) {
    return "a picture of normals or texture coordinates";
  }
  if (settings.show == Show::kOverdraw) return "every fragment is counted";
  return nullptr;
}

bool is_specular(const Material& material) {
  return std::ranges::any_of(material.specular, [](float s) { return s != 0; });
}

bool depends_on_place(const EyeLight& light) {
  return light.kind != LightKind::kDirectional;
}

// Whether the last row of the matrix is 0 0 0 1, so that w is exactly 1.
bool w_is_one(const Transform<Clip, Object, float>& m) {
  return m.at(3, 0) == 0 && m.at(3, 1) == 0 && m.at(3, 2) == 0 && m.at(3, 3) == 1;
}

const char* why_no_clusters(const Draw& draw, const DrawMethod& method, bool leave_out) {
  if (!leave_out) return kNoPlan;
  if (draw.prepared->clusters.clusters.empty()) return "it has few triangles";
  if (method.staged_because != nullptr) return "a staged draw tests each triangle by itself";
  if (!draw.mesh->lines.empty() || !draw.mesh->points.empty()) {
    return "lines or points share their vertices";
  }
  if (method.classification.inside && method.classification.in_picture && method.keep_front &&
      method.keep_back) {
    return "its box is inside the picture, and both sides of its faces are drawn";
  }
  if (may_overflow(anchored_box(draw), draw.clip_from_anchored)) return "a coordinate may overflow";
  return nullptr;
}

const char* why_alone(const Draw& draw, const DrawMethod& method, const RenderSettings& settings,
                      bool leave_out) {
  if (!leave_out) return kNoPlan;
  if (draw.prepared->joined.positions.empty()) {
    return "its mesh has only one instance, or is too large";
  }
  if (method.staged_because != nullptr) return "staged draws are made one after the other";
  if (settings.want_id || settings.show == Show::kId) {
    return "triangle numbers are requested, and they belong to single draws";
  }
  if (settings.cull_stage == CullStage::kObject) return "faces are culled in its own object space";
  if (method.light == LightAt::kVertices && settings.shading == Shading::kFlat) {
    return "flat shading uses the faces of its mesh";
  }
  return nullptr;
}

void choose_vertex_stages(const Draw& draw, const BoxClassification& classification, bool leave_out,
                          DrawMethod& method) {
  method.classification = classification;
  method.drawn = !leave_out || classification.outside_of == nullptr;
  method.test_planes = !leave_out || !classification.inside;
  method.divide = !leave_out || needs_divide(draw);
}

// Decides whether the draw keeps its place in the order. Blended draws do, because they need the
// colours of what was drawn before them. So do staged draws (drawn by the stages of the reference),
// lines and points: they are drawn into the framebuffer, other draws into buffers of the tile, and
// in another order a tile would change more often between the two.
void choose_order(const Draw& draw, DrawMethod& method) {
  method.into_framebuffer = method.staged_because != nullptr ||
                            draw.material->alpha_mode == AlphaMode::kBlend ||
                            !draw.mesh->lines.empty() || !draw.mesh->points.empty();
}

void choose_light(const Draw& draw, const Lighting& lighting, const RenderSettings& settings,
                  bool leave_out, DrawMethod& method) {
  const bool per_vertex =
      settings.shading == Shading::kFlat || settings.shading == Shading::kGouraud;
  method.light = per_vertex ? LightAt::kVertices : LightAt::kFragments;
  method.highlights = !leave_out || is_specular(*draw.material);
  method.eye_positions = per_vertex || (method.highlights && lighting.perspective) ||
                         std::ranges::any_of(lighting.lights, depends_on_place);
}

}  // namespace

bool needs_divide(const Draw& draw) {
  return !draw.prepared->all_finite || !w_is_one(draw.clip_from_anchored);
}

DrawMethod choose_method(const Draw& draw, const BoxClassification& classification,
                         const MethodInputs& inputs) {
  const RenderSettings& settings = inputs.settings;
  const bool colors = inputs.colors, leave_out = inputs.leave_out;
  DrawMethod method;
  method.staged_because = why_staged(settings);
  choose_vertex_stages(draw, classification, leave_out, method);
  choose_order(draw, method);

  method.keep_front = !is_culled(draw, settings.cull, true);
  method.keep_back = !is_culled(draw, settings.cull, false);
  method.no_clusters_because = why_no_clusters(draw, method, leave_out);

  // A picture of triangle numbers shows colours where blended lines and points are seen.
  const bool painted = colors && (settings.show == Show::kColor || settings.show == Show::kId);
  const bool masked = draw.material->alpha_mode == AlphaMode::kMask;
  method.texture = (painted || masked) && draw.texture != nullptr;
  method.vertex_colors = (painted || masked) && draw.prepared->indices.has_colors;
  if (colors && needs_normals(draw, settings)) {
    choose_light(draw, inputs.lighting, settings, leave_out, method);
  }
  method.emission = method.light != LightAt::kNowhere && painted && (!leave_out || draw.emits());
  method.emission_texture = method.emission && draw.emission_texture != nullptr;
  method.normals = !leave_out || method.light != LightAt::kNowhere;
  method.face_normals = method.normals && needs_face_normals(draw, settings);
  method.eye_positions = method.eye_positions || !leave_out;
  if (draw.prepared->indices.mixed)
    method.large_because = "some of its corners lack attributes that others have";
  if ((method.texture || method.emission_texture) && !draw.prepared->indices.has_texcoords)
    method.large_because = "its corners have no texture coordinates";
  method.alone_because = why_alone(draw, method, settings, leave_out);
  return method;
}

}  // namespace glassbox
