#include <glassbox/images/stereo/check_eyes.h>

#include <fmt/format.h>

namespace glassbox {

Result<void> check_eyes(std::string place, const Image<Rgba8>& left, const Image<Rgba8>& right) {
  if (left.width == right.width && left.height == right.height) return {};
  return fail(std::move(place),
              fmt::format("the left eye's picture has {}x{} pixels, the right eye's {}x{}",
                          left.width, left.height, right.width, right.height),
              "give both the same size");
}

Result<void> check_disparity(const Image<Rgba8>& picture, const Image<float>& disparity) {
  if (picture.width == disparity.width && picture.height == disparity.height) return {};
  return fail("disparity",
              fmt::format("the disparity map has {}x{} pixels, but the picture has {}x{}",
                          disparity.width, disparity.height, picture.width, picture.height),
              "make the disparity map for this picture");
}

}  // namespace glassbox
