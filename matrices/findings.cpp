#include <glassbox/matrices/findings.h>

#include <glassbox/matrices/decimal.h>
#include <glassbox/matrices/projection_factors.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox {
namespace {

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
  if (facts.affine_transposed) {
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
    found.hint("not-rigid", "view",
               "its axes are not perpendicular unit vectors (off by " +
                   short_number(facts.orthogonality, 3) + ")",
               "normalise gaze, right and up; scales belong in the model matrix");
  }
  check_pose(setup.view, found);
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
