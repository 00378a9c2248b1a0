#include <glassbox/pipeline/view.h>

#include <cmath>
#include <limits>
#include <string>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/number_text.h>

namespace glassbox {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFloatMin = std::numeric_limits<float>::min();
constexpr double kFloatMax = std::numeric_limits<float>::max();

Result<void> check_size(int pixels, const char* which) {
  if (pixels >= 1 && pixels <= kMaxImageSide) return {};
  return fail("image size",
              std::string("its ") + which + " is " + std::to_string(pixels) + " pixels",
              "give 1 to " + std::to_string(kMaxImageSide) + " pixels each way");
}

// The camera's pose, with its axes made perpendicular unit vectors.
Result<Transform<World, Eye>> rigid_pose(const Transform<World, Eye>& pose) {
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      if (std::isfinite(pose.at(row, column))) continue;
      return fail("camera pose",
                  "entry (" + std::to_string(row) + ", " + std::to_string(column) + ") is " +
                      number_text(pose.at(row, column)),
                  "give finite numbers");
    }
  }
  if (pose.at(3, 0) != 0 || pose.at(3, 1) != 0 || pose.at(3, 2) != 0 || pose.at(3, 3) != 1) {
    return fail("camera pose", "its last row is not 0, 0, 0, 1", "give a rotation and a position");
  }
  const glm::dmat3 axes(pose.columns);
  const double error = orthogonality_error(axes);
  if (!(error <= kRigidTolerance)) {
    return fail("camera pose",
                "its axes are not perpendicular unit vectors (off by " + number_text(error) + ")",
                "remove scale and shear from the camera and the nodes above it");
  }
  const Result<NearestRotation> nearest = nearest_rotation(axes);
  if (!nearest) {
    return fail("camera pose", "its axes are left-handed, which would mirror the picture",
                "remove the negative scale from the camera and the nodes above it");
  }
  if (error <= 16 * unit_roundoff<double>) return pose;
  Transform<World, Eye> repaired = pose;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) repaired.at(row, column) = nearest->rotation[column][row];
  }
  return repaired;
}

struct Pixels {
  double width = 1, height = 1;
};

struct Projected {
  Transform<Clip, Eye> clip_from_eye;
  double near = 0, far = 0;
  bool perspective = true;
};
Projected projected(const Transform<Clip, Eye>& clip_from_eye, double near, double far,
                    bool perspective) {
  return {clip_from_eye, near, far, perspective};
}

Result<Projected> project(const PerspectiveLens& lens, Pixels size, DepthRange range) {
  const double far = lens.far.value_or(kInfinity);
  return perspective(lens.fovy_radians, size.width / size.height, {lens.near, far, range})
      .map([&](const Transform<Clip, Eye>& m) { return projected(m, lens.near, far, true); });
}

Result<Projected> project(const OrthographicLens& lens, Pixels size, DepthRange range) {
  if (!(lens.half_height > 0) || std::isinf(lens.half_height)) {
    return fail("orthographic height", "half of it is " + number_text(lens.half_height),
                "give a positive number");
  }
  // Multiply before dividing, so that half_height = 240 in a picture of 640 x 480 gives exactly
  // 320.
  const double half_width = lens.half_height * size.width / size.height;
  return orthographic({-half_width, half_width, -lens.half_height, lens.half_height},
                      {lens.near, lens.far, range})
      .map([&](const Transform<Clip, Eye>& m) { return projected(m, lens.near, lens.far, false); });
}

Result<Projected> project(const FrustumLens& lens, Pixels, DepthRange range) {
  const double far = lens.far.value_or(kInfinity);
  return frustum({lens.left, lens.right, lens.bottom, lens.top}, {lens.near, far, range})
      .map([&](const Transform<Clip, Eye>& m) { return projected(m, lens.near, far, true); });
}

// Whether the entry is the slope of depth and subnormal. Such a slope is allowed: rounding changes
// it by at most 2^-150, half of the smallest float, and the depth by no more, because depth is
// (slope * z + offset) / w and |z| is w. Reversed depth has such a slope where far/near is beyond
// 2^126 (C-10). The slope must not become zero, which would be a different matrix: that of an
// infinite far plane.
bool is_slope_of_depth(int row, int column, double entry) {
  return row == 2 && column == 2 && float(entry) != 0 && std::abs(entry) < kFloatMin;
}

// Reports a matrix entry, near or far plane that float cannot hold. The stages work in float, so
// without this check the picture would be wrong without a message.
Result<void> check_float_range(const Projected& p) {
  const auto fits = [](double value) {
    const double size = std::abs(value);
    return size == 0 || (size >= kFloatMin && size <= kFloatMax);
  };
  if (!fits(p.near)) {
    return fail("near plane",
                "its distance " + number_text(p.near) + " is too large or too small for a float",
                "scale the scene");
  }
  if (!std::isinf(p.far) && !fits(p.far)) {
    return fail("far plane",
                "its distance " + number_text(p.far) + " is too large or too small for a float",
                "scale the scene, or give inf");
  }
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      const double entry = p.clip_from_eye.at(row, column);
      if (fits(entry) || is_slope_of_depth(row, column, entry)) continue;
      return fail("projection",
                  "the matrix entry (" + std::to_string(row) + ", " + std::to_string(column) +
                      ") is " + number_text(entry) +
                      ", which is too large or too small for a float",
                  "choose a field of view, window and planes of more ordinary size");
    }
  }
  return {};
}

}  // namespace

Result<void> check_picture_size(int width, int height) {
  return check_size(width, "width").and_then([&] { return check_size(height, "height"); });
}

Result<View> make_view(const Camera& camera, int width, int height, DepthRange depth_range) {
  if (const Result<void> ok = check_picture_size(width, height); !ok) {
    return tl::unexpected(ok.error());
  }
  const Result<Transform<World, Eye>> pose = rigid_pose(camera.world_from_eye);
  if (!pose) return tl::unexpected(pose.error());
  const Pixels size{double(width), double(height)};
  const Result<Projected> projected =
      std::visit([&](const auto& lens) { return project(lens, size, depth_range); }, camera.lens);
  if (!projected) return tl::unexpected(projected.error());
  if (const Result<void> ok = check_float_range(*projected); !ok) return tl::unexpected(ok.error());

  View view;
  view.eye_from_world = inverse_rigid(*pose);
  view.clip_from_eye = projected->clip_from_eye;
  view.viewport = {0, 0, float(width), float(height)};
  view.depth_range = depth_range;
  view.perspective = projected->perspective;
  view.near = projected->near;
  view.far = projected->far;
  return view;
}

}  // namespace glassbox
