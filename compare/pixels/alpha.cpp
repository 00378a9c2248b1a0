#include <glassbox/compare/pixels/alpha.h>

#include <limits>
#include <type_traits>

namespace glassbox {

bool is_opaque(const StoredImage& image) {
  if (!has_alpha(image.channels)) return false;
  return std::visit(
      [&](const auto& samples) {
        using Sample = typename std::decay_t<decltype(samples)>::value_type;
        const auto step = std::size_t(image.channels);
        const Sample full = std::is_integral_v<Sample> ? std::numeric_limits<Sample>::max() : 1;
        for (std::size_t i = step - 1; i < samples.size(); i += step) {
          if (samples[i] != full) return false;
        }
        return true;
      },
      image.samples);
}

StoredImage without_alpha(const StoredImage& image) {
  StoredImage plain{image.width, image.height, image.channels - 1, {}};
  std::visit(
      [&](const auto& samples) {
        std::decay_t<decltype(samples)> kept;
        const auto step = std::size_t(image.channels);
        kept.reserve(image.pixels() * (step - 1));
        for (std::size_t i = 0; i < samples.size(); ++i) {
          if (i % step != step - 1) kept.push_back(samples[i]);
        }
        plain.samples = std::move(kept);
      },
      image.samples);
  return plain;
}

}  // namespace glassbox
