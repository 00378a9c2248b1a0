#include "study/bench/mesa/draws.h"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/dialects.h>

namespace glassbox::study {

namespace {

// The matrix for OpenGL maps depth to [-1, 1]; OpenGL's viewport then maps it to [0, 1], the range
// of Glassbox.
glm::mat4 gl_matrix(const View& view, const Draw& draw) {
  const Vector<Object, double> anchor{draw.anchor.x, draw.anchor.y, draw.anchor.z};
  Transform<ClipGl, ClipGl> upside_down;
  upside_down.at(1, 1) = -1;
  return round_to_float(upside_down * clip_gl_from_clip() * view.clip_from_eye *
                        draw.eye_from_object * translate<Object, Object>(anchor))
      .columns;
}

CulledFaces find_culled_faces(const Draw& draw, Cull cull) {
  const bool front = is_culled(draw, cull, true), back = is_culled(draw, cull, false);
  if (front && back) return CulledFaces::kAll;
  return front ? CulledFaces::kFront : back ? CulledFaces::kBack : CulledFaces::kNone;
}

// Whether the matrix is a rotation (or a reflection) times a scale factor, up to rounding errors.
bool keeps_ratios(const glm::mat3& m) {
  const glm::mat3 product = glm::transpose(m) * m;
  const float size = product[0][0];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const float expected = i == j ? size : 0.0f;
      if (!(std::abs(product[i][j] - expected) <= 0x1p-16f * size)) return false;
    }
  }
  return true;
}

PeerDraw make_peer_draw(const BenchScene& bench, const Draw& draw, const View& view) {
  PeerDraw peer_draw;
  peer_draw.material = draw.material;
  peer_draw.mesh = bench.scene.instances[draw.instance].mesh;
  if (draw.texture != nullptr) peer_draw.texture = *draw.material->texture;
  if (draw.emission_texture != nullptr)
    peer_draw.emission_texture = *draw.material->emission_texture;
  peer_draw.emission = draw.emission;
  peer_draw.culled_faces = find_culled_faces(draw, bench.settings.cull);
  peer_draw.mirrored = draw.mirrored;
  peer_draw.clip_from_object = gl_matrix(view, draw);
  peer_draw.eye_from_object = draw.eye_from_anchored.columns;
  peer_draw.eye_normal_from_object = draw.eye_normal_from_object.columns;
  return peer_draw;
}

}  // namespace

std::vector<PeerDraw> peer_draws(const BenchScene& bench, const DrawList& list, const View& view) {
  std::vector<PeerDraw> draws;
  draws.reserve(list.draws.size());
  for (const Draw& draw : list.draws) draws.push_back(make_peer_draw(bench, draw, view));
  return draws;
}

Ingredients ingredients_of(const BenchScene& bench, const PeerDraw& draw,
                           const Lighting& lighting) {
  const Material& material = *draw.material;
  const auto is_zero = [](float channel) { return channel == 0; };
  Ingredients found;
  found.textured = draw.texture != kNone;
  found.colored = !bench.scene.meshes[draw.mesh].colors.empty();
  found.alpha = material.alpha_mode;
  found.emits = !std::ranges::all_of(draw.emission, is_zero);
  found.emission_textured = found.emits && draw.emission_texture != kNone;
  found.lit = !material.unlit;
  if (!found.lit) return found;
  for (const EyeLight& light : lighting.lights) {
    const bool placed = light.kind != LightKind::kDirectional;
    found.lights.push_back({light.kind, placed && light.inverse_range > 0});
  }
  found.perspective = lighting.perspective;
  found.two_sided = draw.culled_faces != CulledFaces::kBack;
  found.unequal_normals = !keeps_ratios(draw.eye_normal_from_object);
  const bool shines = !std::ranges::all_of(material.specular, is_zero);
  found.shininess = shines ? material.shininess : 0;
  return found;
}

}  // namespace glassbox::study
