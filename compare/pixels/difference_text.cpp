#include <glassbox/compare/pixels/difference_text.h>

#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <glassbox/base/counted.h>
#include <glassbox/compare/pixels/perceived_distance.h>
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

namespace {

// "set aside: 40 pixels at moved edges (by up to 9/255)"; empty where there are none.
std::string set_aside_text(const Differences& found, const StoredImage& image) {
  std::vector<std::string> parts;
  const auto add = [&](const SetAsidePixels& aside, const char* where) {
    if (aside.pixels == 0) return;
    parts.push_back(fmt::format("{} {} (by up to {})", counted(aside.pixels, "pixel"), where,
                                steps_text(aside.largest, image)));
  };
  add(found.moved_edges, "at moved edges");
  add(found.below_threshold, "below the threshold");
  return parts.empty() ? "" : fmt::format("set aside: {}", fmt::join(parts, ", "));
}

}  // namespace

std::string differences_text(const PicturePair& pair, const Differences& found) {
  const std::string aside = set_aside_text(found, pair.reference);
  if (found.differing == 0) {
    return fmt::format("none of {} pixels differs, except those {}", found.compared, aside);
  }
  const std::string extent = found.largest == kUnbounded
                                 ? "some by an infinite difference"
                                 : "by up to " + steps_text(found.largest, pair.reference);
  return fmt::format("{} of {} pixels differ, {}, in {}; first ({}, {}): {} became {}{}{}",
                     found.differing, found.compared, extent, counted(found.region_count, "region"),
                     found.first.x, found.first.y, pixel_text(pair.reference, found.first),
                     pixel_text(pair.test, found.first), aside.empty() ? "" : "; ", aside);
}

std::string suggested_fuzzy(const Differences& found) {
  if (found.largest == kUnbounded)
    return "no --fuzzy allows NaN or an infinity in place of a number";
  return to_string(lasting_fuzzy(found));
}

std::string suggested_options(const PicturePair& pair, const Differences& found) {
  if (found.differing == 0 || found.largest == kUnbounded) return {};
  const std::string pixels = fmt::format("--max-differing {}", found.differing);
  const double distance = largest_distance(pair);
  if (distance > 1) return pixels;
  // Rounded up to four decimals, so that the largest distance is allowed.
  return fmt::format("{}, or --threshold {:.4f}", pixels, std::ceil(distance * 1e4) / 1e4);
}

}  // namespace glassbox
