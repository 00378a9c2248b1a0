#include <glassbox/render/trace/run_bounds.h>

namespace glassbox {

BoundsOfRun::BoundsOfRun(const View& view) {
  trace_.view = view;
  const auto planes = render_planes(view);
  trace_.planes.assign(planes.begin(), planes.end());
}

const DrawBounds& BoundsOfRun::draw(const TracedDraw& draw) {
  auto& known = draws_[draw.instance];
  known = {draw, bounds_of(draw, trace_.view)};
  return known.second;
}

const BoundsOfRun::Known& BoundsOfRun::triangle(const TracedTriangle& triangle) {
  // Triangles come in batches, each followed by its fragments.
  if (fragments_came_) batch_.clear();
  fragments_came_ = false;
  const auto& [draw, draw_bounds] = draws_.at(triangle.instance);
  Known& known = batch_[triangle.number];
  known = {triangle, bounds_of(trace_, triangle, draw, draw_bounds)};
  return known;
}

const BoundsOfRun::Known* BoundsOfRun::of(const TracedFragment& fragment) {
  fragments_came_ = true;
  if (!fragment.source.is_triangle) return nullptr;
  const auto found = batch_.find(fragment.source.number);
  return found == batch_.end() ? nullptr : &found->second;
}

FragmentBounds bounds_of(const BoundsOfRun::Known& known, const TracedFragment& fragment) {
  const TracedPiece& piece = known.triangle.pieces[fragment.source.piece];
  return fragment_bounds(*piece.setup, fragment.fragment, setup_bounds(piece, known.bounds));
}

}  // namespace glassbox
