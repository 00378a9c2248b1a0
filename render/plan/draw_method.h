// How the tile engine draws a draw, and which stages are left out for it.
#pragma once

#include <glassbox/raster/lanes/tables.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/plan/box_classification.h>

namespace glassbox {

// The reason given for a stage that runs although a proof would allow leaving it out.
inline constexpr const char* kNoPlan = "--no-plan: it is computed, whether needed or not";

// How one draw is drawn. The fields that end in _because give a reason, or are null.
struct DrawMethod {
  // Null: triangles are drawn by vectorised code and shaded once for each pixel where they are
  // seen. Otherwise the reason why the stages of the reference draw every primitive, tile by tile.
  const char* staged_because = nullptr;
  // Null: small triangles are set up by vectorised code. Otherwise the reason why the stages of the
  // reference set up each triangle.
  const char* large_because = nullptr;

  // Null: the mesh's clusters are tested for whether this eye sees them, before their vertices are
  // transformed (cluster_cull.h). Otherwise the reason why not.
  const char* no_clusters_because = nullptr;

  // Null: instances of the same mesh that are neighbours in the order of drawing go through the
  // stages together with this draw. Otherwise the reason why it is drawn alone.
  const char* alone_because = nullptr;

  // ---- vertices ----
  BoxClassification classification;  // where all vertices are; decides `drawn` and `test_planes`
  bool hidden = false;               // all of it is behind earlier draws
  bool drawn = true;                 // otherwise no stage processes it
  // The draw writes to the framebuffer or is blended with what is there. So it keeps its place in
  // the order of drawing, and the framebuffer is up to date when it is drawn.
  bool into_framebuffer = false;
  bool test_planes = true;  // each vertex is tested for whether it needs clipping
  bool divide = true;       // w may differ from 1
  // Whether the normals of vertices are transformed to eye space, and those of faces (for flat
  // shading, or if some corner has no normal).
  bool normals = false;
  bool face_normals = false;
  bool eye_positions = false;  // lighting needs the position of the surface

  // ---- triangles ----
  bool keep_front = true, keep_back = false;  // which faces are drawn

  // ---- colours ----
  LightAt light = LightAt::kNowhere;
  bool highlights = false;  // the material has specular highlights
  bool texture = false;
  bool vertex_colors = false;
  bool emission = false;  // the material emits light
  bool emission_texture = false;
};

// What the methods of a picture's draws depend on, apart from the draws themselves.
struct MethodInputs {
  const Lighting& lighting;
  const View& view;
  const RenderSettings& settings;
  bool colors = true;     // the colours are visible
  bool leave_out = true;  // leave out what the proofs allow; otherwise all possible stages run
};
// `classification` is that of the draw's own box, or of the box of its group of instances.
DrawMethod choose_method(const Draw& draw, const BoxClassification& classification,
                         const MethodInputs& inputs);

// Whether w may differ from 1, so that the divide is needed.
bool needs_divide(const Draw& draw);

}  // namespace glassbox
