#include <algorithm>

#include <glassbox/render/tile/draw_round.h>

namespace glassbox {

namespace {

std::size_t triangles_of(const Draw& draw) {
  return draw.triangulation->triangles.size();
}

// A measure of the memory that a draw takes in a round.
std::size_t size_of(const Draw& draw) {
  return std::max(draw.mesh->positions.size(), triangles_of(draw));
}

// Whether draw `next` can go through the stages together with the draws of `slot`. Decisions of the
// plan that are not compared here are the same for all of them, because they have the same mesh.
bool joins(const TileRun& run, const DrawSlot& slot, std::uint32_t next) {
  const Draw &draw = run.list.draws[slot.draw], &other = run.list.draws[next];
  const DrawMethod &method = run.methods[slot.draw], &method_of_other = run.methods[next];
  return draw.mesh == other.mesh && method.alone_because == nullptr &&
         method_of_other.alone_because == nullptr && draw.mirrored == other.mirrored &&
         method.divide == method_of_other.divide &&
         (slot.draws.size() + 1) * triangles_of(draw) <= kJoinedTriangles;
}

// Sets how many entries of the tables each draw of the slot has.
void set_strides(const TileRun& run, DrawSlot& slot) {
  const Mesh& mesh = *run.list.draws[slot.draw].mesh;
  const DrawMethod& method = run.methods[slot.draw];
  slot.positions = mesh.positions.size();
  slot.normals = method.normals ? mesh.normals.size() : 0;
  if (method.face_normals) slot.normals += mesh.faces.size();
  slot.eye_positions = method.eye_positions ? mesh.positions.size() : 0;
}

}  // namespace

std::size_t make_slots(const TileRun& run, std::span<const std::uint32_t> order, std::size_t first,
                       std::size_t round_size, std::vector<DrawSlot>& slots) {
  slots.clear();
  DrawSlot next;  // its entries begin where those of the last slot end
  std::size_t size = 0, end = first;
  for (; end < order.size(); ++end) {
    const Draw& draw = run.list.draws[order[end]];
    size += size_of(draw);
    if (end > first && size > round_size) break;
    if (!slots.empty() && joins(run, slots.back(), order[end])) {
      DrawSlot& slot = slots.back();
      slot.draws = order.subspan(end - slot.draws.size(), slot.draws.size() + 1);
      slot.indices = &draw.prepared->joined;
    } else {
      next.draw = order[end];
      next.draws = order.subspan(end, 1);
      next.indices = &draw.prepared->indices;
      set_strides(run, next);
      slots.push_back(next);
    }
    next.first_position += slots.back().positions;
    next.first_normal += slots.back().normals;
    next.first_eye_position += slots.back().eye_positions;
    next.first_reference += Reference(triangles_of(draw)) * kReferenceStep;
  }
  return end;
}

void set_eye_space(const TileRun& run, VertexTables& tables, DrawSlot& slot) {
  const Draw& draw = run.list.draws[slot.draw];
  const DrawMethod& method = run.methods[slot.draw];
  slot.eye_space.lit = method.normals && needs_normals(draw, run.settings);
  const std::span normals = std::span(tables.normals).subspan(slot.first_normal, slot.normals);
  const std::size_t of_vertices = method.normals ? draw.mesh->normals.size() : 0;
  slot.eye_space.normals = normals.first(of_vertices);
  slot.eye_space.face_normals = normals.subspan(of_vertices);
  slot.eye_space.positions =
      std::span(tables.eye_positions).subspan(slot.first_eye_position, slot.eye_positions);
}

DrawSlot slot_of_draw(const DrawSlot& slot, std::size_t k) {
  DrawSlot one = slot;
  one.draw = slot.draws[k];
  one.draws = slot.draws.subspan(k, 1);
  one.first_position += k * slot.positions;
  one.first_normal += k * slot.normals;
  one.first_eye_position += k * slot.eye_positions;
  one.screen += k * slot.positions;
  const auto moved = [&](auto& span, std::size_t by) { span = {span.data() + by, span.size()}; };
  moved(one.eye_space.normals, k * slot.normals);
  moved(one.eye_space.face_normals, k * slot.normals);
  moved(one.eye_space.positions, k * slot.eye_positions);
  return one;
}

}  // namespace glassbox
