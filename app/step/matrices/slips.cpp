#include "app/step/matrices/slips.h"

#include <array>
#include <utility>

#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>

#include "app/step/matrices/projection_factors.h"

namespace glassbox {
namespace {

constexpr std::array kSlips{
    Slip{Change::kTransposeAll, "transpose-all", "transpose every matrix",
         "columns were read as rows, or the matrices are for row vectors, p M: read them in the "
         "other --order"},
    Slip{Change::kTransposeModel, "transpose-model", "transpose the model matrix",
         "rows and columns are mixed up for this matrix only"},
    Slip{Change::kTransposeView, "transpose-view", "transpose the view matrix",
         "rows and columns are mixed up for this matrix only"},
    Slip{Change::kTransposeProjection, "transpose-projection", "transpose the projection",
         "rows and columns are mixed up for this matrix only"},
    Slip{Change::kExchangeViewProjection, "exchange-view-projection",
         "exchange view and projection", "look at the order of the factors in your program"},
    Slip{Change::kDegrees, "degrees", "take the angle of view for degrees",
         "pass the angle in radians"},
    Slip{Change::kRadians, "radians", "take the angle of view for radians",
         "pass the angle in degrees"},
    Slip{Change::kClearCorner, "clear-corner", "clear [3][3] of the projection",
         "start the projection from zeros, not from the identity"},
    Slip{Change::kDepthRange, "depth-range", "clip z to the other range",
         "make the projection for the range of depth that is clipped to (E16)"},
    Slip{Change::kEyeHand, "eye-hand", "negate z between view and projection",
         "handedness is mixed (E12): take the projection for the hand of the view"},
    Slip{Change::kTurnRound, "turn-round", "turn the camera round: negate x and z of the eye",
         "handedness is mixed (E12): take the view for the hand of the projection; an eye that "
         "looks down -z has eye - target for its z axis"},
    Slip{Change::kInvertView, "invert-view", "invert the view matrix",
         "the matrix is the camera's pose, world from eye; a view is its inverse"},
    Slip{Change::kViewFactors, "view-factors", "exchange the view's factors: R T instead of T R",
         "first move the eye to the origin, then turn: R * T(-eye)"},
    Slip{Change::kViewOffsetSign, "view-offset-sign", "negate the view's translation",
         "the world moves by minus the eye's position"},
    Slip{Change::kViewFactorsBack, "view-factors-back",
         "exchange the view's factors: T R instead of R T",
         "first turn, then step back: T * R, for a camera that circles the origin"},
    Slip{
        Change::kModelFactors, "model-factors", "exchange the model's factors: R T instead of T R",
        "the matrix next to the vertex acts first; T R turns about the object's own origin (C-19)"},
    Slip{
        Change::kModelFactorsBack, "model-factors-back",
        "exchange the model's factors: T R instead of R T",
        "the matrix next to the vertex acts first; T R turns about the object's own origin (C-19)"},
    Slip{Change::kInvertModel, "invert-model", "invert the model matrix",
         "the matrix is object from world"},
    Slip{Change::kExchangeModelView, "exchange-model-view", "exchange model and view",
         "look at the order of the factors in your program: projection * view * model"},
    Slip{Change::kFlipX, "flip-x", "mirror the picture left to right",
         "look for a negated right axis, or world and eye of opposite hands (E7)"},
    Slip{Change::kFlipY, "flip-y", "turn y of the window over",
         "the window's y is counted from the other edge, or the picture is upside down"},
};

void exchange_offset(GivenMatrix& matrix, const glm::dmat3& by) {
  const glm::dvec3 moved = by * glm::dvec3(matrix.m[3]);
  matrix.m[3] = glm::dvec4(moved, matrix.m[3].w);
}

bool invert(GivenMatrix& matrix) {
  const auto inverse = affine::inverse(matrix.m);
  if (!inverse || !matrix.given) return false;
  matrix.m = *inverse;
  return true;
}

// [A | t] with A t, or A^-1 t, in place of t.
bool exchange_factors(GivenMatrix& matrix, bool back) {
  const auto inverse = affine::inverse(matrix.m);
  if (!inverse || !matrix.given) return false;
  exchange_offset(matrix, back ? glm::dmat3(*inverse) : glm::dmat3(matrix.m));
  return true;
}

bool transpose(GivenMatrix& matrix) {
  if (!matrix.given) return false;
  matrix = transposed(matrix);
  return true;
}

// Scales x and y as the angle that was meant would have.
bool set_angle(GivenMatrix& projection, const std::optional<int>& degrees) {
  if (!degrees) return false;
  const ProjectionFacts facts = projection_facts(projection);
  const double factor = cot_half_degrees(*degrees) / facts.scale.y;
  projection.m[0][0] *= factor;
  projection.m[1][1] *= factor;
  return true;
}

}  // namespace

std::span<const Slip> slips() {
  return kSlips;
}

bool apply(Change change, MatrixSetup& s) {
  switch (change) {
    case Change::kTransposeAll: {
      const bool model = transpose(s.model), view = transpose(s.view);
      return transpose(s.projection) || model || view;
    }
    case Change::kTransposeModel:
      return transpose(s.model);
    case Change::kTransposeView:
      return transpose(s.view);
    case Change::kTransposeProjection:
      return transpose(s.projection);
    case Change::kExchangeViewProjection:
      std::swap(s.view, s.projection);
      return s.view.given && s.projection.given;
    case Change::kExchangeModelView:
      std::swap(s.model, s.view);
      return s.view.given && s.model.given;
    case Change::kDegrees:
      return set_angle(s.projection, projection_facts(s.projection).degrees_taken_as_radians);
    case Change::kRadians:
      return set_angle(s.projection, projection_facts(s.projection).radians_taken_as_degrees);
    case Change::kClearCorner: {
      if (!has_corner_left_over(s.projection)) return false;
      s.projection = without_corner(s.projection);
      return true;
    }
    case Change::kDepthRange:
      s.dialect.z_from_minus_w = !s.dialect.z_from_minus_w;
      return true;
    case Change::kEyeHand:
      s.projection.m[2] = -s.projection.m[2];
      return true;
    case Change::kTurnRound:
      s.view.m = glm::dmat4(glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, -1)) * s.view.m;
      return s.view.given;
    case Change::kInvertView:
      return invert(s.view);
    case Change::kViewFactors:
      return exchange_factors(s.view, false);
    case Change::kViewFactorsBack:
      return exchange_factors(s.view, true);
    case Change::kViewOffsetSign:
      exchange_offset(s.view, glm::dmat3(-1));
      return s.view.given;
    case Change::kModelFactors:
      return exchange_factors(s.model, false);
    case Change::kModelFactorsBack:
      return exchange_factors(s.model, true);
    case Change::kInvertModel:
      return invert(s.model);
    case Change::kFlipX:
      for (int column = 0; column < 4; ++column) s.projection.m[column][0] *= -1;
      return true;
    case Change::kFlipY:
      for (int column = 0; column < 4; ++column) s.projection.m[column][1] *= -1;
      return true;
  }
  return false;
}

}  // namespace glassbox
