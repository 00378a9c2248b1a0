#include <glassbox/images/image_size.h>

#include <string>

namespace glassbox {

Result<void> check_image_size(std::uint64_t width, std::uint64_t height, std::uint64_t bytes,
                              std::uint64_t pixels_per_byte, const DecodeLimits& limits) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width == 0 || height == 0) return fail("", "image of " + size, "give it a size above zero");
  if (width > limits.max_side || height > limits.max_side) {
    return fail(
        "", "image of " + size + ", sides above the limit of " + std::to_string(limits.max_side),
        "scale it down or raise the limit on the side");
  }
  // Sides are 32-bit numbers, so the product cannot overflow.
  if (width * height > limits.max_pixels) {
    return fail("",
                "image of " + size + ", more than the limit of " +
                    std::to_string(limits.max_pixels) + " in all",
                "scale it down or raise the limit on pixels");
  }
  if (width * height / pixels_per_byte > bytes) {
    return fail("", "image of " + size + " cannot fit into " + std::to_string(bytes) + " bytes",
                "the file is cut off or its size field is wrong: save it again");
  }
  return {};
}

}  // namespace glassbox
