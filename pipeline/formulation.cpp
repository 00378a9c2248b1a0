#include <glassbox/pipeline/formulation.h>

#include <cmath>
#include <limits>

#include <glassbox/base/trig.h>
#include <glassbox/pipeline/number_text.h>
#include <glassbox/pipeline/unit_vector.h>

namespace glassbox {
namespace {

// The values that the forms of a projection matrix are computed from: the near and far plane, and
// the window on the near plane.
struct Pyramid {
  double near = 0, far = 0;
  double tan_half_height = 0;  // of the vertical angle
  double aspect = 1;           // the window's width over its height
  Window window;
  bool is_centred = true;
};

double far_of(const std::optional<double>& far) {
  return far.value_or(std::numeric_limits<double>::infinity());
}

Pyramid pyramid_of(const PerspectiveLens& lens, double aspect) {
  const double t = tan_half(lens.fovy_radians);
  const double top = lens.near * t, right = top * aspect;
  return {lens.near, far_of(lens.far), t, aspect, {-right, right, -top, top}, true};
}

Pyramid pyramid_of(const FrustumLens& lens) {
  const double height = lens.top - lens.bottom;
  return {lens.near,
          far_of(lens.far),
          height / (2 * lens.near),
          (lens.right - lens.left) / height,
          {lens.left, lens.right, lens.bottom, lens.top},
          lens.left == -lens.right && lens.bottom == -lens.top};
}

// The slide's window is a square. For a wider one x is divided by the aspect ratio.
Result<Transform<Clip, Eye>> from_t_pers(const Pyramid& p) {
  return t_pers(p.near * p.tan_half_height, p.near, p.far)
      .map([&](const Transform<Clip, EyeLeft>& square) {
        Transform<Clip, EyeLeft> m = square;
        m.at(0, 0) /= p.aspect;
        return m * eye_left_from_eye();
      });
}

Result<Transform<Clip, Eye>> from_alpha_beta(const Pyramid& p) {
  const double half_angle = arctan(p.tan_half_height * p.aspect);
  return alpha_beta(degrees_from_radians(half_angle), p.aspect, p.near, p.far)
      .map([](const Transform<Clip, EyeLeft>& m) { return m * eye_left_from_eye(); });
}

// Replaces -0 by 0: the product with diag(1, 1, -1, 1) turns some zeros into -0.
Transform<Clip, Eye> without_negative_zeros(Transform<Clip, Eye> m) {
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) m.at(row, column) += 0.0;
  }
  return m;
}

Result<Transform<Clip, Eye>> project(const Pyramid& p, DepthRange range, ProjectionForm form) {
  if (form == ProjectionForm::kFrustum) return frustum(p.window, {p.near, p.far, range});
  if (range == DepthRange::kReversed) {
    return fail(
        "projection form",
        "the slides' projections have depth 0 at the near plane, but reversed depth is 1 there",
        "leave out one of the two, or use frustum, which has both");
  }
  if (!p.is_centred) {
    return fail(
        "projection form",
        "the window is not centred on the gaze, which the slides' projections do not support",
        "use frustum, or a window with left = -right and bottom = -top");
  }
  const auto made = form == ProjectionForm::kTPers ? from_t_pers(p) : from_alpha_beta(p);
  return made.map(without_negative_zeros);
}

Result<Transform<Clip, Eye>> project(const Camera& camera, double aspect, DepthRange range,
                                     ProjectionForm form) {
  if (const auto* lens = std::get_if<PerspectiveLens>(&camera.lens)) {
    return project(pyramid_of(*lens, aspect), range, form);
  }
  if (const auto* lens = std::get_if<FrustumLens>(&camera.lens)) {
    return project(pyramid_of(*lens), range, form);
  }
  return fail("projection form", "the lens is a parallel one, which has no viewing pyramid",
              "leave the form out, or give a field of view");
}

}  // namespace

Result<View> make_view(const Camera& camera, int width, int height, DepthRange depth_range,
                       const Formulation& formulation) {
  Result<View> view = make_view(camera, width, height, depth_range);
  if (!view) return view;
  if (formulation.projection != ProjectionForm::kPerspective) {
    const auto made =
        project(camera, double(width) / double(height), depth_range, formulation.projection);
    if (!made) return tl::unexpected(made.error());
    view->clip_from_eye = *made;
  }
  if (formulation.view == ViewForm::kAxisAngle) {
    // The axes are those of make_view, which replaces a pose with few digits by the nearest
    // rotation (kRigidTolerance); the eye's position is the camera's own.
    Transform<World, Eye> pose = camera.world_from_eye;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        pose.at(row, column) = view->eye_from_world.at(column, row);
    }
    view->eye_from_world = product(axis_angle_factors(pose));
  }
  return view;
}

AxisAngleFactors axis_angle_factors(const Transform<World, Eye>& world_from_eye) {
  const auto column = [&](int c) {
    return Vector<World, double>{world_from_eye.at(0, c), world_from_eye.at(1, c),
                                 world_from_eye.at(2, c)};
  };
  const Vector<World, double> eye = column(3), gaze = -column(2), up = column(1);
  return axis_angle_factors(Point<World, double>{eye.x, eye.y, eye.z}, unit(gaze).value_or(gaze),
                            unit(up).value_or(up));
}

std::optional<PerspectiveFactors> perspective_factors(const Transform<Clip, Eye>& m) {
  const bool shears = m.at(0, 1) != 0 || m.at(1, 0) != 0 || m.at(2, 0) != 0 || m.at(2, 1) != 0;
  const bool gives_w = m.at(3, 0) == 0 && m.at(3, 1) == 0 && m.at(3, 2) == -1 && m.at(3, 3) == 0;
  if (shears || !gives_w) return std::nullopt;
  PerspectiveFactors factors;
  for (int axis = 0; axis < 2; ++axis) {
    factors.scale.at(axis, axis) = m.at(axis, axis);
    // The factors are for a left-handed eye, where z is positive along the gaze.
    factors.shear.at(axis, 2) = -m.at(axis, 2) + 0.0;
    factors.shear.at(axis, 3) = m.at(axis, 3);
    factors.has_shear = factors.has_shear || m.at(axis, 2) != 0 || m.at(axis, 3) != 0;
  }
  factors.clip_from_pyramid.at(2, 2) = -m.at(2, 2) + 0.0;
  factors.clip_from_pyramid.at(2, 3) = m.at(2, 3);
  factors.clip_from_pyramid.at(3, 2) = 1;
  factors.clip_from_pyramid.at(3, 3) = 0;
  return factors;
}

}  // namespace glassbox
