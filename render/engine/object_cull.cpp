#include <glassbox/render/engine/object_cull.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

namespace {

constexpr int kX = 0, kY = 1, kW = 3;  // the rows that the screen depends on

// ---- whether there is a test at all ----

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

// The point that the rows x, y and w carry to 0: the origin, but for an eye of a stereo pair.
Point<Eye, double> viewpoint_of(const Transform<Clip, Eye>& m) {
  return {-(m.at(kX, 3) / m.at(kX, 0)) + 0.0, -(m.at(kY, 3) / m.at(kY, 1)) + 0.0, 0.0};
}

// With the rounding of the viewpoint's two quotients in its error.
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

// ---- what float makes of the map ----

glm::dmat4 sizes_of(const glm::dmat4& m) {
  glm::dmat4 sizes;
  for (int column = 0; column < 4; ++column) sizes[column] = glm::abs(m[column]);
  return sizes;
}

double determinant_3(const glm::dmat4& m) {
  return glm::determinant(
      glm::dmat3(m[0].x, m[0].y, m[0].w, m[1].x, m[1].y, m[1].w, m[2].x, m[2].y, m[2].w));
}

// The same sum with all its terms positive.
double permanent_3(const glm::dmat4& sizes) {
  const auto term = [&](int i, int j, int k) { return sizes[i].x * sizes[j].y * sizes[k].w; };
  return term(0, 1, 2) + term(0, 2, 1) + term(1, 0, 2) + term(1, 2, 0) + term(2, 0, 1) +
         term(2, 1, 0);
}

// The exact determinant of the rows x, y, w is then right to 2^-29.
bool is_far_from_singular(const Draw& draw, const View& view) {
  const glm::dmat4& p = view.clip_from_eye.columns;
  const glm::dmat4& e = draw.eye_from_object.columns;
  return std::abs(determinant_3(p * e)) > 0x1p-20 * permanent_3(sizes_of(p) * sizes_of(e));
}

// The three rows. Errors: what the run's one float matrix differs by from the exact product of the two in double, and the four
// roundings of applying it.
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

// The largest |p - anchor| of the corners, axis by axis.
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

// The corners along one axis of the screen.
struct Extent {
  double length_px = 0;  // from the first corner to the last
  // What a corner may be away from where the exact map has it, once snapped.
  double displacement_px = 0;
};

Extent extent_of(const std::array<double, 3>& over_w, double error, double error_w, double nearest,
                 double half_side_px) {
  const auto [low, high] = std::minmax({over_w[0], over_w[1], over_w[2]});
  const double reach = std::max(std::abs(low), std::abs(high)) + error / nearest;
  // The snap; three roundings of divide and viewport; the float transform.
  const double displacement = 0.5 / kSubpixels + gamma<float>(3) * half_side_px * (reach + 2) +
                              half_side_px * (error + reach * error_w) / nearest;
  return {half_side_px * (high - low) + 2 * displacement, displacement};
}

}  // namespace

ObjectCull::Judgement ObjectCull::judge(const std::array<Point<Object>, 3>& triangle) const {
  Judgement judged{test_back_face(triangle, viewer), std::numeric_limits<double>::infinity()};
  BackFaceTest test = judged.test;
  if (removes_fronts) test.value = -test.value;
  // No margin makes up for a value of the other sign.
  if (!certainly_back(test, 0)) return judged;

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
  if (!(nearest > 0)) return judged;
  const Extent across = extent_of(xs, error_of(x, farthest), error_w, nearest, half_width_px);
  const Extent down = extent_of(ys, error_of(y, farthest), error_w, nearest, half_height_px);
  const double s = std::max(across.displacement_px, down.displacement_px);
  const double edge_px = std::max(across.length_px, down.length_px);
  judged.margin = value_per_px2 * (8 * s * edge_px + 8 * s * s) *
                  (largest_w * largest_w * largest_w) * (1 + 0x1p-20);
  judged.removed = certainly_back(test, judged.margin);
  return judged;
}

ObjectCulling object_culling(const Draw& draw, const View& view, const RenderSettings& settings) {
  if (settings.cull_stage == CullStage::kScreen) return {{}, "nobody asked for it"};
  const bool fronts = is_culled(draw, settings.cull, true);
  if (!fronts && !is_culled(draw, settings.cull, false))
    return {{}, "both sides of its faces are drawn"};
  if (!draw.prepared->all_finite || draw.prepared->bounds.empty()) {
    return {{}, "a position is not finite, or there is none"};
  }
  if (is_oblique(view)) return {{}, "the lines of sight of an oblique parallel view have no eye"};
  const bool usual = rows_are(view.clip_from_eye, view.perspective) && view.viewport.width() > 0 &&
                     view.viewport.height() > 0;
  const std::optional<ObjectViewer> viewer = usual ? viewer_of(draw, view) : std::nullopt;
  if (!viewer || !is_far_from_singular(draw, view)) {
    return {{}, "its matrix is singular, or so nearly that it does not say where the viewer is"};
  }
  ObjectCull cull;
  cull.viewer = *viewer;
  cull.removes_fronts = fronts;
  fill_rows(draw, view, cull);
  cull.anchor = draw.anchor;
  cull.half_width_px = double(view.viewport.width()) / 2;
  cull.half_height_px = double(view.viewport.height()) / 2;
  // 8 px^2 by snapping_margin's formula: corners moved by 1 px, edges of no length, w = 1.
  cull.value_per_px2 =
      snapping_margin(view.clip_from_eye * draw.eye_from_object, *viewer, view.viewport, 1, 0, 1) /
      8;
  return {cull,
          "faces that are turned away by more than snapping and float can turn back go before "
          "clipping; what is in doubt, or cut by a plane, is left to the snapped area"};
}

}  // namespace glassbox
