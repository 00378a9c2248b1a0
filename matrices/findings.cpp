#include <glassbox/matrices/findings.h>

#include <cmath>

#include <glm/geometric.hpp>

#include <glassbox/base/trig.h>
#include <glassbox/matrices/decimal.h>
#include <glassbox/matrices/projection_factors.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox {

bool has_last_row_of_zeros(const glm::dmat4& m) {
  for (int column = 0; column < 4; ++column) {
    if (entry_at(m, 3, column) != 0) return false;
  }
  return true;
}

void alarm_last_row(const char* name, const glm::dmat4& m, const std::string& remedy,
                    Findings& found) {
  found.alarm("singular", name,
              "its last row is 0 0 0 0: it is singular (its rank is " + std::to_string(rank_of(m)) +
                  "), and it makes w 0 for every point",
              "fill in the last row: " + remedy);
}

namespace {

// The angles between the first and second, second and third, and third and first vector, in
// degrees.
std::string angles_text(const glm::dmat3& axes) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 &a = axes[i], &b = axes[(i + 1) % 3];
    const double angle =
        degrees_from_radians(arctan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
    text += (i == 0 ? "" : i == 1 ? ", " : " and ") + short_number(angle, 4);
  }
  return text;
}

bool is_finite(const char* name, const GivenMatrix& matrix, Findings& found) {
  const auto entry = first_not_finite(matrix.m);
  if (!entry) return true;
  found.alarm("not-finite", name,
              "entry [" + std::to_string(entry->row) + "][" + std::to_string(entry->column) +
                  "] is " + short_number(entry_at(matrix.m, entry->row, entry->column)),
              "look for a division 0/0: eye = target, up along the gaze (the cross product of "
              "parallel vectors is 0, E8), near = far, or a width or height of 0");
  return false;
}

bool roles_are_exchanged(const MatrixSetup& setup, Findings& found) {
  const bool view_projects = !matrix_facts(setup.view.m).affine &&
                             projection_facts(setup.view).kind == ProjectionKind::kPerspective;
  if (!view_projects || !setup.projection.given || !matrix_facts(setup.projection.m).affine) {
    return false;
  }
  found.alarm("exchanged", "",
              "the matrix given as view is a perspective projection, and the one given as "
              "projection is affine, as a view is",
              "exchange --view and --proj, and check the order of the factors in your program");
  return true;
}

// Checks whether a model or view matrix is affine.
bool check_affine(const char* name, const MatrixFacts& facts, const GivenMatrix& matrix,
                  Findings& found) {
  if (facts.affine) return true;
  const std::string last_row = row_text(matrix.m, 3);
  if (has_last_row_of_zeros(matrix.m)) {
    alarm_last_row(name, matrix.m, "it should be 0 0 0 1", found);
  } else if (facts.affine_transposed) {
    found.alarm("transposed", name,
                "its last column is 0 0 0 1 and its last row " + last_row +
                    ": it looks transposed, columns read as rows or a matrix for row vectors (E10)",
                "read it in the other --order; where your program uses it as it is, transpose it");
  } else if (projection_facts(matrix).kind == ProjectionKind::kPerspective) {
    found.alarm(
        "is-a-projection", name,
        "its last row is " + last_row + ": this is a perspective projection",
        std::string("pass it as --proj, and check whether your program uses it as ") + name);
  } else if (projection_facts(transposed(matrix)).kind == ProjectionKind::kPerspective) {
    found.alarm("is-a-projection", name, "this is a perspective projection, transposed",
                "pass it as --proj, in the other --order");
  } else if (factor_projection(matrix)) {
    found.alarm("is-a-projection", name, "it is the product of a projection and a view",
                "pass it as --proj");
  } else {
    found.alarm(
        "not-affine", name,
        "its last row is " + last_row + " instead of 0 0 0 1, so that w does not stay 1 (E10)",
        std::string("a ") + name +
            " matrix only rotates, scales and translates: find what else is in it");
  }
  return false;
}

// Checks whether the matrix given as the view could be the camera's pose, the inverse of a view. A
// look-at camera has a horizontal right axis. If this holds only for the inverse of the matrix, and
// the camera's position is also rounder with the inverse, the matrix is probably the pose.
void check_pose(const GivenMatrix& view, Findings& found) {
  const auto inverse = affine::inverse(view.m);
  const auto eye = eyepoint_of(view);
  if (!inverse || !eye) return;
  const auto as_pose = eyepoint_of({*inverse, view.uncertainty, true});
  if (!as_pose || eye->level || !as_pose->level || as_pose->digits + 3 > eye->digits) return;
  found.hint("pose", "view",
             "its translation " + short_vector_text(glm::dvec3(view.m[3])) +
                 " looks like the camera's position, and its first column is horizontal: it may be "
                 "the camera's pose, world from eye",
             "a view matrix is the inverse of the pose");
}

