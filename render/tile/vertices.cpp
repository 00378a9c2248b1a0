#include <algorithm>

#include <glassbox/render/tile/draw_round.h>

namespace glassbox {

namespace {

// Returns how far from the centre, in half screens, a vertex may be so that it is certainly within
// the guard band in spite of rounding: half of the guard band.
float guard_band_half_screens(float screen_side) {
  return float(kGuardBandPx / double(screen_side));
}

VertexJob vertex_job(const TileRun& run, std::uint32_t index) {
  const Draw& draw = run.list.draws[index];
  VertexJob job;
  job.anchor = draw.anchor;
  job.clip_from_anchored = draw.clip_from_anchored;
  job.viewport = run.view.viewport;
  const ClipPlane &near = run.planes[kNearPlane], &far = run.planes[kFarPlane];
  // The factor of w in the plane z = w: this is the far plane, or with a reversed range the near
  // plane.
  job.far_factor = float(std::max(far.d, near.d));
  job.smallest_w = float(-run.planes[kEyePlane].e);
  job.band_x = guard_band_half_screens(run.view.viewport.width());
  job.band_y = guard_band_half_screens(run.view.viewport.height());
  job.test_planes = run.methods[index].test_planes;
  job.divide = run.methods[index].divide;
  return job;
}

void transform_neighbours(const TileRun& run, const Kernels& kernels, const DrawSlot& slot,
                          const SecondEyeInputs* other, VertexTables& tables, std::size_t first,
                          std::size_t count) {
  const Draw& draw = run.list.draws[slot.draw];
  VertexJob job = vertex_job(run, slot.draw);
  job.positions = std::span(draw.mesh->positions).subspan(first, count);
  job.screen = slot.screen + first;
  if (other != nullptr) {
    job.test_planes = job.test_planes || other->run.methods[slot.draw].test_planes;
    job.other_clip_from_anchored = &other->run.list.draws[slot.draw].clip_from_anchored;
    job.other_screen = other->slot.screen + first;
  }
  kernels.transform_vertices(job);
  if (run.methods[slot.draw].eye_positions) {
    kernels.transform_positions({job.positions, draw.anchor, draw.eye_from_anchored,
                                 tables.eye_positions.data() + slot.first_eye_position + first});
  }
}

// Calls visit for the runs of entries that are needed. `needed` has one entry for each block of the
// table; empty: all blocks are needed.
template <class Visit>
void for_each_needed(std::span<const std::uint8_t> needed, std::size_t first, std::size_t count,
                     const Visit& visit) {
  const auto is_needed = [&](std::size_t block) { return needed[block] != 0; };
  if (needed.empty()) return visit(first, count);
  for_each_run(first, count, kTableBlock, is_needed, visit);
}

}  // namespace

void transform_positions(const TileRun& run, const Kernels& kernels, const DrawSlot& slot,
                         const SecondEyeInputs* other, VertexTables& tables, std::size_t first,
                         std::size_t count) {
  for_each_needed(slot.needed_positions, first, count, [&](std::size_t begin, std::size_t size) {
    transform_neighbours(run, kernels, slot, other, tables, begin, size);
  });
}

void transform_normals(const TileRun& run, const Kernels& kernels, const DrawSlot& slot,
                       VertexTables& tables, std::size_t first, std::size_t count) {
  const Draw& draw = run.list.draws[slot.draw];
  for_each_needed(slot.needed_normals, first, count, [&](std::size_t begin, std::size_t size) {
    kernels.transform_normals({std::span(draw.mesh->normals).subspan(begin, size),
                               draw.eye_normal_from_object,
                               tables.normals.data() + slot.first_normal + begin});
  });
}

void transform_face_normals(const TileRun& run, const DrawSlot& slot, VertexTables& tables) {
  const Draw& draw = run.list.draws[slot.draw];
  std::vector<Normal<Eye>> normals;
  append_face_normals(draw, normals);
  std::ranges::copy(normals, tables.normals.begin() +
                                 std::ptrdiff_t(slot.first_normal + draw.mesh->normals.size()));
}

}  // namespace glassbox
