#include <glassbox/render/engine/object_cull.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <glassbox/base/elementary.h>
#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

namespace {

constexpr int kX = 0, kY = 1, kW = 3;  // the rows that the position on the screen depends on

// ---- the views for which there is a test ----

bool rows_are(const Transform<Clip, Eye>& m, bool perspective) {
  const bool no_shear = m.at(kX, 1) == 0 && m.at(kY, 0) == 0;
  const bool w = m.at(kW, 0) == 0 && m.at(kW, 1) == 0 && m.at(kW, 2) == (perspective ? -1 : 0) &&
                 m.at(kW, 3) == (perspective ? 0 : 1);
  return no_shear && w && m.at(kX, 0) != 0 && m.at(kY, 1) != 0;
}

bool is_oblique(const View& view) {
  return !view.perspective &&
         (view.clip_from_eye.at(kX, 2) != 0 || view.clip_from_eye.at(kY, 2) != 0);
}

// ---- the viewer ----

// Returns the point that the rows x, y and w of the projection `m` map to 0: the eye. It is the
// origin, except for an eye of a stereo pair.
Point<Eye, double> viewpoint_of(const Transform<Clip, Eye>& m) {
  return {-(m.at(kX, 3) / m.at(kX, 0)) + 0.0, -(m.at(kY, 3) / m.at(kY, 1)) + 0.0, 0.0};
}

// Returns the viewer (the eye, or the gaze of a parallel view) in object space. The bound of its
// error includes the rounding of the two divisions in viewpoint_of().
std::optional<ObjectViewer> viewer_of(const Draw& draw, const View& view) {
  const Point<Eye, double> viewpoint =
      view.perspective ? viewpoint_of(view.clip_from_eye) : Point<Eye, double>{};
  const auto viewer = viewer_in_object_space(draw.eye_from_object, view.perspective, viewpoint);
  if (!viewer || viewpoint == Point<Eye, double>{}) return viewer;
  const auto origin = viewer_in_object_space(draw.eye_from_object, view.perspective);
  if (!origin) return std::nullopt;
  ObjectViewer wider = *viewer;
  const double share = 2 * unit_roundoff<double>;
  const Vector<Object, double>&a = viewer->eye_or_gaze, &b = origin->eye_or_gaze;
  wider.error.x += share * (std::abs(a.x - b.x) + origin->error.x + viewer->error.x);
  wider.error.y += share * (std::abs(a.y - b.y) + origin->error.y + viewer->error.y);
  wider.error.z += share * (std::abs(a.z - b.z) + origin->error.z + viewer->error.z);
  return wider;
}

// ---- the rounding errors of the transform to clip space ----

glm::dmat4 sizes_of(const glm::dmat4& m) {
  glm::dmat4 sizes;
  for (int column = 0; column < 4; ++column) sizes[column] = glm::abs(m[column]);
  return sizes;
}

double determinant_3(const glm::dmat4& m) {
  return glm::determinant(
      glm::dmat3(m[0].x, m[0].y, m[0].w, m[1].x, m[1].y, m[1].w, m[2].x, m[2].y, m[2].w));
}

// Returns the permanent: the sum of the determinant's terms, all with a positive sign.
double permanent_3(const glm::dmat4& sizes) {
  const auto term = [&](int i, int j, int k) { return sizes[i].x * sizes[j].y * sizes[k].w; };
  return term(0, 1, 2) + term(0, 2, 1) + term(1, 0, 2) + term(1, 2, 0) + term(2, 0, 1) +
         term(2, 1, 0);
}

Vector<Object, double> row_of(const glm::dmat4& m, int row) {
  return {m[0][row], m[1][row], m[2][row]};
}

// Whether the transform to clip space is so far from singular that areas on the screen have a
// relative error below 2^-29 when they are computed with it in double. This depends on the
// determinant of its rows x, y, w; in a parallel view on the cross product of its rows x and y.
bool is_far_from_singular(const Draw& draw, const View& view) {
  const glm::dmat4& p = view.clip_from_eye.columns;
  const glm::dmat4& e = draw.eye_from_object.columns;
  const glm::dmat4 product = p * e, sizes = sizes_of(p) * sizes_of(e);
  constexpr double kShare = 0x1p-20;
  if (view.perspective) return std::abs(determinant_3(product)) > kShare * permanent_3(sizes);
  const Vector<Object, double> area = cross(row_of(product, kX), row_of(product, kY));
  const Vector<Object, double> x = row_of(sizes, kX), y = row_of(sizes, kY);
  const Vector<Object, double> size{x.y * y.z + x.z * y.y, x.z * y.x + x.x * y.z,
                                    x.x * y.y + x.y * y.x};
  return dot(area, area) > kShare * kShare * dot(size, size);
}

// Fills in the rows x, y and w and the error of each entry. The error is a sum: the difference
// between the float matrix that the run uses and the product of the matrices in double, the
// rounding errors of that product, and the four rounding errors of a transform in float.
void fill_rows(const Draw& draw, const View& view, ObjectCull& cull) {
  const Vector<Object>& a = draw.anchor;
  const glm::dmat4 anchored =
      translate<Object, Object>({double(a.x), double(a.y), double(a.z)}).columns;
  const glm::dmat4 exact = view.clip_from_eye.columns * draw.eye_from_object.columns;
  const glm::dmat4 exact_anchored = exact * anchored;
  const glm::dmat4 size = sizes_of(view.clip_from_eye.columns) *
                          sizes_of(draw.eye_from_object.columns) * sizes_of(anchored);
  const glm::dmat4 run(draw.clip_from_anchored.columns);
  const auto fill = [&](int row, ObjectCull::Row& filled) {
    for (int column = 0; column < 4; ++column) {
      const auto i = std::size_t(column);
      filled.exact[i] = exact[column][row];
      filled.error[i] = std::abs(run[column][row] - exact_anchored[column][row]) +
                        gamma<double>(16) * size[column][row] +
                        gamma<float>(4) * std::abs(run[column][row]);
    }
  };
  fill(kX, cull.x);
  fill(kY, cull.y);
  fill(kW, cull.w);
}

// ---- one triangle ----

double at(const ObjectCull::Row& row, const Point<Object>& p) {
  return row.exact[0] * double(p.x) + row.exact[1] * double(p.y) + row.exact[2] * double(p.z) +
         row.exact[3];
}

double error_of(const ObjectCull::Row& row, const std::array<double, 3>& farthest) {
  return row.error[0] * farthest[0] + row.error[1] * farthest[1] + row.error[2] * farthest[2] +
         row.error[3];
}

// Returns for each axis the largest |p - anchor| of the corners p.
std::array<double, 3> farthest_from_anchor(const std::array<Point<Object>, 3>& triangle,
                                           const Vector<Object>& anchor) {
  std::array<double, 3> farthest{};
  for (const Point<Object>& p : triangle) {
    farthest[0] = std::max(farthest[0], std::abs(double(p.x) - double(anchor.x)));
    farthest[1] = std::max(farthest[1], std::abs(double(p.y) - double(anchor.y)));
    farthest[2] = std::max(farthest[2], std::abs(double(p.z) - double(anchor.z)));
  }
  return farthest;
}

// The extent of a triangle's corners along one axis of the screen.
struct Extent {
  double length_px = 0;  // upper bound of the distance between the first and the last corner
  // Upper bound of how far a snapped corner may be from its exact position.
  double displacement_px = 0;
};

// Returns how far snapping and rounding may move a corner on the screen, in pixels. The corner is
// within `reach` half screens of the screen's centre, and its w is at least `nearest`. The terms
// are the snap, three roundings in divide and viewport, and the error of the transform in float.
double displacement_px(double reach, double error, double error_w, double nearest,
                       double half_side_px) {
  return 0.5 / kSubpixels + gamma<float>(3) * half_side_px * (reach + 2) +
         half_side_px * (error + reach * error_w) / nearest;
}

Extent extent_of(const std::array<double, 3>& over_w, double error, double error_w, double nearest,
                 double half_side_px) {
  const auto [low, high] = std::minmax({over_w[0], over_w[1], over_w[2]});
  const double reach = std::max(std::abs(low), std::abs(high)) + error / nearest;
  const double displacement = displacement_px(reach, error, error_w, nearest, half_side_px);
  return {half_side_px * (high - low) + 2 * displacement, displacement};
}

// Returns the margin (snapping_margin) that the value of the back-face test must exceed.
double margin_of(const ObjectCull& cull, const Extent& across, const Extent& down,
                 double largest_w) {
  const double s = std::max(across.displacement_px, down.displacement_px);
  const double edge_px = std::max(across.length_px, down.length_px);
  return cull.value_per_px2 * (8 * s * edge_px + 8 * s * s) * (largest_w * largest_w * largest_w) *
         (1 + 0x1p-20);
}

// ---- a cluster ----

double sum_of_sizes(const Vector<Object, double>& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

// Returns a lower bound of the viewer's distance behind the planes of the cluster's triangles (with
// `fronts`: in front of them); in a parallel view, of the cosine between the gaze and the normals u
// (with `fronts`: their opposites). The vector g goes from the viewer to a point of the cone's axis
// that is behind all planes or on them, so each distance is at least g . u. This is smallest for a
// u on the surface of the cone, on the side that is turned away from g. (With `fronts`, the point
// is in front of all planes, and g has the opposite sign.) Rounding the axis to float changes the
// result by less than 2^-20 |g|.
double least_behind(const Cluster& cluster, const ObjectViewer& viewer, bool fronts) {
  const Vector<Object, double> axis = axis_of(cluster);
  Vector<Object, double> g = viewer.eye_or_gaze;
  if (viewer.perspective) {
    const double along = fronts ? cluster.along_fronts : cluster.along_backs;
    const Point<Object, double> centre = centre_of(cluster);
    g = Vector<Object, double>{centre.x, centre.y, centre.z} + axis * along - g;
  }
  if (fronts) g = -g;
  const double ahead = dot(g, axis);
  if (!(ahead > 0)) return 0;
  const Vector<Object, double> aside = g - axis * ahead;
  const double cosine = cluster.cosine, sine = std::sqrt(1 - cosine * cosine);
  return ahead * cosine - std::sqrt(dot(aside, aside)) * sine - 0x1p-20 * sum_of_sizes(g) -
         sum_of_sizes(viewer.error);
}

// The values of a clip coordinate over a box: the value at the box's centre, and how much other
// values may differ from it.
struct Spread {
  double middle = 0, reach = 0;
  double largest() const { return std::abs(middle) + reach; }
};
Spread spread_of(const ObjectCull::Row& row, const Point<Object, double>& centre,
                 const Vector<Object, double>& half) {
  const auto& m = row.exact;
  return {m[0] * centre.x + m[1] * centre.y + m[2] * centre.z + m[3],
          std::abs(m[0]) * half.x + std::abs(m[1]) * half.y + std::abs(m[2]) * half.z};
}

// Returns the length of the gradient: the first three entries of the row. (Called four times for
// each cluster, so the slower hypotenuse() is used only if the squares underflow. If they overflow,
// the result is infinite and nothing is removed.)
double slope_of(const ObjectCull::Row& row) {
  const auto& m = row.exact;
  const double squares = m[0] * m[0] + m[1] * m[1] + m[2] * m[2];
  return squares > 0x1p-900 ? std::sqrt(squares) : hypotenuse(m[0], m[1], m[2]);
}

}  // namespace

ObjectCull::Evaluation ObjectCull::evaluate(const std::array<Point<Object>, 3>& triangle) const {
  Evaluation evaluation{test_back_face(triangle, viewer), std::numeric_limits<double>::infinity()};
  BackFaceTest test = evaluation.test;
  if (removes_fronts) test.value = -test.value;
  // If the value has the wrong sign, the triangle cannot be removed, whatever the margin.
  if (!certainly_back(test, 0)) return evaluation;

  const std::array<double, 3> farthest = farthest_from_anchor(triangle, anchor);
  const double error_w = error_of(w, farthest);
  std::array<double, 3> ws, xs, ys;
  for (std::size_t k = 0; k < 3; ++k) {
    ws[k] = at(w, triangle[k]);
    xs[k] = at(x, triangle[k]) / ws[k];
    ys[k] = at(y, triangle[k]) / ws[k];
  }
  const auto [low, high] = std::minmax({ws[0], ws[1], ws[2]});
  const double nearest = low - 2 * error_w, largest_w = high + error_w;
  if (!(nearest > 0)) return evaluation;
  const Extent across = extent_of(xs, error_of(x, farthest), error_w, nearest, half_width_px);
  const Extent down = extent_of(ys, error_of(y, farthest), error_w, nearest, half_height_px);
  evaluation.margin = margin_of(*this, across, down, largest_w);
  evaluation.removed = certainly_back(test, evaluation.margin);
  return evaluation;
}

bool ObjectCull::removes_all(const Cluster& cluster) const {
  if (cluster.cosine == 0) return false;
  const double behind = least_behind(cluster, viewer, removes_fronts);
  if (!(behind > 0)) return false;

  const Point<Object, double> centre = centre_of(cluster);
  const Vector<Object, double> half = half_size_of(cluster);
  const std::array<double, 3> farthest{std::abs(centre.x - double(anchor.x)) + half.x,
                                       std::abs(centre.y - double(anchor.y)) + half.y,
                                       std::abs(centre.z - double(anchor.z)) + half.z};
  const Spread ws = spread_of(w, centre, half);
  const double error_w = error_of(w, farthest);
  const double nearest = ws.middle - ws.reach - 2 * error_w;
  if (!(nearest > 0)) return false;
  // From the beginning to the end of an edge d, x / w changes by (row_x . d - (x / w) row_w . d) /
  // w, with x / w at the beginning and the divisor w at the end. So the edge's length is at most
  // |d| (|row_x| + reach |row_w|) / nearest, in half screens.
  const auto extent = [&](const Row& row, double half_side_px) {
    const double error = error_of(row, farthest);
    const double reach = (spread_of(row, centre, half).largest() + error) / nearest;
    const double displaced = displacement_px(reach, error, error_w, nearest, half_side_px);
    const double slope = slope_of(row) + reach * slope_of(w);
    return Extent{half_side_px * cluster.longest_edge * slope / nearest + 2 * displaced, displaced};
  };
  const double margin = margin_of(*this, extent(x, half_width_px), extent(y, half_height_px),
                                  ws.middle + ws.reach + error_w);
  return behind * cluster.least_newell > margin * (1 + 0x1p-20);
}

ObjectCulling object_culling(const Draw& draw, const View& view, const RenderSettings& settings) {
  if (settings.cull_stage == CullStage::kScreen) return {{}, "not requested"};
  return certain_culling(draw, view, settings.cull);
}

ObjectCulling certain_culling(const Draw& draw, const View& view, Cull cull_mode) {
  const bool fronts = is_culled(draw, cull_mode, true);
  if (!fronts && !is_culled(draw, cull_mode, false))
    return {{}, "both sides of its faces are drawn"};
  if (!draw.prepared->all_finite || draw.prepared->bounds.empty()) {
    return {{}, "a position is not finite, or there is none"};
  }
  if (view.front_clockwise) {
    return {{}, "the view takes faces that run clockwise on the screen for front faces"};
  }
  if (is_oblique(view))
    return {{}, "an oblique parallel view has no eye that its lines of sight start from"};
  const bool usual = rows_are(view.clip_from_eye, view.perspective) && view.viewport.width() > 0 &&
                     view.viewport.height() > 0;
  const std::optional<ObjectViewer> viewer = usual ? viewer_of(draw, view) : std::nullopt;
  if (!viewer || !is_far_from_singular(draw, view)) {
    return {{},
            "its matrix is singular, or so close to it that the eye's position in object space is "
            "unknown"};
  }
  ObjectCull cull;
  cull.viewer = *viewer;
  cull.removes_fronts = fronts;
  fill_rows(draw, view, cull);
  cull.anchor = draw.anchor;
  cull.half_width_px = double(view.viewport.width()) / 2;
  cull.half_height_px = double(view.viewport.height()) / 2;
  // The margin is value_per_px2 * (8 s L + 8 s^2) w^3 for corners moved by s px and edges of length
  // L px (margin_of). With s = 1, L = 0 and w = 1 it is 8 value_per_px2.
  cull.value_per_px2 =
      snapping_margin(view.clip_from_eye * draw.eye_from_object, *viewer, view.viewport, 1, 0, 1) /
      8;
  return {
      cull,
      "faces turned away by more than snapping and float can change are removed before clipping; "
      "uncertain faces, and those that a plane cuts, are decided by the snapped area"};
}

}  // namespace glassbox
