// Finds what is wrong with a projection: the part of findings.h about depth, angle and window.
#include <algorithm>
#include <cmath>

#include <glassbox/matrices/decimal.h>
#include <glassbox/matrices/findings.h>
#include <glassbox/matrices/projection_factors.h>

namespace glassbox {
namespace {

constexpr const char* kProjection = "projection";

void note_view_inside(const MatrixSetup& setup, Findings& found) {
  if (setup.view.given && matrix_facts(setup.view.m).shape != MatrixShape::kIdentity) {
    found.hint("contains-view", kProjection,
               "it already contains a view, and another one is given: the camera is applied twice",
               "give the projection alone, or leave out --view");
  } else {
    found.note("contains-view", kProjection, "it is the product of a projection and a view",
               "pass the two separately to see more");
  }
}

// Whether the matrix is P S^T instead of P S, where S is the skew of a stereo pair. Then depth and
// w = +-z contain x, although nothing is rotated.
bool has_transposed_skew(const glm::dmat4& m) {
  const bool x_and_y_are_scaled =
      is_small(m, 0, 1) && is_small(m, 0, 2) && is_small(m, 1, 0) && is_small(m, 1, 2);
  return x_and_y_are_scaled && !is_small(m, 3, 0) && !is_small(m, 2, 0) && is_small(m, 3, 1) &&
         is_small(m, 2, 1) && std::abs(std::abs(entry_at(m, 3, 2)) - 1) <= kSmall &&
         is_small(m, 3, 3) && !is_small(m, 2, 3);
}

// Whether a matrix of another kind was given as the projection by mistake. Reports it if so.
bool is_something_else(const GivenMatrix& given, Findings& found) {
  const MatrixFacts facts = matrix_facts(given.m);
  if (is_view_times_projection(given.m)) {
    found.alarm("factors-exchanged", kProjection,
                "it has the structure of view * projection: the view was applied after the "
                "projection",
                "multiply projection * view * model for column vectors; the matrix next to the "
                "vertex acts first");
  } else if (facts.rigid()) {
    found.alarm("is-a-view", kProjection,
                "it is a rotation and a translation, as view or model matrices are",
                "pass it as --view");
  } else if (has_transposed_skew(given.m)) {
    found.alarm(
        "skew-transposed", kProjection,
        "depth and w change with x, although nothing is rotated: a skew was transposed "
        "before it was multiplied in (E2)",
        "the skew's two entries belong in the first row, x' = x + s - (s/f) z, with the shift s "
        "and the distance f without parallax: in an array m[column][row] they are m[3][0] "
        "and m[2][0]");
  } else if (is_transposed_projection(given)) {
    found.alarm("transposed", kProjection,
                facts.affine_transposed ? "its last column is 0 0 0 1 and its last row " +
                                              row_text(given.m, 3) + ": it looks transposed (E10)"
                                        : "the coefficients of w (-1, 1 or the gaze) are in the "
                                          "last column, not in the last row: it looks transposed",
                "read it in the other --order; where your program uses it as it is, transpose it");
  } else {
    return false;
  }
  return true;
}

// Whether the matrix is P P for a perspective projection P. The last rows of P are (0, 0, A, B) and
// (0, 0, s, 0) with s = -1 or 1, so those of P P are (0, 0, A A + s B, A B) and (0, 0, s A, s B).
bool is_projection_twice(const GivenMatrix& given) {
  const glm::dmat4& m = given.m;
  double uncertainty = 0;
  for (const int row : {2, 3}) {
    if (!is_small(m, row, 0) || !is_small(m, row, 1) || is_small(m, row, 3)) return false;
    for (const int column : {2, 3}) {
      uncertainty = std::max(uncertainty, entry_at(given.uncertainty, row, column));
    }
  }
  const double a = entry_at(m, 3, 2), b = entry_at(m, 3, 3);
  const auto is = [&](double x, double y) {
    return std::abs(x - y) <= kSmall * std::abs(y) + 4 * uncertainty;
  };
  return is(entry_at(m, 2, 2), a * a + b) && is(entry_at(m, 2, 3), a * b);
}

void alarm_unknown(const GivenMatrix& given, Findings& found) {
  const int rank = rank_of(given.m);
  found.alarm(
      "no-projection", kProjection,
      rank < 4 ? "it is not a projection: its rank is " + std::to_string(rank) + ", not 4"
               : "it is not a projection: x and y are not scaled separately, or w depends on them",
      "compare it with the table in docs/step.md, entry by entry");
}

// ---- projections that contain a view ----

void check_offsets(const MatrixSetup& setup, const ProjectionFacts& lens, Findings& found) {
  if (lens.w_offset != 0) {
    if (!has_corner_left_over(setup.projection)) return note_view_inside(setup, found);
    return found.alarm("w-leftover", kProjection,
                       "[3][3] is 1, so that w is not the distance but " +
                           std::string(lens.looks_down_minus_z ? "1 - z" : "1 + z"),
                       "a perspective projection has 0 there: start from a matrix of zeros, not "
                       "from the identity");
  }
  if (lens.shift == glm::dvec2(0)) return;
  const auto without_parallax = lens.without_parallax();
  if (!without_parallax) return note_view_inside(setup, found);
  const std::string moved = short_number(-lens.shift.x / lens.scale.x);
  if (*without_parallax > 0) {
    found.note("stereo", kProjection,
               "one eye of a stereo pair: it is at x = " + moved + ", and points at the distance " +
                   short_number(*without_parallax, 5) + " have no parallax (S0-11)",
               "");
  } else {
    found.hint(
        "skew-sign", kProjection,
        "the eye moves to x = " + moved +
            " and the frustum leans further the same way: no point in front of it has zero "
            "parallax (E2)",
        "skew before the projection: projection * skew, where entry [0][2] of the skew is +s/f "
        "for an eye that looks down -z and -s/f for one that looks down +z (s: the shift, f: "
        "the distance without parallax)");
  }
}

// ---- depth ----

// The near and far planes, in words, if they become round when one entry or row is negated; empty
// if they do not.
std::string planes_after_repair(const MatrixSetup& setup) {
  struct Repair {
    const char* words;
    glm::dmat4 m;
  };
  const glm::dmat4& m = setup.projection.m;
  Repair repairs[] = {{"the last row negated", m}, {"[2][3] negated", m}, {"[2][2] negated", m}};
  for (int column = 0; column < 4; ++column) repairs[0].m[column][3] *= -1;
  repairs[1].m[3][2] *= -1;
  repairs[2].m[2][2] *= -1;
  for (const Repair& repair : repairs) {
    const ProjectionFacts lens = projection_facts({repair.m, setup.projection.uncertainty, true});
    if (const DepthReading* planes = lens.round_planes(setup.dialect.depth)) {
      return "; with " + std::string(repair.words) + " it has " + planes_text(*planes);
    }
  }
  return {};
}

void check_planes(const MatrixSetup& setup, const DepthReading& ours, const DepthReading& other,
                  Findings& found) {
  const DepthReading& rounder = other.digits + 3 <= ours.digits ? other : ours;
  found.alarm(
      "planes", kProjection,
      "no planes in front of the eye give these entries: they would be " + planes_text(rounder),
      "near and far are distances along the gaze, 0 < near < far" + planes_after_repair(setup));
}

void check_direction(const MatrixSetup& setup, bool falls, Findings& found) {
  if (falls) {
    found.alarm("depth-direction", kProjection,
                "depth falls with distance, but " + std::string(setup.dialect.title) +
                    " takes the smaller depth for the nearer one: far surfaces hide near ones",
                "give --dialect reversed if this is intended (compare with GREATER, clear to 0); "
                "otherwise near and far are exchanged");
  } else {
    found.alarm(
        "depth-direction", kProjection,
        "depth grows with distance, but reversed depth needs 1 at the near plane",
        "exchange near and far in the projection, or give the --dialect that it was made for");
  }
}

void check_range(const MatrixSetup& setup, const DepthReading& ours, const DepthReading& other,
                 Findings& found) {
  const bool from_minus_w = setup.dialect.z_from_minus_w;
  std::string cause = "it seems made for depth " +
                      std::string(from_minus_w ? "0 .. 1" : "-1 .. 1") + ": then it has " +
                      planes_text(other);
  if (!ours.possible) {
    cause +=
        "; read for " + std::string(setup.dialect.title) + " it has no near and far plane (E16)";
  } else {
    cause += ", which are round numbers; read for " + std::string(setup.dialect.title) +
             " they are " + planes_text(ours) + ". As it is, ";
    cause += from_minus_w
                 ? "half of the depth buffer is wasted, and surfaces in front of the near "
                   "plane may be visible (E16)"
                 : "everything nearer than " + short_number(ours.near) + " is clipped (E16)";
  }
  found.alarm("z-range", kProjection, std::move(cause),
              from_minus_w ? "make it for depth -1 .. 1, or give --dialect d3d or vulkan"
                           : "make it for depth 0 .. 1 (GLM: define GLM_FORCE_DEPTH_ZERO_TO_ONE)");
}

void check_depth(const MatrixSetup& setup, const ProjectionFacts& lens, Findings& found) {
  if (lens.depth_lost) {
    return found.alarm("depth-lost", kProjection,
                       "every distance gets the same depth, " +
                           short_number(lens.alpha + lens.beta) + "; its rank is " +
                           std::to_string(rank_of(setup.projection.m)) +
                           ": it can draw, but a depth buffer cannot hide anything (E15)",
                       "give the z row two numbers made from near and far; near must not be 0");
  }
  if (lens.oblique_depth) {
    return found.note("oblique-depth", kProjection,
                      "depth depends on x and y: the near plane is tilted", "");
  }
  const bool from_minus_w = setup.dialect.z_from_minus_w;
  const DepthReading& ours = from_minus_w ? lens.minus_one_to_one : lens.zero_to_one;
  const DepthReading& other = from_minus_w ? lens.zero_to_one : lens.minus_one_to_one;
  if (!ours.possible && !other.possible) return check_planes(setup, ours, other, found);
  const bool falls = lens.depth_reversed();
  if (falls != (setup.dialect.depth == DepthRange::kReversed)) {
    return check_direction(setup, falls, found);
  }
  if (lens.likely_range() == &other && (!ours.possible || other.digits <= 6)) {
    check_range(setup, ours, other, found);
  }
}

// ---- angle and window ----

void check_angle(const ProjectionFacts& lens, Findings& found) {
  if (lens.degrees_taken_as_radians) {
    const std::string degrees = std::to_string(*lens.degrees_taken_as_radians);
    found.alarm(
        "degrees-as-radians", kProjection,
        "[1][1] = " + short_number(lens.scale.y) + " is the cotangent of half of " + degrees +
            " radians: " + degrees + " degrees were taken for radians" +
            (lens.scale.y > 0 ? ", which makes " + short_number(lens.fovy_degrees, 4) + " degrees"
                              : ", which rotates the picture by 180 degrees"),
        "pass radians(" + degrees + ")");
  } else if (lens.radians_taken_as_degrees) {
    const std::string degrees = std::to_string(*lens.radians_taken_as_degrees);
    found.alarm("radians-as-degrees", kProjection,
                "its angle of view is " + short_number(lens.fovy_degrees, 4) +
                    " degrees, which is " + degrees +
                    " degrees in radians: radians were taken for degrees",
                "pass " + degrees);
  } else if (lens.degrees_of_half_window) {
    const std::string degrees = std::to_string(*lens.degrees_of_half_window);
    found.hint("half-window", kProjection,
               "its angle of view is not a round number, but for half of its window it would be " +
                   degrees +
                   " degrees: the window's full size may have been taken for half of it, "
                   "so that everything is drawn half as large (E13)",
               "the tangent of half the angle is half the window over the distance");
  }
}

void check_flips(const MatrixSetup& setup, const ProjectionFacts& lens, Findings& found) {
  if (lens.degrees_taken_as_radians) return;  // reported already
  const bool x_flipped = lens.scale.x < 0;
  const bool y_flipped = (lens.scale.y < 0) != setup.dialect.ndc_y_down;
  if (x_flipped && y_flipped) {
    found.alarm("turned-round", kProjection, "[0][0] and [1][1] turn the picture by 180 degrees",
                "look for a negative near plane or an angle of view beyond 180 degrees");
  } else if (x_flipped) {
    found.alarm("mirrored", kProjection,
                "[0][0] is negative: the picture is mirrored left to right",
                "look for left and right exchanged");
  } else if (y_flipped && setup.dialect.ndc_y_down) {
    found.hint("upside-down", kProjection,
               "[1][1] is positive, and " + std::string(setup.dialect.title) +
                   " has y pointing down: the picture is upside down",
               "negate [1][1], or use a viewport of negative height");
  } else if (y_flipped) {
    found.alarm("upside-down", kProjection, "[1][1] is negative: the picture is upside down",
                "this is right for Vulkan only; otherwise look for top and bottom exchanged");
  }
}

void check_aspect(const MatrixSetup& setup, const ProjectionFacts& lens, Findings& found) {
  if (!setup.picture) return;
  const int width = setup.picture->x, height = setup.picture->y;
  const double wanted = double(width) / height;
  const auto is = [&](double aspect) { return std::abs(lens.aspect / aspect - 1) <= 0.01; };
  if (is(wanted)) return;
  std::string why =
      ", but the picture's is " + short_number(wanted, 4) + ": circles become ellipses";
  std::string remedy = "pass width/height as the aspect ratio";
  if (is(height / double(width))) {
    why += "; it is height/width";
  } else if (const int truncated = width / height; truncated >= 1 && is(truncated)) {
    why += "; " + std::to_string(width) + "/" + std::to_string(height) + " in integers is " +
           std::to_string(truncated);
    remedy = "divide width by height as floats";
  }
  found.hint("aspect", kProjection, "its aspect ratio is " + short_number(lens.aspect, 4) + why,
             remedy);
}

// Whether this is a perspective projection whose last row was never filled in. Reports it.
bool check_last_row(const MatrixSetup& setup, const ProjectionFacts& lens, Findings& found) {
  if (lens.kind != ProjectionKind::kParallel) return false;
  for (const double sign : {-1, 1}) {
    GivenMatrix filled = setup.projection;
    filled.m[2][3] = sign;
    filled.m[3][3] = 0;
    const ProjectionFacts mended = projection_facts(filled);
    const DepthReading* planes = mended.round_planes(setup.dialect.depth);
    if (planes == nullptr || planes->digits + 3 > lens.fewest_digits()) continue;
    found.alarm("last-row", kProjection,
                "its last row is 0 0 0 1, so that nothing gets smaller with distance; with 0 0 " +
                    short_number(sign) + " 0 it is a perspective projection with " +
                    planes_text(*planes),
                "w has to be the distance along the gaze: set [3][2] to " + short_number(sign) +
                    " and [3][3] to 0");
    return true;
  }
  return false;
}

}  // namespace

void check_projection(const MatrixSetup& setup, Findings& found) {
  const GivenMatrix& given = setup.projection;
  if (has_last_row_of_zeros(given.m)) {
    return alarm_last_row(kProjection, given.m,
                          "0 0 -1 0 or 0 0 1 0 for a perspective, 0 0 0 1 for a parallel one",
                          found);
  }
  if (is_projection_twice(given)) {
    return found.alarm("projection-twice", kProjection,
                       "it is a projection multiplied with itself: its last row is (0, 0, a, b), "
                       "and the row above it (0, 0, a a + b, a b), with a = " +
                           short_number(entry_at(given.m, 3, 2)) +
                           " and b = " + short_number(entry_at(given.m, 3, 3)),
                       "multiply the projection in once: projection * view * model");
  }
  const ProjectionFacts whole = projection_facts(given, setup.dialect.depth);
  const bool alone = whole.kind != ProjectionKind::kNone && !whole.looks_transposed;
  if (!alone && is_something_else(given, found)) return;
  const ProjectionFacts lens = projection_facts(projection_part(given), setup.dialect.depth);
  if (lens.kind == ProjectionKind::kNone) return alarm_unknown(given, found);
  if (alone) {
    if (check_last_row(setup, whole, found)) return;
    check_offsets(setup, whole, found);
    check_flips(setup, whole, found);
  } else {
    note_view_inside(setup, found);
  }
  check_depth(setup, lens, found);
  if (lens.kind == ProjectionKind::kPerspective) check_angle(lens, found);
  check_aspect(setup, lens, found);
}

}  // namespace glassbox
