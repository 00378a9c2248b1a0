// Which way a draw takes through the tile engine, and what of its stages is left out.
#pragma once

#include <glassbox/raster/lanes/tables.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/plan/box_place.h>

namespace glassbox {

// Why something runs that a proof would leave out.
inline constexpr const char* kNoPlan = "--no-plan: it runs, needed or not";

struct DrawMethod {
  // Null: triangles run over lanes and are shaded once for each pixel where they are seen. Otherwise why every primitive takes the
  // staged stages, tile by tile.
  const char* staged_because = nullptr;
  // Null: triangles are set up over lanes where they are small. Otherwise why each is made ready by the staged primitives.
  const char* large_because = nullptr;

  // Null: the mesh's clusters are asked whether this eye sees any of them, before their vertices (cluster_cull.h). Otherwise why not.
  const char* no_clusters_because = nullptr;

  // Null: neighbours in the order of drawing that are instances of the same mesh go through the stages with it. Otherwise why it goes
  // by itself.
  const char* alone_because = nullptr;

  // ---- vertices ----
  BoxPlace place;       // of all of them: the proof of the next two
  bool hidden = false;  // all of it lies behind draws before it
  bool drawn = true;    // otherwise no stage sees any of it
  // It writes to the framebuffer, or lies over what is there: it keeps its place in the order, and planes are kept up to date for it.
  bool into_framebuffer = false;
  bool test_planes = true;  // each is asked whether clipping has to look at it
  bool divide = true;       // by w, which may differ from 1
  // Carried to eye space; and of faces, where some corner has none of its own.
  bool normals = false;
  bool face_normals = false;
  bool eye_positions = false;  // light asks where the surface is

  // ---- triangles ----
  bool keep_front = true, keep_back = false;  // facing: which are drawn

  // ---- colours ----
  LightAt light = LightAt::kNowhere;
  bool highlights = false;  // the material has any
  bool texture = false;
  bool vertex_colors = false;
  bool emission = false;  // the material has any
  bool emission_texture = false;
};

// What is asked of a picture's draws.
struct MethodQuestion {
  const Lighting& lighting;
  const View& view;
  const RenderSettings& settings;
  bool colors = true;     // somebody sees them
  bool leave_out = true;  // what the proofs allow; otherwise everything runs that can
};
// `place`: of the draw, or of a group that it is in.
DrawMethod choose_method(const Draw& draw, const BoxPlace& place, const MethodQuestion& asked);

// Whether w may differ from 1.
bool needs_divide(const Draw& draw);

}  // namespace glassbox
