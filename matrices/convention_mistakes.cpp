#include <glassbox/matrices/convention_mistakes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include <glassbox/base/trig.h>
#include <glassbox/matrices/projection_factors.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox {
namespace {

using Points = std::span<const glm::dvec4>;

void exchange_offset(GivenMatrix& matrix, const glm::dmat3& by) {
  const glm::dvec3 moved = by * glm::dvec3(matrix.m[3]);
  matrix.m[3] = glm::dvec4(moved, matrix.m[3].w);
}

// The inverse of an affine matrix that was given; nothing if there is none.
std::optional<glm::dmat4> inverse_of(const GivenMatrix& matrix) {
  if (!matrix.given || !matrix_facts(matrix.m).invertible()) return std::nullopt;
  const auto inverse = affine::inverse(matrix.m);
  return inverse ? std::optional(*inverse) : std::nullopt;
}

bool invert(GivenMatrix& matrix) {
  const auto inverse = inverse_of(matrix);
  if (!inverse) return false;
  matrix.m = *inverse;
  return true;
}

// Replaces the last column t of an affine matrix with the upper 3x3 part A by A t, or by A^-1 t if
// `back`.
bool exchange_factors(GivenMatrix& matrix, bool back) {
  const auto inverse = inverse_of(matrix);
  if (!inverse) return false;
  exchange_offset(matrix, back ? glm::dmat3(*inverse) : glm::dmat3(matrix.m));
  return true;
}

// Divides by the scale of a matrix that scales all directions alike.
bool remove_scale(GivenMatrix& matrix) {
  const MatrixFacts facts = matrix_facts(matrix.m);
  if (!matrix.given || facts.shape != MatrixShape::kSimilarity) return false;
  for (int column = 0; column < 4; ++column) {
    glm::dvec4& entries = matrix.m[column];
    entries = glm::dvec4(glm::dvec3(entries) / facts.scale.x, entries.w);
  }
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

// The middle of the points in the world, and the largest distance of a point from there.
struct Crowd {
  glm::dvec3 middle{0};
  double radius = 0;
};

Crowd crowd_of(const MatrixSetup& setup, Points points) {
  Crowd crowd;
  for (const glm::dvec4& point : points) {
    crowd.middle += glm::dvec3(setup.model.m * point) / double(points.size());
  }
  for (const glm::dvec4& point : points) {
    crowd.radius =
        std::max(crowd.radius, glm::distance(crowd.middle, glm::dvec3(setup.model.m * point)));
  }
  return crowd;
}

// The distance from which a perspective projection shows a ball of this radius; nothing if its
// planes do not allow this.
std::optional<double> distance_to_show(const MatrixSetup& setup, double radius) {
  const ProjectionFacts lens = projection_facts(setup.projection, setup.dialect.depth);
  const DepthReading& planes =
      setup.dialect.z_from_minus_w ? lens.minus_one_to_one : lens.zero_to_one;
  if (lens.kind != ProjectionKind::kPerspective || !planes.possible) return std::nullopt;
  const double scale = std::max(std::abs(lens.scale.x), std::abs(lens.scale.y));
  const double fitting = 1.1 * radius * std::sqrt(1 + scale * scale);
  const double distance = std::max(fitting, radius + 2 * planes.near);
  if (!(distance + radius < planes.far)) return std::nullopt;
  return distance;
}

// If eye and target of a look-at were exchanged, the eye stands at the target, so among the points,
// and looks at the place where it should stand. How far away this is, the matrix does not tell: the
// distance is chosen so that the points are visible.
bool swap_look_at(MatrixSetup& setup, Points points) {
  const auto eye = eyepoint_of(setup.view);
  if (!setup.view.given || !matrix_facts(setup.view.m).rigid() || !eye) return false;
  const Crowd crowd = crowd_of(setup, points);
  const double off = glm::distance(eye->position, crowd.middle);
  const bool at_origin =
      eye->digits == 0 && matrix_facts(setup.view.m).shape != MatrixShape::kIdentity;
  if (!at_origin && off > std::max(crowd.radius, eye->uncertainty)) return false;
  const auto distance = distance_to_show(setup, crowd.radius + off);
  if (!distance) return false;
  setup.view.m = glm::dmat4(glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, -1)) * setup.view.m;
  const ProjectionFacts lens = projection_facts(setup.projection, setup.dialect.depth);
  setup.view.m[3].z += lens.looks_down_minus_z ? -*distance : *distance;
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
        [](MatrixSetup& s, Points) {
          const bool model = transpose(s.model), view = transpose(s.view);
          return transpose(s.projection) || model || view;
        }},
    ConventionMistake{SetupChange::kTransposeModel, "transpose-model", "transpose the model matrix",
                      "rows and columns are mixed up for this matrix only",
                      [](MatrixSetup& s, Points) { return transpose(s.model); }},
    ConventionMistake{SetupChange::kTransposeView, "transpose-view", "transpose the view matrix",
                      "rows and columns are mixed up for this matrix only",
                      [](MatrixSetup& s, Points) { return transpose(s.view); }},
    ConventionMistake{SetupChange::kTransposeProjection, "transpose-projection",
                      "transpose the projection",
                      "rows and columns are mixed up for this matrix only",
                      [](MatrixSetup& s, Points) { return transpose(s.projection); }},
    ConventionMistake{SetupChange::kExchangeViewProjection, "exchange-view-projection",
                      "exchange view and projection",
                      "check the order of the factors in your program",
                      [](MatrixSetup& s, Points) { return exchange(s.view, s.projection); }},
    ConventionMistake{SetupChange::kDegrees, "degrees", "read the angle of view as degrees",
                      "pass the angle in radians",
                      [](MatrixSetup& s, Points) {
                        return set_angle(s.projection, &ProjectionFacts::degrees_taken_as_radians);
                      }},
    ConventionMistake{SetupChange::kRadians, "radians", "read the angle of view as radians",
                      "pass the angle in degrees",
                      [](MatrixSetup& s, Points) {
                        return set_angle(s.projection, &ProjectionFacts::radians_taken_as_degrees);
                      }},
    ConventionMistake{SetupChange::kClearCorner, "clear-corner",
                      "set [3][3] of the projection to 0",
                      "start the projection from zeros, not from the identity",
                      [](MatrixSetup& s, Points) {
                        if (!has_corner_left_over(s.projection)) return false;
                        s.projection = without_corner(s.projection);
                        return true;
                      }},
    ConventionMistake{SetupChange::kDepthRange, "depth-range", "clip z to the other range",
                      "make the projection for the range of depth that is clipped to (E16)",
                      [](MatrixSetup& s, Points) {
                        s.dialect.z_from_minus_w = !s.dialect.z_from_minus_w;
                        return true;
                      }},
    ConventionMistake{SetupChange::kEyeHand, "eye-hand", "negate z between view and projection",
                      "handedness is mixed (E12): use the projection for the view's handedness",
                      [](MatrixSetup& s, Points) {
                        s.projection.m[2] = -s.projection.m[2];
                        return true;
                      }},
    ConventionMistake{
        SetupChange::kTurnRound, "turn-round", "turn the camera round: negate x and z of the eye",
        "handedness is mixed (E12): use the view for the projection's handedness; the z axis of "
        "an eye that looks down -z is eye - target",
        [](MatrixSetup& s, Points) {
          s.view.m = glm::dmat4(glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, -1)) * s.view.m;
          return s.view.given;
        }},
    ConventionMistake{SetupChange::kInvertView, "invert-view", "invert the view matrix",
                      "the matrix is the camera's pose, world from eye; a view is its inverse",
                      [](MatrixSetup& s, Points) { return invert(s.view); }},
    ConventionMistake{SetupChange::kViewScale, "view-scale", "remove the scale from the view",
                      "normalise gaze, right and up; scales belong in the model matrix",
                      [](MatrixSetup& s, Points) { return remove_scale(s.view); }},
    ConventionMistake{
        SetupChange::kViewFactors, "view-factors",
        "exchange the view's factors: rotation * translation, not the reverse",
        "first translate the eye to the origin, then rotate: rotation * translation(-eye)",
        [](MatrixSetup& s, Points) { return exchange_factors(s.view, false); }},
    ConventionMistake{SetupChange::kViewOffsetSign, "view-offset-sign",
                      "negate the view's translation",
                      "the world moves by minus the eye's position",
                      [](MatrixSetup& s, Points) {
                        exchange_offset(s.view, glm::dmat3(-1));
                        return s.view.given;
                      }},
    ConventionMistake{SetupChange::kSwapLookAt, "swap-look-at",
                      "exchange eye and target of look-at",
                      "look-at takes the eye first and the target second; as given, the eye stands "
                      "among the points",
                      swap_look_at},
    ConventionMistake{SetupChange::kViewFactorsBack, "view-factors-back",
                      "exchange the view's factors: translation * rotation, not the reverse",
                      "first rotate, then move back, for a camera that circles the origin",
                      [](MatrixSetup& s, Points) { return exchange_factors(s.view, true); }},
    ConventionMistake{
        SetupChange::kModelFactors, "model-factors",
        "exchange the model's factors: rotation * translation, not the reverse",
        "the matrix next to the vertex acts first; translation * rotation rotates about the "
        "object's own origin (C-19)",
        [](MatrixSetup& s, Points) { return exchange_factors(s.model, false); }},
    ConventionMistake{
        SetupChange::kModelFactorsBack, "model-factors-back",
        "exchange the model's factors: translation * rotation, not the reverse",
        "the matrix next to the vertex acts first; translation * rotation rotates about the "
        "object's own origin (C-19)",
        [](MatrixSetup& s, Points) { return exchange_factors(s.model, true); }},
    ConventionMistake{SetupChange::kInvertModel, "invert-model", "invert the model matrix",
                      "the given matrix is object from world, not world from object",
                      [](MatrixSetup& s, Points) { return invert(s.model); }},
    ConventionMistake{SetupChange::kExchangeModelView, "exchange-model-view",
                      "exchange model and view",
                      "check the order of the factors in your program: projection * view * model",
                      [](MatrixSetup& s, Points) { return exchange(s.model, s.view); }},
    ConventionMistake{SetupChange::kFlipX, "flip-x", "mirror the picture left to right",
                      "look for a negated right axis, or world and eye of opposite handedness (E7)",
                      [](MatrixSetup& s, Points) { return negate_row(s.projection, 0); }},
    ConventionMistake{
        SetupChange::kFlipY, "flip-y", "flip y of the window",
        "the window's y is counted from the other edge, or the picture is upside down",
        [](MatrixSetup& s, Points) { return negate_row(s.projection, 1); }},
};

}  // namespace

std::span<const ConventionMistake> convention_mistakes() {
  return kConventionMistakes;
}

}  // namespace glassbox
