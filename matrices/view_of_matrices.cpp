#include <glassbox/matrices/view_of_matrices.h>

#include <cmath>
#include <limits>

#include <glm/matrix.hpp>

#include <glassbox/matrices/projection_factors.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/dialects.h>

namespace glassbox {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFloatMax = std::numeric_limits<float>::max();
constexpr double kFloatMin = std::numeric_limits<float>::min();

using Projection = Transform<Clip, Eye>;

Result<void> check_entries(const GivenMatrix& matrix, const char* option) {
  const std::optional<Entry> entry = first_not_finite(matrix.m);
  if (!entry) return {};
  return fail(option,
              "the entry in row " + std::to_string(entry->row) + ", column " +
                  std::to_string(entry->column) + " is not a finite number",
              "find out which division or angle of your program gives it");
}

// ---- clip spaces ----

// Converts the rows of a matrix to the dialect's clip space into rows to ours.
glm::dmat4 to_our_clip_space(const glm::dmat4& given, const ApiDialect& dialect, DepthRange range) {
  glm::dmat4 ours = given;
  for (int column = 0; column < 4; ++column) {
    glm::dvec4& c = ours[column];
    if (dialect.z_from_minus_w) c.z = (c.z + c.w) / 2;
    if (dialect.depth != range) c.z = c.w - c.z;
    if (dialect.ndc_y_down) c.y = -c.y;
  }
  return ours;
}

std::string conversion_text(const ApiDialect& dialect, DepthRange range) {
  std::string text;
  const auto add = [&](const char* step) {
    text += (text.empty() ? "" : ", then ") + std::string(step);
  };
  if (dialect.z_from_minus_w) add("z = (z + w)/2");
  if (dialect.depth != range) add("z = w - z");
  if (dialect.ndc_y_down) add("y = -y");
  return text;
}

// ---- which eye space ----

struct Split {
  glm::dmat4 eye_from_world{1}, clip_from_eye{1};
};

glm::dmat4 mirrored_in_z() {
  return eye_left_from_eye().columns;
}

// Whether w is the distance along -z or +z, or constant, and x, y do not depend on each other.
bool looks_along_an_axis(const glm::dmat4& p) {
  if (!is_small(p, 3, 0) || !is_small(p, 3, 1)) return false;
  const bool perspective = p[2][3] != 0;
  return perspective ? p[3][3] == 0 : p[3][3] != 0;
}

bool is_isometry(const glm::dmat4& view) {
  const MatrixFacts facts = matrix_facts(view);
  return facts.affine && facts.orthogonality <= kRigidTolerance;
}

// Whether the eye looks along +z. A perspective matrix says it by w, a parallel one by the depth,
// which grows along the gaze (`p` is in our clip space).
bool looks_along_plus_z(const glm::dmat4& p, DepthRange range) {
  if (p[2][3] != 0) return p[2][3] > 0;
  return range == DepthRange::kStandard ? p[2][2] > 0 : p[2][2] < 0;
}

glm::dvec3 slope(const glm::dmat4& m, int row) {
  return {m[0][row], m[1][row], m[2][row]};
}

// Solves three linear equations: rows * point = -offsets. Nothing if they have no single solution.
std::optional<glm::dvec3> meeting_point(const std::array<glm::dvec3, 3>& rows,
                                        const glm::dvec3& offsets) {
  const glm::dmat3 m = glm::transpose(glm::dmat3(rows[0], rows[1], rows[2]));
  const double determinant = glm::determinant(m);
  const double size = glm::length(rows[0]) * glm::length(rows[1]) * glm::length(rows[2]);
  // Products of three entries known to float's precision: a smaller share is rounding error.
  if (!(std::abs(determinant) > 0x1p-40 * size)) return std::nullopt;
  return glm::inverse(m) * -offsets;
}

// Finds the eye in the product g = C P V: where it stands, and its axes in the world.
std::optional<Split> find_eye(const glm::dmat4& g, DepthRange range) {
  const glm::dvec3 x = slope(g, 0), y = slope(g, 1), w = slope(g, 3);
  const double grows = glm::length(w);
  const bool perspective = grows > 0;
  glm::dvec3 gaze = perspective ? w / grows : glm::normalize(glm::cross(x, y));
  if (!perspective) {
    const double deeper = glm::dot(slope(g, 2), gaze);
    if ((range == DepthRange::kStandard) == (deeper < 0)) gaze = -gaze;
  }
  const glm::dvec3 offsets(g[3][0], g[3][1], perspective ? g[3][3] : 0.0);
  const auto eye = meeting_point({x, y, perspective ? w : gaze}, offsets);
  if (!eye || !(glm::length(y - glm::dot(y, gaze) * gaze) > 0)) return std::nullopt;
  const glm::dvec3 up = glm::normalize(y - glm::dot(y, gaze) * gaze);
  const glm::dvec3 right = glm::cross(gaze, up);

  Split split;
  for (int k = 0; k < 3; ++k) {
    split.eye_from_world[k] = glm::dvec4(right[k], up[k], -gaze[k], 0);
  }
  split.eye_from_world[3] =
      glm::dvec4(-glm::dot(right, *eye), -glm::dot(up, *eye), glm::dot(gaze, *eye), 1);
  for (int row = 0; row < 4; ++row) {
    const glm::dvec3 s = slope(g, row);
    split.clip_from_eye[0][row] = glm::dot(s, right);
    split.clip_from_eye[1][row] = glm::dot(s, up);
    split.clip_from_eye[2][row] = -glm::dot(s, gaze);
    split.clip_from_eye[3][row] = glm::dot(s, *eye) + g[3][row];
  }
  // What is 0 by construction is 0 exactly.
  split.clip_from_eye[3][0] = split.clip_from_eye[3][1] = 0;
  split.clip_from_eye[0][3] = split.clip_from_eye[1][3] = 0;
  if (perspective) split.clip_from_eye[3][3] = 0;
  return split;
}

// Divides by the factor of w, so that w is the distance along the gaze, or 1. A negative constant w
// stays negative: no API draws it.
void make_w_the_distance(glm::dmat4& p) {
  const double factor = std::abs(p[2][3] != 0 ? p[2][3] : p[3][3]);
  if (factor != 1 && factor > 0) p = p / factor;
}

// ---- near and far ----

// The distances where depth is 0 and where it is 1, along the gaze.
struct Planes {
  double near = 0, far = kInfinity;
};

Planes planes_of(const glm::dmat4& p, bool perspective, DepthRange range) {
  const bool standard = range == DepthRange::kStandard;
  // At the distance d: z = p[3][2] - d p[2][2], and w - z likewise.
  const double z_slope = -p[2][2], z_start = p[3][2];
  const double rest_slope = -p[2][3] - z_slope, rest_start = p[3][3] - z_start;
  const auto zero_of = [](double per_distance, double start) {
    return per_distance == 0 ? kInfinity : -start / per_distance + 0.0;
  };
  Planes planes;
  const double near_slope = standard ? z_slope : rest_slope;
  const double near_start = standard ? z_start : rest_start;
  const double far_slope = standard ? rest_slope : z_slope;
  const double far_start = standard ? rest_start : z_start;
  planes.near = zero_of(near_slope, near_start);
  planes.far = zero_of(far_slope, far_start);
  if (!perspective) return planes;
  // The distance in front of the eye is positive. Without a near plane there, only the eye plane
  // cuts, at the smallest distance that a float holds.
  if (!(planes.near > kFloatMin) || !std::isfinite(planes.near)) planes.near = 2 * kFloatMin;
  const bool never_far = far_slope >= 0 && far_start >= 0;
  if (!(planes.far > 0) || !std::isfinite(planes.far))
    planes.far = never_far ? kInfinity : planes.near;
  return planes;
}

// Whether the picture is a mirror image of the world. (Both matrices look along -z.)
bool mirrors(const Split& split) {
  const glm::dmat4& p = split.clip_from_eye;
  const double picture = p[0][0] * p[1][1] - p[1][0] * p[0][1];
  return (glm::determinant(glm::dmat3(split.eye_from_world)) < 0) != (picture < 0);
}

// ---- reports ----

Lens lens_of(const View& view) {
  const glm::dmat4& p = view.clip_from_eye.columns;
  const double n = view.near;
  if (!view.perspective) return OrthographicLens{std::abs(1 / p[1][1]), n, view.far};
  FrustumLens lens;
  lens.left = n * (p[2][0] - 1) / p[0][0];
  lens.right = n * (p[2][0] + 1) / p[0][0];
  lens.bottom = n * (p[2][1] - 1) / p[1][1];
  lens.top = n * (p[2][1] + 1) / p[1][1];
  lens.near = n;
  if (!std::isinf(view.far)) lens.far = view.far;
  return lens;
}

}  // namespace

