// How the tile engine draws a draw, and which stages are left out for it.
#pragma once

#include <glassbox/raster/lanes/tables.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/plan/box_classification.h>

namespace glassbox {

// The reason given for a stage that runs although a proof would allow leaving it out.
inline constexpr const char* kNoPlan = "--no-plan: it runs, whether needed or not";

// How one draw is drawn.
struct DrawMethod {
  // Null: triangles are drawn by vectorised code and shaded once for each pixel where they are
  // seen. Otherwise the reason why every primitive goes through the staged stages, tile by tile.
  const char* staged_because = nullptr;
  // Null: small triangles are set up by vectorised code. Otherwise the reason why each is prepared
  // by the staged primitives.
  const char* large_because = nullptr;

  // Null: the mesh's clusters are tested for whether this eye sees them, before their vertices are
  // transformed (cluster_cull.h). Otherwise the reason why not.
  const char* no_clusters_because = nullptr;

  // Null: instances of the same mesh that are neighbours in the order of drawing go through the
  // stages together with this draw. Otherwise the reason why it is drawn alone.
  const char* alone_because = nullptr;

  // ---- vertices ----
  BoxClassification classification;  // of all vertices: the proof for the next two fields
  bool hidden = false;               // all of it is behind earlier draws
  bool drawn = true;                 // otherwise no stage processes it
  // It writes to the framebuffer, or is blended over what is there: it keeps its place in the
  // order, and the planes are kept up to date for it.
  bool into_framebuffer = false;
  bool test_planes = true;  // each vertex is tested for whether it needs clipping
  bool divide = true;       // by w, which may differ from 1
  // Normals of vertices are transformed to eye space; and those of faces, where some corner has no
  // normal.
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

// The circumstances in which methods are chosen for a picture's draws.
struct MethodInputs {
  const Lighting& lighting;
  const View& view;
  const RenderSettings& settings;
  bool colors = true;     // the colours are visible
  bool leave_out = true;  // leave out what the proofs allow; otherwise all possible stages run
};
// `classification`: of the draw, or of its group of instances.
DrawMethod choose_method(const Draw& draw, const BoxClassification& classification,
                         const MethodInputs& inputs);

// Whether w may differ from 1.
bool needs_divide(const Draw& draw);

}  // namespace glassbox
