#include <glassbox/pipeline/matrix_findings.h>

#include <cmath>

#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/decimal.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {
namespace {

std::string row_text(const glm::dmat4& m, int row) {
  std::string text;
  for (int column = 0; column < 4; ++column) {
    text += (column == 0 ? "(" : ", ") + brief(m[column][row]);
  }
  return text + ")";
}

class Findings {
public:
  explicit Findings(const MatrixSetup& setup)
      : setup_(setup),
        model_(facts_of(setup.model.m)),
        view_(facts_of(setup.view.m)),
        projection_(facts_of(setup.projection.m)),
        lens_(projection_facts(setup.projection, setup.dialect.depth)) {}

  std::vector<Finding> all() {
    const bool model = is_usable("model", setup_.model);
    const bool view = is_usable("view", setup_.view);
    const bool projection = is_usable("projection", setup_.projection);
    if (model && view && projection && roles_are_exchanged()) return found_;
    if (model) check_model();
    if (view) check_view();
    if (projection) check_projection();
    if (model && view && projection) check_world();
    return found_;
  }

private:
  void add(Severity severity, const char* id, const char* matrix, std::string cause,
           std::string remedy) {
    found_.push_back({severity, id, matrix, std::move(cause), std::move(remedy)});
  }
  void alarm(const char* id, const char* matrix, std::string cause, std::string remedy) {
    add(Severity::kAlarm, id, matrix, std::move(cause), std::move(remedy));
  }
  void hint(const char* id, const char* matrix, std::string cause, std::string remedy) {
    add(Severity::kHint, id, matrix, std::move(cause), std::move(remedy));
  }

  bool is_usable(const char* name, const GivenMatrix& matrix) {
    const auto entry = first_not_finite(matrix.m);
    if (!entry) return true;
    alarm(
        "not-finite", name,
        "entry [" + std::to_string(entry->row) + "][" + std::to_string(entry->column) + "] is " +
            brief(matrix.m[entry->column][entry->row]),
        "look for a division by zero or a normalised zero vector: eye = target, up along the gaze, "
        "near = far, a width or height of 0");
    return false;
  }

  bool roles_are_exchanged() {
    const bool view_projects =
        !view_.affine && projection_facts(setup_.view).kind == ProjectionKind::kPerspective;
    if (!view_projects || !projection_.affine || !setup_.projection.given) return false;
    alarm(
        "exchanged", "",
        "the matrix given as view is a perspective projection, and the one given as projection is "
        "affine, as a view is",
        "exchange --view and --proj, and look at the order of the factors in your program");
    return true;
  }

  // What model and view have in common: true if the matrix is affine.
  bool check_affine(const char* name, const MatrixFacts& facts, const GivenMatrix& matrix) {
    if (facts.affine) return true;
    const std::string last_row = row_text(matrix.m, 3);
    if (facts.affine_transposed) {
      alarm("transposed", name,
            "its last column is 0 0 0 1 and its last row " + last_row +
                ": it looks transposed, columns read as rows or a matrix for row vectors",
            "read it in the other --order; where your program uses it as it is, transpose it");
    } else if (projection_facts(matrix).kind == ProjectionKind::kPerspective) {
      alarm("is-a-projection", name,
            "its last row is " + last_row + ": this is a perspective projection",
            std::string("pass it as --proj, and look whether your program uses it as ") + name);
    } else if (projection_facts(transposed(matrix)).kind == ProjectionKind::kPerspective) {
      alarm("is-a-projection", name, "this is a perspective projection, transposed",
            "pass it as --proj, in the other --order");
    } else {
      alarm("not-affine", name,
            "its last row is " + last_row + " instead of 0 0 0 1, so that w does not stay 1",
            std::string("a ") + name +
                " matrix only turns, scales and moves: look what else is in it");
    }
    return false;
  }

