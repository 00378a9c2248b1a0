#include <glassbox/matrices/convention_mistakes.h>

#include <array>
#include <utility>

#include <glassbox/base/trig.h>
#include <glassbox/matrices/projection_factors.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox {
namespace {

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

// Replaces the last column t of an affine matrix with the upper 3x3 part A by A t, or by A^-1 t if
// `back`.
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

using MeantAngle = std::optional<int> ProjectionFacts::*;

// Scales the first two diagonal entries so that they fit the angle of view that was meant.
bool set_angle(GivenMatrix& projection, MeantAngle meant) {
  const ProjectionFacts facts = projection_facts(projection);
  const std::optional<int>& degrees = facts.*meant;
  if (!degrees) return false;
  const double factor = cot_half_degrees(*degrees) / facts.scale.y;
  projection.m[0][0] *= factor;
  projection.m[1][1] *= factor;
  return true;
}

bool exchange(GivenMatrix& one, GivenMatrix& other) {
  std::swap(one, other);
  return one.given && other.given;
}

bool negate_row(GivenMatrix& matrix, int row) {
  for (int column = 0; column < 4; ++column) matrix.m[column][row] *= -1;
  return true;
}

const std::array kConventionMistakes{
    ConventionMistake{
        SetupChange::kTransposeAll, "transpose-all", "transpose every matrix",
        "columns were read as rows, or the matrices are for row vectors (point * matrix): read "
        "them in the other --order",
        [](MatrixSetup& s) {
          const bool model = transpose(s.model), view = transpose(s.view);
          return transpose(s.projection) || model || view;
        }},
    ConventionMistake{SetupChange::kTransposeModel, "transpose-model", "transpose the model matrix",
                      "rows and columns are mixed up for this matrix only",
                      [](MatrixSetup& s) { return transpose(s.model); }},
    ConventionMistake{SetupChange::kTransposeView, "transpose-view", "transpose the view matrix",
                      "rows and columns are mixed up for this matrix only",
                      [](MatrixSetup& s) { return transpose(s.view); }},
    ConventionMistake{SetupChange::kTransposeProjection, "transpose-projection",
                      "transpose the projection",
                      "rows and columns are mixed up for this matrix only",
                      [](MatrixSetup& s) { return transpose(s.projection); }},
    ConventionMistake{SetupChange::kExchangeViewProjection, "exchange-view-projection",
                      "exchange view and projection",
                      "check the order of the factors in your program",
                      [](MatrixSetup& s) { return exchange(s.view, s.projection); }},
    ConventionMistake{SetupChange::kDegrees, "degrees", "read the angle of view as degrees",
                      "pass the angle in radians",
                      [](MatrixSetup& s) {
                        return set_angle(s.projection, &ProjectionFacts::degrees_taken_as_radians);
                      }},
    ConventionMistake{SetupChange::kRadians, "radians", "read the angle of view as radians",
                      "pass the angle in degrees",
                      [](MatrixSetup& s) {
                        return set_angle(s.projection, &ProjectionFacts::radians_taken_as_degrees);
                      }},
    ConventionMistake{SetupChange::kClearCorner, "clear-corner",
                      "set [3][3] of the projection to 0",
                      "start the projection from zeros, not from the identity",
                      [](MatrixSetup& s) {
                        if (!has_corner_left_over(s.projection)) return false;
                        s.projection = without_corner(s.projection);
                        return true;
                      }},
    ConventionMistake{SetupChange::kDepthRange, "depth-range", "clip z to the other range",
                      "make the projection for the range of depth that is clipped to (E16)",
                      [](MatrixSetup& s) {
                        s.dialect.z_from_minus_w = !s.dialect.z_from_minus_w;
                        return true;
                      }},
    ConventionMistake{SetupChange::kEyeHand, "eye-hand", "negate z between view and projection",
                      "handedness is mixed (E12): use the projection for the view's handedness",
                      [](MatrixSetup& s) {
                        s.projection.m[2] = -s.projection.m[2];
                        return true;
                      }},
    ConventionMistake{
        SetupChange::kTurnRound, "turn-round", "turn the camera round: negate x and z of the eye",
        "handedness is mixed (E12): use the view for the projection's handedness; the z axis of "
        "an eye that looks down -z is eye - target",
        [](MatrixSetup& s) {
          s.view.m = glm::dmat4(glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, -1)) * s.view.m;
          return s.view.given;
        }},
    ConventionMistake{SetupChange::kInvertView, "invert-view", "invert the view matrix",
                      "the matrix is the camera's pose, world from eye; a view is its inverse",
                      [](MatrixSetup& s) { return invert(s.view); }},
    ConventionMistake{
        SetupChange::kViewFactors, "view-factors",
        "exchange the view's factors: rotation * translation, not the reverse",
        "first translate the eye to the origin, then rotate: rotation * translation(-eye)",
        [](MatrixSetup& s) { return exchange_factors(s.view, false); }},
    ConventionMistake{SetupChange::kViewOffsetSign, "view-offset-sign",
                      "negate the view's translation",
                      "the world moves by minus the eye's position",
                      [](MatrixSetup& s) {
                        exchange_offset(s.view, glm::dmat3(-1));
                        return s.view.given;
                      }},
    ConventionMistake{SetupChange::kViewFactorsBack, "view-factors-back",
                      "exchange the view's factors: translation * rotation, not the reverse",
                      "first rotate, then move back, for a camera that circles the origin",
                      [](MatrixSetup& s) { return exchange_factors(s.view, true); }},
    ConventionMistake{
        SetupChange::kModelFactors, "model-factors",
        "exchange the model's factors: rotation * translation, not the reverse",
        "the matrix next to the vertex acts first; translation * rotation rotates about the "
        "object's own origin (C-19)",
        [](MatrixSetup& s) { return exchange_factors(s.model, false); }},
    ConventionMistake{
        SetupChange::kModelFactorsBack, "model-factors-back",
        "exchange the model's factors: translation * rotation, not the reverse",
        "the matrix next to the vertex acts first; translation * rotation rotates about the "
        "object's own origin (C-19)",
        [](MatrixSetup& s) { return exchange_factors(s.model, true); }},
    ConventionMistake{SetupChange::kInvertModel, "invert-model", "invert the model matrix",
                      "the given matrix is object from world, not world from object",
                      [](MatrixSetup& s) { return invert(s.model); }},
    ConventionMistake{SetupChange::kExchangeModelView, "exchange-model-view",
                      "exchange model and view",
                      "check the order of the factors in your program: projection * view * model",
                      [](MatrixSetup& s) { return exchange(s.model, s.view); }},
    ConventionMistake{SetupChange::kFlipX, "flip-x", "mirror the picture left to right",
                      "look for a negated right axis, or world and eye of opposite handedness (E7)",
                      [](MatrixSetup& s) { return negate_row(s.projection, 0); }},
    ConventionMistake{
        SetupChange::kFlipY, "flip-y", "flip y of the window",
        "the window's y is counted from the other edge, or the picture is upside down",
        [](MatrixSetup& s) { return negate_row(s.projection, 1); }},
};

}  // namespace

std::span<const ConventionMistake> convention_mistakes() {
  return kConventionMistakes;
}

}  // namespace glassbox
