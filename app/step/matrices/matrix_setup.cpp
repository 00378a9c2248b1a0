#include "app/step/matrices/matrix_setup.h"

#include "app/step/matrices/projection_factors.h"

namespace glassbox {

std::optional<Hand> world_drawn(const MatrixSetup& setup) {
  const MatrixFacts view = facts_of(setup.view.m);
  const ProjectionFacts lens =
      projection_facts(projection_part(setup.projection), setup.dialect.depth);
  if (!view.invertible() || lens.kind == ProjectionKind::kNone || !setup.projection.given) {
    return std::nullopt;
  }
  bool right = lens.looks_down_minus_z;
  if (view.mirror()) right = !right;
  // A picture that is only upside down is not mirrored left to right, nor is one that is turned round.
  const bool y_flipped = (lens.scale.y < 0) != setup.dialect.ndc_y_down;
  if (lens.scale.x < 0 && !y_flipped) right = !right;
  return right ? Hand::kRight : Hand::kLeft;
}

}  // namespace glassbox