  void check_model() {
    if (!check_affine("model", model_, setup_.model)) return;
    if (model_.shape == Shape::kFlat) {
      hint("singular", "model",
           "its determinant is " + brief(model_.determinant) +
               ": it flattens objects and has no inverse (C-18)",
           "look for a scale of 0; normals need the cofactor matrix then");
    } else if (model_.mirror()) {
      hint("mirror", "model",
           "its determinant is " + brief(model_.determinant) +
               ", negative: it mirrors, and front faces become back faces (C-17)",
           "turn the winding for this object, or look for a negative scale");
    }
    if (model_.shape == Shape::kScaledAfter) {
      hint("scale-after-rotation", "model",
           "its rows are perpendicular and its columns are not: a scale along fixed axes after a "
           "rotation, which shears the object",
           "scale first: T * R * S, with S next to the vertex");
    }
  }

  void check_view() {
    if (!check_affine("view", view_, setup_.view)) return;
    if (view_.shape == Shape::kFlat) {
      return alarm("singular", "view",
                   "its determinant is " + brief(view_.determinant) + ": it flattens the world",
                   "look for a zero axis: up along the gaze, or a vector that was not normalised");
    }
    if (view_.mirror()) {
      hint("mirror", "view",
           "its determinant is " + brief(view_.determinant) +
               ", negative: world and eye are of opposite hands",
           "right if one of them is left-handed on purpose (Unity's worldToCameraMatrix is such); "
           "otherwise the picture is mirrored: look for an axis with the wrong sign");
    }
    if (!view_.rigid() && view_.shape != Shape::kRigid) {
      hint("not-rigid", "view",
           "its axes are not perpendicular unit vectors (off by " + brief(view_.orthogonality, 3) +
               ")",
           "normalise gaze, right and up; scales belong into the model matrix");
    }
    check_pose();
  }

  // A look-at camera has its right axis horizontal. Where only the inverse has, and a rounder position too, the matrix is
  // probably the camera's pose.
  void check_pose() {
    const auto inverse = affine::inverse(setup_.view.m);
    const auto eye = eyepoint_of(setup_.view);
    if (!inverse || !eye) return;
    const auto as_pose = eyepoint_of({*inverse, setup_.view.uncertainty, true});
    if (!as_pose || eye->level || !as_pose->level || as_pose->digits + 3 > eye->digits) return;
    const glm::dvec3 t = view_.translation;
    hint("pose", "view",
         "its translation " + brief_triple(t.x, t.y, t.z) +
             " looks like the camera's position, and its first column is level: it may be the "
             "camera's pose, world from eye",
         "a view matrix is the inverse of the pose");
  }

  void check_projection() {
    const GivenMatrix& given = setup_.projection;
    if (lens_.kind == ProjectionKind::kNone || lens_.looks_transposed) {
      return check_unknown_projection();
    }
    const bool leftover = lens_.kind == ProjectionKind::kPerspective && lens_.w_offset != 0;
    if (leftover && given.m[3][3] == 1) {
      alarm("w-leftover", "projection",
            "[3][3] is 1, so that w is not the distance but " +
                std::string(lens_.looks_down_minus_z ? "1 - z" : "1 + z"),
            "a perspective projection has 0 there: clear the identity before you fill it in");
    } else if (leftover) {
      note_view_inside();
    }
    check_depth();
    if (lens_.kind == ProjectionKind::kPerspective) check_angle();
    check_flips();
    check_aspect();
  }

  void check_unknown_projection() {
    const GivenMatrix& given = setup_.projection;
    const GivenMatrix turned = transposed(given);
    if (is_view_times_projection(given.m)) {
      return alarm("factors-exchanged", "projection",
                   "it has the structure of view * projection: the view was applied after the "
                   "projection",
                   "multiply projection * view * model for column vectors; the matrix next to the "
                   "vertex acts first");
    }
    if (projection_.rigid()) {
      return alarm("is-a-view", "projection",
                   "it is a rotation and a translation, as view or model matrices are",
                   "pass it as --view");
    }
    const bool transposed_projection =
        projection_facts(turned).kind == ProjectionKind::kPerspective ||
        (projection_.affine_transposed && !projection_.affine);
    if (transposed_projection) {
      return alarm(
          "transposed", "projection",
          projection_.affine_transposed
              ? "its last column is 0 0 0 1 and its last row " + row_text(given.m, 3) +
                    ": it looks transposed"
              : "the -1 or 1 that makes w stands in the last column, not in the last row: "
                "it looks transposed",
          "read it in the other --order; where your program uses it as it is, transpose it");
    }
    if (factor_projection(given)) return note_view_inside();
    if (factor_projection(turned)) {
      return alarm(
          "transposed", "projection",
          "transposed, it is a projection with a view in it; as it stands it is none",
          "read it in the other --order; where your program uses it as it is, transpose it");
    }
    alarm(
        "no-projection", "projection",
        projection_.rank < 4
            ? "it is no projection: its rank is " + std::to_string(projection_.rank)
            : std::string("it is no projection: x and y are not scaled on their own, or w depends "
                          "on them"),
        "compare it with the table in docs/step.md, entry by entry");
  }