// Checks whether the translation could be minus the eye's position, which was not rotated: [R | -e]
// for [R | -R e]. Then its numbers are rounder than those of the eye. A camera that circles a point
// moves along z only.
void check_offset(const GivenMatrix& view, const MatrixFacts& facts, Findings& found) {
  constexpr int kRound = 7, kRounder = 4;  // digits of three coordinates together
  const auto eye = eyepoint_of(view);
  if (!eye || !eye->level || !facts.rotation) return;
  int digits = 0;
  for (int row = 0; row < 3; ++row) {
    digits += simplest_decimal(view.m[3][row], view.uncertainty[3][row]).digits;
  }
  const bool along_z = std::abs(facts.translation.x) <= view.uncertainty[3][0] &&
                       std::abs(facts.translation.y) <= view.uncertainty[3][1];
  if (along_z || digits > kRound || digits + kRounder > eye->digits) return;
  found.hint(
      "offset-not-rotated", "view",
      "its translation " + short_vector_text(facts.translation) +
          " has rounder numbers than the eye's position, " + position_text(*eye) +
          ": it may be minus the eye's position, not rotated",
      "the last column is -R eye: rotation * translation(-eye), with the translation next to "
      "the vertex");
}

// How the axes of a view differ from perpendicular unit vectors.
std::string axes_text(const MatrixFacts& facts, const glm::dmat4& view) {
  const glm::dmat3 rows = glm::transpose(glm::dmat3(view));
  switch (facts.shape) {
    case MatrixShape::kSimilarity:
      return "its axes are perpendicular, but they are scaled by " +
             short_number(facts.scale.x, 4) + ": lengths in eye space are not those of the world";
    case MatrixShape::kScaled:
      return "the world's axes stay perpendicular, but they are scaled by " +
             short_vector_text(facts.scale, 4);
    case MatrixShape::kScaledAfter:
      return "its axes are perpendicular, but they are scaled by " +
             short_vector_text({glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2])},
                               4);
    default:
      return "its axes are not perpendicular: the angles between them are " + angles_text(rows) +
             " degrees";
  }
}

void check_world(const MatrixSetup& setup, Findings& found) {
  const auto drawn = drawn_handedness(setup);
  if (!drawn || (setup.world && *setup.world == *drawn)) return;
  const bool right = *drawn == Handedness::kRight;
  const std::string drawn_word = right ? "right" : "left", other_word = right ? "left" : "right";
  const std::string cause = "view and projection draw a " + drawn_word +
                            "-handed world as it is; a " + other_word +
                            "-handed one is mirrored left to right";
  if (!setup.world) {
    found.note("world-hand", "", cause + (right ? "" : " (E7)"), "");
  } else {
    found.alarm("world-mirrored", "",
                cause + (right ? "" : ", as with a gaze that was turned to +z (E7)") +
                    ". Your world is " + other_word + "-handed",
                right ? "use the look-at and projection for left-handed worlds, or negate one axis "
                        "of the world"
                      : "turn the gaze to -z and use a projection with w = -z, or negate x once");
  }
}

}  // namespace

void check_model(const MatrixSetup& setup, Findings& found) {
  const MatrixFacts facts = matrix_facts(setup.model.m);
  if (!check_affine("model", facts, setup.model, found)) return;
  if (facts.shape == MatrixShape::kFlat) {
    found.hint("singular", "model",
               "its determinant is " + short_number(facts.determinant) +
                   ": it flattens objects and has no inverse (C-18)",
               "look for a scale of 0; normals need the cofactor matrix then");
  } else if (facts.mirror()) {
    found.hint("mirror", "model",
               "its determinant is " + short_number(facts.determinant) +
                   ", negative: it mirrors, and front faces become back faces (C-17, E18)",
               "reverse the winding for this object, or look for a negative scale");
  }
  if (facts.shape == MatrixShape::kScaledAfter) {
    found.hint("scale-after-rotation", "model",
               "its rows are perpendicular and its columns are not: a scale along fixed axes after "
               "a rotation, which shears the object",
               "scale first: translation * rotation * scale, with the scale next to the vertex");
  }
}

void check_view(const MatrixSetup& setup, Findings& found) {
  const MatrixFacts facts = matrix_facts(setup.view.m);
  if (!check_affine("view", facts, setup.view, found)) return;
  if (facts.shape == MatrixShape::kFlat) {
    return found.alarm(
        "singular", "view",
        "its determinant is " + short_number(facts.determinant) + ": it flattens the world",
        "look for a zero axis: up along the gaze, or a vector that was not normalised");
  }
  if (facts.mirror() && !setup.world) {
    found.hint("mirror", "view",
               "its determinant is " + short_number(facts.determinant) +
                   ", negative: world and eye have opposite handedness",
               "this is right if one of them is left-handed on purpose (as for Unity's "
               "worldToCameraMatrix): then give --world; otherwise the picture is mirrored: look "
               "for an axis with the wrong sign");
  }
  if (!facts.rigid() && facts.shape != MatrixShape::kRigid) {
    found.hint("not-rigid", "view", axes_text(facts, setup.view.m),
               "normalise gaze, right and up; scales belong in the model matrix");
  }
  check_pose(setup.view, found);
  check_offset(setup.view, facts, found);
}

std::vector<Finding> check_matrices(const MatrixSetup& setup) {
  Findings found;
  const bool model = is_finite("model", setup.model, found);
  const bool view = is_finite("view", setup.view, found);
  const bool projection = is_finite("projection", setup.projection, found);
  const bool all = model && view && projection;
  if (all && roles_are_exchanged(setup, found)) return found.list();
  if (model) check_model(setup, found);
  if (view) check_view(setup, found);
  if (projection) check_projection(setup, found);
  if (all) check_world(setup, found);
  return found.list();
}

}  // namespace glassbox
