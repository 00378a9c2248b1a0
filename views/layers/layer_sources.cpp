#include "views/layers/layer_sources.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

#include <glassbox/images/read.h>

namespace glassbox::views {

namespace {

Error in_file(const std::string& file, const Error& error) {
  return Error{file, error.place, error.cause, error.remedy};
}

// Replaces distances that are not positive and finite by "no surface". Returns the smallest
// remaining distance, or infinity.
double clean(Image<float>& distance) {
  double nearest = std::numeric_limits<double>::infinity();
  for (float& z : distance.pixels) {
    if (!(z > 0) || !std::isfinite(z)) {
      z = std::numeric_limits<float>::infinity();
    } else {
      nearest = std::min(nearest, double(z));
    }
  }
  return nearest;
}

Result<SourcePicture> read_picture(const std::string& folder, const NamedCamera& named) {
  const std::filesystem::path path = std::filesystem::path(folder) / named.picture;
  std::filesystem::path beside = path;
  beside.replace_extension(".pfm");
  auto color = read_image(path.string());
  if (!color) return tl::unexpected(color.error());
  auto distance = read_pfm(beside.string());
  if (!distance) return tl::unexpected(distance.error());
  if (color->width != distance->width || color->height != distance->height) {
    return fail(beside.string(),
                fmt::format("has {} x {} distances, but the picture has {} x {} pixels",
                            distance->width, distance->height, color->width, color->height),
                "give one distance for each pixel");
  }
  return SourcePicture{named.picture, {}, {}, std::move(*color), std::move(*distance)};
}

}  // namespace

Result<Camera> camera_of_pinhole(const PinholeCamera& pinhole, int width, int height, double near,
                                 std::optional<double> far) {
  const Matrix3d& k = pinhole.intrinsic;
  if (k(0, 1) != 0) {
    return fail(
        "K",
        fmt::format(
            "this intrinsic matrix of a camera has the skew {:g}, so the pixels are not rectangles",
            k(0, 1)),
        "rectify the picture first");
  }
  // The pinhole camera shows the point (X, Y, Z) at the pixel (fx X/Z + cx, fy Y/Z + cy), y down,
  // where fx, fy, cx and cy are entries of K.
  const double left = -k(0, 2) / k(0, 0), right = (width - k(0, 2)) / k(0, 0);
  const double top = k(1, 2) / k(1, 1), bottom = (k(1, 2) - height) / k(1, 1);
  Camera camera;
  camera.lens = FrustumLens{left * near, right * near, bottom * near, top * near, near, far};
  const Matrix3d world_from_eye =
      pinhole.camera_from_world.transpose() * Vector3d(1, -1, -1).asDiagonal();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      camera.world_from_eye.at(row, column) = world_from_eye(row, column);
    }
    camera.world_from_eye.at(row, 3) = pinhole.centre[row];
  }
  return camera;
}

Result<std::vector<NamedCamera>> read_cameras(const std::string& file) {
  constexpr std::uint64_t kMaxBytes = 16 << 20;
  const auto bytes = read_file(file, kMaxBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto cameras = parse_cameras({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
  if (!cameras) return tl::unexpected(in_file(file, cameras.error()));
  if (cameras->empty()) return fail(file, "names no camera", "give at least one camera");
  return cameras;
}

Result<std::vector<SourcePicture>> read_source_pictures(const std::string& file) {
  const auto cameras = read_cameras(file);
  if (!cameras) return tl::unexpected(cameras.error());
  const std::string folder = std::filesystem::path(file).parent_path().string();
  std::vector<SourcePicture> pictures;
  double nearest = std::numeric_limits<double>::infinity();
  for (const NamedCamera& named : *cameras) {
    auto picture = read_picture(folder, named);
    if (!picture) return tl::unexpected(picture.error());
    nearest = std::min(nearest, clean(picture->distance));
    pictures.push_back(std::move(*picture));
  }
  if (!std::isfinite(nearest))
    return fail(file, "none of its pictures has a distance",
                "check the .pfm files beside the pictures");
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    SourcePicture& picture = pictures[i];
    auto camera = camera_of_pinhole((*cameras)[i].camera, picture.color.width, picture.color.height,
                                    nearest / 2, std::nullopt);
    if (!camera) return tl::unexpected(in_file(file, camera.error()));
    picture.camera = *camera;
    auto view = make_view(*camera, picture.color.width, picture.color.height);
    if (!view) return tl::unexpected(in_file(file, view.error()));
    picture.view = *view;
  }
  return pictures;
}

}  // namespace glassbox::views
