#include <glassbox/images/image_size.h>

#include <string>

namespace glassbox {

Result<void> check_image_size(std::uint64_t width, std::uint64_t height, std::uint64_t bytes,
                              std::uint64_t pixels_per_byte, const DecodeLimits& limits) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width == 0 || height == 0)
    return fail("", "the image has " + size, "use an image with at least one pixel");
  if (width > limits.max_side || height > limits.max_side) {
    return fail("",
                "the image has " + size + ", but a side may have at most " +
                    std::to_string(limits.max_side),
                "scale the image down");
  }
  // Sides are 32-bit numbers, so the product cannot overflow.
  if (width * height > limits.max_pixels) {
    return fail("",
                "the image has " + size + ", but may have at most " +
                    std::to_string(limits.max_pixels) + " in all",
                "scale the image down");
  }
  if (width * height / pixels_per_byte > bytes) {
    return fail("", "an image of " + size + " cannot fit into " + std::to_string(bytes) + " bytes",
                "the file is cut off, or its width or height is wrong: save the image again");
  }
  return {};
}

}  // namespace glassbox