Result<MatrixView> view_of_matrices(const MatrixSetup& setup, int width, int height,
                                    DepthRange range) {
  const auto view_legal = check_entries(setup.view, "--view");
  if (!view_legal) return tl::unexpected(view_legal.error());
  const auto projection_legal = check_entries(setup.projection, "--proj");
  if (!projection_legal) return tl::unexpected(projection_legal.error());
  if (const auto legal = check_picture_size(width, height); !legal) {
    return tl::unexpected(legal.error());
  }

  MatrixView made;
  made.setup = setup;
  made.conversion = conversion_text(setup.dialect, range);
  const glm::dmat4 p = to_our_clip_space(setup.projection.m, setup.dialect, range);
  const std::optional<Split> found = find_eye(p * setup.view.m, range);
  if (!found) {
    return fail("--proj times --view",
                "the product has no eye: it flattens the world onto a plane, a line or a point "
                "before the picture",
                "glassbox step --point X,Y,Z with the same matrices says what each of them does");
  }
  Split split = *found;
  made.eye_space_is_given = is_isometry(setup.view.m) && looks_along_an_axis(p);
  if (made.eye_space_is_given) {
    made.looks_along_plus_z = looks_along_plus_z(p, range);
    split = made.looks_along_plus_z ? Split{mirrored_in_z() * setup.view.m, p * mirrored_in_z()}
                                    : Split{setup.view.m, p};
  }
  make_w_the_distance(split.clip_from_eye);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (std::abs(split.clip_from_eye[column][row]) <= kFloatMax &&
          std::abs(split.eye_from_world[column][row]) <= kFloatMax) {
        continue;
      }
      return fail("--proj, --view", "an entry of their matrices is too large for a float",
                  "scale the world, so that coordinates stay below 3.4e38");
    }
  }

  View& view = made.view;
  view.eye_from_world = Transform<Eye, World>(split.eye_from_world);
  view.clip_from_eye = Projection(split.clip_from_eye);
  view.viewport = {0, 0, float(width), float(height)};
  view.depth_range = range;
  view.perspective = split.clip_from_eye[2][3] != 0;
  const Planes planes = planes_of(split.clip_from_eye, view.perspective, range);
  view.near = planes.near;
  view.far = planes.far;
  made.mirrors = mirrors(split);
  view.front_clockwise = made.mirrors;
  if (setup.front) {
    // The stages flip the front of a mirrored model; an API does not look at the model matrix.
    const bool model_mirrors = glm::determinant(glm::dmat3(setup.model.m)) < 0;
    view.front_clockwise = (*setup.front == FrontFaces::kClockwise) != model_mirrors;
  }

  made.camera.name = "your matrices";
  made.camera.world_from_eye = Transform<World, Eye>(glm::inverse(split.eye_from_world));
  made.camera.lens = lens_of(view);
  return made;
}

std::optional<double> aspect_of_projection(const GivenMatrix& projection) {
  const GivenMatrix part = projection_part(projection);
  const ProjectionFacts facts = projection_facts(part);
  if (facts.kind == ProjectionKind::kNone || facts.looks_transposed) return std::nullopt;
  const double aspect = std::abs(facts.scale.y / facts.scale.x);
  if (!(aspect > 0) || !std::isfinite(aspect)) return std::nullopt;
  return aspect;
}

}  // namespace glassbox
