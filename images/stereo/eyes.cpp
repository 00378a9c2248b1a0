#include <glassbox/images/stereo/eyes.h>

#include <fmt/format.h>

namespace glassbox {

Result<void> check_eyes(std::string place, const Image<Rgba8>& left, const Image<Rgba8>& right) {
  if (left.width == right.width && left.height == right.height) return {};
  return fail(std::move(place),
              fmt::format("the left eye's picture has {}x{} pixels, the right eye's {}x{}",
                          left.width, left.height, right.width, right.height),
              "give both the same size");
}

}  // namespace glassbox
