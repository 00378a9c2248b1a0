#include "views/commands/geometry.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "views/commands/opaque_picture.h"
#include "views/files/camera_file.h"
#include "views/files/match_file.h"

#include <glassbox/base/printable.h>
#include <glassbox/images/read.h>

namespace glassbox::views {

namespace {

using NamedCameras = std::vector<views::NamedCamera>;

Result<std::string> text_of_file(const std::string& path) {
  constexpr std::uint64_t kMaxBytes = std::uint64_t(1) << 28;
  return read_file(path, kMaxBytes).map([](const std::vector<std::byte>& bytes) {
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  });
}

// Parses a file. Errors begin with the file's name.
template <class Parse>
auto parse_file(const std::string& path, const Parse& parse)
    -> decltype(parse(std::string_view())) {
  const Result<std::string> text = text_of_file(path);
  if (!text) return tl::unexpected(text.error());
  auto result = parse(*text);
  if (!result) result.error().file = path;
  return result;
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

const views::NamedCamera* camera_named(const NamedCameras& cameras, const std::string& picture) {
  const auto found = std::ranges::find(
      cameras, file_name(picture), [](const auto& camera) { return file_name(camera.picture); });
  return found == cameras.end() ? nullptr : &*found;
}

// The cameras of the two pictures, in the pictures' order. If there are exactly two cameras and the
// names do not decide (no camera has a picture's name, or both pictures have the same name), the
// first camera is taken for the left one.
Result<std::array<views::PinholeCamera, 2>> pair_cameras(const NamedCameras& cameras,
                                                         const GeometryFiles& files) {
  const std::string& file = *files.cameras;
  const bool are_two = cameras.size() == 2;
  if (cameras.size() < 2 || (!are_two && !files.has_pair())) {
    return tl::unexpected(
        Error{file, "", fmt::format("it has {} cameras, but a pair has two", cameras.size()),
              cameras.size() < 2
                  ? "add the other camera"
                  : "name the two pictures with --pair, or leave only two cameras in the file"});
  }
  const std::array in_order{cameras[0].camera, cameras[1].camera};
  if (!files.has_pair()) return in_order;
  const auto& [left_picture, right_picture] = files.pair;
  if (are_two && file_name(left_picture) == file_name(right_picture)) return in_order;
  const views::NamedCamera* left = camera_named(cameras, left_picture);
  const views::NamedCamera* right = camera_named(cameras, right_picture);
  if (left != nullptr && right != nullptr) return std::array{left->camera, right->camera};
  if (are_two && left == right) return in_order;
  return tl::unexpected(
      Error{file, "",
            fmt::format("none of its {} cameras is for {}", cameras.size(),
                        in_quotes(left == nullptr ? left_picture : right_picture)),
            are_two ? "name both pictures as the file of cameras does"
                    : "name the pictures as the file of cameras does, or leave only two cameras in "
                      "it: left, right"});
}

Result<void> add_cameras(const GeometryFiles& files, GeometryInput& input) {
  const auto pair = read_pair_cameras(files);
  if (!pair) return tl::unexpected(pair.error());
  const auto& [left, right] = *pair;
  input.intrinsics = {left.intrinsic, right.intrinsic};
  input.truth = views::relative_pose(left, right);
  return {};
}

Result<void> add_pictures(const GeometryFiles& files, GeometryInput& input) {
  const auto read = [&](const std::string& path) {
    return files.matches ? read_image(path) : read_opaque(path);
  };
  auto left = read(files.pair.first);
  if (!left) return tl::unexpected(left.error());
  auto right = read(files.pair.second);
  if (!right) return tl::unexpected(right.error());
  if (left->width != right->width || left->height != right->height) {
    return fail("--pair",
                fmt::format("the pictures are of unequal sizes, {} x {} and {} x {}", left->width,
                            left->height, right->width, right->height),
                "give two pictures of one size");
  }
  input.description += fmt::format(", {} x {}", left->width, left->height);
  input.pictures = {std::move(*left), std::move(*right)};
  input.picture_names = {files.pair.first, files.pair.second};
  return {};
}

}  // namespace

Result<std::array<views::PinholeCamera, 2>> read_pair_cameras(const GeometryFiles& files) {
  const auto cameras = parse_file(*files.cameras, views::parse_cameras);
  if (!cameras) return tl::unexpected(cameras.error());
  return pair_cameras(*cameras, files);
}

Result<GeometryInput> read_geometry_files(const GeometryFiles& files) {
  GeometryInput input;
  if (files.matches) {
    auto matches = parse_file(*files.matches, views::parse_matches);
    if (!matches) return tl::unexpected(matches.error());
    input.matches = std::move(*matches);
    input.description = *files.matches;
  } else {
    input.description = files.pair.first + " and " + files.pair.second;
  }
  if (files.cameras) {
    if (const auto added = add_cameras(files, input); !added) return tl::unexpected(added.error());
  }
  if (files.has_pair()) {
    if (const auto added = add_pictures(files, input); !added) return tl::unexpected(added.error());
  }
  return input;
}

}  // namespace glassbox::views