  void note_view_inside() {
    const bool twice = setup_.view.given && view_.shape != Shape::kIdentity;
    add(twice ? Severity::kHint : Severity::kNote, "contains-view", "projection",
        twice ? "a view is in it already, and another was given: the camera acts twice"
              : "it is a projection and a view in one",
        twice ? "give the projection alone, or leave out --view"
              : "pass the two apart to see more");
  }

  void check_depth() {
    if (lens_.depth_lost) {
      return alarm("depth-lost", "projection",
                   "every distance gets the same depth, " + brief(lens_.alpha + lens_.beta) +
                       "; its rank is " + std::to_string(projection_.rank) +
                       ": it can draw, but a depth buffer cannot hide anything (E15)",
                   "give the z row two numbers made from near and far; near must not be 0");
    }
    if (lens_.oblique_depth) {
      add(Severity::kNote, "oblique-depth", "projection",
          "depth depends on x and y: the near plane is tilted", "");
      return;
    }
    const bool reversed = lens_.depth_reversed();
    const bool expected = setup_.dialect.depth == DepthRange::kReversed;
    const DepthReading& ours =
        setup_.dialect.z_from_minus_w ? lens_.minus_one_to_one : lens_.zero_to_one;
    const DepthReading& other =
        setup_.dialect.z_from_minus_w ? lens_.zero_to_one : lens_.minus_one_to_one;
    if (!ours.possible && !other.possible) {
      return alarm("planes", "projection",
                   "no near and far plane in front of the eye give these entries: they would be " +
                       brief(ours.near) + " and " + brief(ours.far),
                   "near and far are distances along the gaze, 0 < near < far");
    }
    if (reversed != expected) {
      return alarm(
          "depth-direction", "projection",
          reversed ? "depth falls with distance, but " + std::string(setup_.dialect.title) +
                         " takes the smaller depth for the nearer one: far surfaces hide near ones"
                   : "depth grows with distance, but reversed depth wants 1 at the near plane",
          reversed
              ? "say --dialect reversed if that is meant (compare with GREATER, clear to 0); "
                "otherwise near and far are exchanged"
              : "exchange near and far in the projection, or say which dialect it was made for");
    }
    const DepthReading* likely = lens_.likely_range();
    if (likely == &other && (!ours.possible || other.digits <= 6)) {
      const char* range = setup_.dialect.z_from_minus_w ? "0 .. 1" : "-1 .. 1";
      const std::string cost = setup_.dialect.z_from_minus_w
                                   ? "half of the depth buffer is wasted, and what lies in front "
                                     "of the near plane may show"
                                   : "everything nearer than " + brief(ours.near) + " is clipped";
      return alarm(
          "z-range", "projection",
          "it seems made for depth " + std::string(range) + ": then it has " + planes_text(other) +
              (ours.possible
                   ? ", round numbers; read for " + std::string(setup_.dialect.title) +
                         " they are " + planes_text(ours) + ". As it is, " + cost + " (E16)"
                   : "; for " + std::string(setup_.dialect.title) + " there are no planes (E16)"),
          setup_.dialect.z_from_minus_w
              ? "make it for depth -1 .. 1, or say --dialect d3d or vulkan"
              : "make it for depth 0 .. 1 (GLM: define GLM_FORCE_DEPTH_ZERO_TO_ONE)");
    }
  }

