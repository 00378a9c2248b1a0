#include <glassbox/render/trace/run_bounds.h>

#include <utility>

#include <glassbox/render/staged/staged.h>

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
  if (std::exchange(fragments_came_, false)) {
    latest_.clear();
    earlier_.clear();
  }
  // Where no fragments come for long, nothing piles up.
  if (latest_.size() == kTriangleBatch) earlier_ = std::exchange(latest_, {});
  const auto& [draw, draw_bounds] = draws_.at(triangle.instance);
  Known& known = latest_[triangle.number];
  known = {triangle, bounds_of(trace_, triangle, draw, draw_bounds)};
  return known;
}

const BoundsOfRun::Known* BoundsOfRun::of(const TracedFragment& fragment) {
  fragments_came_ = true;
  if (!fragment.source.is_triangle) return nullptr;
  for (const auto* triangles : {&latest_, &earlier_}) {
    const auto found = triangles->find(fragment.source.number);
    if (found != triangles->end()) return &found->second;
  }
  return nullptr;
}

FragmentBounds bounds_of(const BoundsOfRun::Known& known, const TracedFragment& fragment) {
  const TracedPiece& piece = known.triangle.pieces[fragment.source.piece];
  return fragment_bounds(*piece.setup, fragment.fragment, setup_bounds(piece, known.bounds));
}

}  // namespace glassbox
