#include "views/files/colmap_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

namespace glassbox::views {

namespace {

constexpr const char* kUndistort =
    "undistort the pictures (colmap image_undistorter), which makes the model PINHOLE";

Result<Matrix3d> intrinsic_of(const ColmapLens& lens) {
  const auto& [name, focal, parameters, is_pinhole] = lens.kind;
  if (!is_pinhole) {
    return fail(lens.place, in_quotes(name) + " is not a pinhole model", kUndistort);
  }
  const std::vector<double>& n = lens.parameters;
  const double fx = n[0], fy = n[focal - 1];
  if (!(fx > 0) || !(fy > 0)) {
    return fail(lens.place, "a focal length is not positive",
                "calibrate the camera again, and export the model again");
  }
  const std::size_t distortion = focal + 2;
  if (std::any_of(n.begin() + std::ptrdiff_t(distortion), n.end(),
                  [](double k) { return k != 0; })) {
    return fail(
        lens.place,
        "the camera has distortion, but only pinhole cameras without distortion can be read",
        kUndistort);
  }
  Matrix3d k;
  k << fx, 0, n[focal], 0, fy, n[focal + 1], 0, 0, 1;
  return k;
}

// The quaternions whose length is nearly 1, but not to the digits that a file has.
struct NearlyUnit {
  std::size_t count = 0;
  std::string first_place;
  double first_length = 1;

  void add(const std::string& place, double length) {
    if (count++ > 0) return;
    first_place = place;
    first_length = length;
  }
  std::string warning() const {
    const std::string others =
        count == 1 ? "" : ", as did those of " + counted(count - 1, "other picture");
    return fmt::format("{}: the quaternion had the length {:.6g} and was made one of length 1{}",
                       first_place, first_length, others);
  }
};

Result<Matrix3d> turn_of(const ColmapPicture& picture, NearlyUnit& nearly_unit) {
  const auto& [w, x, y, z] = picture.turn;
  const Eigen::Quaterniond turn(w, x, y, z);
  constexpr double kFewDigits = 1e-3, kNearly = 0.1;
  const double off = std::abs(turn.norm() - 1);
  if (!(off <= kNearly)) {
    return fail(picture.place,
                fmt::format("the length of the quaternion is {:.6g}, but a rotation needs length 1",
                            turn.norm()),
                "give a quaternion of length 1");
  }
  if (off > kFewDigits) nearly_unit.add(picture.place, turn.norm());
  return turn.normalized().toRotationMatrix();
}

Result<NamedCamera> camera_of(const ColmapPicture& picture, const ColmapLenses& lenses,
                              NearlyUnit& nearly_unit) {
  const auto rotation = turn_of(picture, nearly_unit);
  if (!rotation) return tl::unexpected(rotation.error());
  const auto found = lenses.find(picture.lens);
  if (found == lenses.end()) {
    return fail(
        picture.place,
        fmt::format("there is no camera with the number {} that this picture names", picture.lens),
        "export both files together");
  }
  const Result<ColmapLens>& lens = found->second;
  if (!lens) return tl::unexpected(lens.error());
  const auto intrinsic = intrinsic_of(*lens);
  if (!intrinsic) return tl::unexpected(intrinsic.error());
  return NamedCamera{
      picture.name, {*intrinsic, *rotation, -rotation->transpose() * picture.shift}, lens->size};
}

}  // namespace

Result<ImageSize> colmap_size(const std::string& place, double width, double height) {
  const auto is_side = [](double side) {
    return side >= 1 && side <= 4294967295.0 && side == std::floor(side);
  };
  if (is_side(width) && is_side(height)) {
    return ImageSize{std::uint32_t(width), std::uint32_t(height)};
  }
  return fail(place, fmt::format("a picture cannot have {:g} x {:g} pixels", width, height),
              "export the model again");
}

Result<ColmapModel> colmap_model(const ColmapLenses& lenses,
                                 const std::vector<ColmapPicture>& pictures) {
  ColmapModel model;
  NearlyUnit nearly_unit;
  for (const ColmapPicture& picture : pictures) {
    auto camera = camera_of(picture, lenses, nearly_unit);
    if (!camera) return tl::unexpected(camera.error());
    model.cameras.push_back(std::move(*camera));
  }
  std::ranges::sort(model.cameras, {}, &NamedCamera::picture);
  const auto twice = std::ranges::adjacent_find(model.cameras, {}, &NamedCamera::picture);
  if (twice != model.cameras.end()) {
    return fail("", "two pictures have the name " + in_quotes(twice->picture),
                "give each picture its own name");
  }
  if (nearly_unit.count > 0) model.warnings.push_back(nearly_unit.warning());
  return model;
}

}  // namespace glassbox::views
