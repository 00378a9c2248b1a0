#include <glassbox/compare/pixels/difference_text.h>

#include <fmt/format.h>

#include <glassbox/base/counted.h>
#include <glassbox/compare/pixels/tolerance.h>

namespace glassbox {

std::string pixel_text(const StoredImage& image, PixelPosition pixel) {
  const auto channels = std::size_t(image.channels);
  const std::size_t first =
      (std::size_t(pixel.y) * std::size_t(image.width) + std::size_t(pixel.x)) * channels;
  std::string text;
  std::visit(
      [&](const auto& samples) {
        for (std::size_t i = 0; i < channels; ++i) {
          text += fmt::format("{}{}", i == 0 ? "" : ", ", samples[first + i]);
        }
      },
      image.samples);
  return channels == 1 ? text : "(" + text + ")";
}

std::string steps_text(std::uint32_t steps, const StoredImage& image) {
  if (steps == kUnbounded) return "an infinite difference";
  if (std::holds_alternative<std::vector<float>>(image.samples)) return counted(steps, "ulp");
  const bool bytes = std::holds_alternative<std::vector<std::uint8_t>>(image.samples);
  return fmt::format("{}/{}", steps, bytes ? 255 : 65535);
}

std::string differences_text(const PicturePair& pair, const Differences& found) {
  const std::string extent = found.largest == kUnbounded
                                 ? "some by an infinite difference"
                                 : "by up to " + steps_text(found.largest, pair.reference);
  return fmt::format("{} of {} pixels differ, {}, in {}; first ({}, {}): {} became {}",
                     found.differing, found.compared, extent, counted(found.region_count, "region"),
                     found.first.x, found.first.y, pixel_text(pair.reference, found.first),
                     pixel_text(pair.test, found.first));
}

std::string suggested_fuzzy(const Differences& found) {
  if (found.largest == kUnbounded)
    return "no --fuzzy allows NaN or an infinity in place of a number";
  return to_string(tightest_fuzzy(found));
}

}  // namespace glassbox