  void check_angle() {
    if (lens_.degrees_taken_as_radians) {
      const std::string degrees = std::to_string(*lens_.degrees_taken_as_radians);
      alarm("degrees-as-radians", "projection",
            "[1][1] = " + brief(lens_.scale.y) + " is the cotangent of half of " + degrees +
                " radians: " + degrees + " degrees were taken for radians" +
                (lens_.scale.y > 0 ? ", which makes " + brief(lens_.fovy_degrees, 4) + " degrees"
                                   : ", which turns the picture round"),
            "pass radians(" + degrees + ")");
    } else if (lens_.radians_taken_as_degrees) {
      const std::string degrees = std::to_string(*lens_.radians_taken_as_degrees);
      alarm("radians-as-degrees", "projection",
            "its angle of view is " + brief(lens_.fovy_degrees, 4) + " degrees, which is " +
                degrees + " degrees in radians: radians were taken for degrees",
            "pass " + degrees);
    }
  }

  void check_flips() {
    if (lens_.degrees_taken_as_radians) return;  // has said so
    const bool x_flipped = lens_.scale.x < 0;
    const bool y_flipped = (lens_.scale.y < 0) != setup_.dialect.ndc_y_down;
    if (x_flipped && y_flipped) {
      alarm("turned-round", "projection", "[0][0] and [1][1] turn the picture by 180 degrees",
            "look for a negative near plane or an angle of view beyond 180 degrees");
    } else if (x_flipped) {
      alarm("mirrored", "projection", "[0][0] is negative: the picture is mirrored left to right",
            "look for left and right exchanged");
    } else if (y_flipped && setup_.dialect.ndc_y_down) {
      hint("upside-down", "projection",
           "[1][1] is positive, and " + std::string(setup_.dialect.title) +
               " has y pointing down: the picture is upside down",
           "negate [1][1], or use a viewport of negative height");
    } else if (y_flipped) {
      alarm("upside-down", "projection", "[1][1] is negative: the picture is upside down",
            "right for Vulkan only; otherwise look for top and bottom exchanged");
    }
  }

  void check_aspect() {
    if (!setup_.picture) return;
    const int width = setup_.picture->x, height = setup_.picture->y;
    const double wanted = double(width) / height;
    const auto is = [&](double aspect) { return std::abs(lens_.aspect / aspect - 1) <= 0.01; };
    if (is(wanted)) return;
    std::string why = ", but the picture's is " + brief(wanted, 4) + ": circles become ellipses";
    std::string remedy = "pass width/height";
    if (is(height / double(width))) {
      why += "; it is height/width";
    } else if (width / height >= 1 && is(width / height)) {
      why += "; " + std::to_string(width) + "/" + std::to_string(height) + " in integers is " +
             std::to_string(width / height);
      remedy = "divide as floats";
    }
    hint("aspect", "projection", "its aspect ratio is " + brief(lens_.aspect, 4) + why, remedy);
  }

  void check_world() {
    const auto drawn = world_drawn(setup_);
    if (!drawn) return;
    const bool right = *drawn == Hand::kRight;
    const std::string drawn_word = right ? "right" : "left", other_word = right ? "left" : "right";
    const std::string cause = "view and projection draw a " + drawn_word +
                              "-handed world as it is; a " + other_word +
                              "-handed one is mirrored left to right";
    if (setup_.world && *setup_.world != *drawn) {
      alarm("world-mirrored", "",
            cause + (right ? "" : ", as with a gaze that was turned to +z (E7)") +
                ". Your world is " + other_word + "-handed",
            right
                ? "use the look-at and projection for left-handed worlds, or turn one axis of the "
                  "world"
                : "turn the gaze to -z and use a projection with w = -z, or negate x once");
    } else {
      add(Severity::kNote, "world-hand", "", cause + (right ? "" : " (E7)"), "");
    }
  }

  const MatrixSetup& setup_;
  const MatrixFacts model_, view_, projection_;
  const ProjectionFacts lens_;
  std::vector<Finding> found_;
};

}  // namespace

std::vector<Finding> check_matrices(const MatrixSetup& setup) {
  return Findings(setup).all();
}

std::optional<Hand> world_drawn(const MatrixSetup& setup) {
  const MatrixFacts view = facts_of(setup.view.m);
  const GivenMatrix part = projection_part(setup.projection);
  const ProjectionFacts lens = projection_facts(part, setup.dialect.depth);
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
