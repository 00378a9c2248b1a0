#include <glassbox/images/stereo/recolour.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include <glassbox/images/colour/ciede2000.h>
#include <glassbox/images/out_of_memory.h>

namespace glassbox {
namespace {

Lab lab_of(const Linear& colour) {
  return lab_of_linear(double(colour[0]), double(colour[1]), double(colour[2]));
}

// A colour of the pictures and the fraction of the pixels that have it.
struct Colour {
  Linear linear{};
  Lab lab;
  double share = 0;  // the fraction of all pixels with this colour
};
using Palette = std::vector<Colour>;

constexpr std::size_t kSearchedColours = 4096;  // 16 levels of each channel: 16^3

std::uint32_t packed(const Rgba8& pixel) {
  return std::uint32_t(pixel.r) << 16 | std::uint32_t(pixel.g) << 8 | pixel.b;
}

Palette palette_of(const Image<Rgba8>& left, const Image<Rgba8>& right) {
  std::vector<std::uint32_t> codes;
  codes.reserve(left.pixels.size() + right.pixels.size());
  for (const Image<Rgba8>* picture : {&left, &right}) {
    for (const Rgba8& pixel : picture->pixels) codes.push_back(packed(pixel));
  }
  std::sort(codes.begin(), codes.end());
  Palette palette;
  for (std::size_t begin = 0, end; begin < codes.size(); begin = end) {
    const std::uint32_t code = codes[begin];
    for (end = begin; end < codes.size() && codes[end] == code;) ++end;
    Colour colour;
    colour.linear =
        linear_of({std::uint8_t(code >> 16), std::uint8_t(code >> 8), std::uint8_t(code), 255});
    colour.lab = lab_of(colour.linear);
    colour.share = double(end - begin) / double(codes.size());
    palette.push_back(colour);
  }
  return palette;
}

// Merges similar colours into one, their mean in linear light.
Palette grouped_colours(const Palette& palette) {
  if (palette.size() <= kSearchedColours) return palette;
  struct Sum {
    double at[3] = {}, share = 0;
  };
  std::vector<Sum> sums(kSearchedColours);
  for (const Colour& colour : palette) {
    std::size_t group = 0;
    for (const float channel : colour.linear) group = group * 16 + encode_srgb(channel) / 16;
    Sum& sum = sums[group];
    for (std::size_t i = 0; i < 3; ++i) sum.at[i] += double(colour.linear[i]) * colour.share;
    sum.share += colour.share;
  }
  Palette groups;
  for (const Sum& sum : sums) {
    if (sum.share == 0) continue;
    Colour colour;
    for (std::size_t i = 0; i < 3; ++i) colour.linear[i] = float(sum.at[i] / sum.share);
    colour.lab = lab_of(colour.linear);
    colour.share = sum.share;
    groups.push_back(colour);
  }
  return groups;
}

double mean_rivalry(const Palette& palette, const Rivalry& rivalry, const Recolour& recolour) {
  double sum = 0;
  for (const Colour& colour : palette) {
    sum += colour.share * rivalry(recoloured(colour.linear, recolour));
  }
  return sum;
}

double mean_difference(const Palette& palette, const Recolour& recolour) {
  double sum = 0;
  for (const Colour& colour : palette) {
    sum += colour.share * ciede2000(colour.lab, lab_of(recoloured(colour.linear, recolour)));
  }
  return sum;
}

Compromise measure(const Palette& palette, const Rivalry& rivalry, const Recolour& recolour) {
  return {recolour, mean_rivalry(palette, rivalry, recolour), mean_difference(palette, recolour)};
}

// Rivalry below this value is float rounding error: luma's weights add up to 1 only within 2^-24.
constexpr double kNoRivalry = 1e-6;

// Returns the smallest k (desaturation), within 2^-20, that reduces the rivalry to `target`, or 1
// if none does.
double least_desaturation(const Palette& palette, const Rivalry& rivalry, double brighten,
                          double target) {
  const auto rivalry_at = [&](double k) { return mean_rivalry(palette, rivalry, {k, brighten}); };
  const auto meets = [&](double k) { return rivalry_at(k) <= target + kNoRivalry; };
  const double undulled = rivalry_at(0);
  if (undulled <= target + kNoRivalry) return 0;
  double too_little = 0, enough = 1;
  // If no colour is clamped, the rivalry is 1 - k times the rivalry for k = 0, which gives a first
  // guess.
  constexpr double kClose = 0x1p-20;
  const double guess = 1 - target / undulled;
  if (guess > kClose && !meets(guess - kClose)) too_little = guess - kClose;
  if (guess < 1 - kClose && meets(guess + kClose)) enough = guess + kClose;
  while (enough - too_little > 2 * kClose) {
    const double middle = (too_little + enough) / 2;
    (meets(middle) ? enough : too_little) = middle;
  }
  return enough;
}

Compromise best(const Palette& palette, const Rivalry& rivalry, double target) {
  const auto with = [&](double brighten) {
    const double k = least_desaturation(palette, rivalry, brighten, target);
    return measure(palette, rivalry, {k, brighten});
  };
  constexpr double kStep = 1.0 / 32;
  Compromise best = with(0);
  for (double brighten = kStep; brighten <= 1; brighten += kStep) {
    const Compromise next = with(brighten);
    if (next.difference < best.difference) best = next;
    // If the target is met without any desaturation, more brightening only increases the
    // difference.
    if (next.recolour.desaturate == 0) break;
  }
  for (double step = kStep / 2; step > 1e-4; step /= 2) {
    const double centre = best.recolour.brighten;
    for (const double brighten : {centre - step, centre + step}) {
      if (brighten < 0 || brighten > 1) continue;
      const Compromise next = with(brighten);
      if (next.difference < best.difference) best = next;
    }
  }
  return best;
}

}  // namespace

Result<void> check_recolour(const Recolour& recolour) {
  const auto is_strength = [](double value) { return value >= 0 && value <= 1; };
  if (is_strength(recolour.desaturate) && is_strength(recolour.brighten)) return {};
  return fail("recolour",
              fmt::format("desaturation is {} and brightening is {}, but both must be in [0, 1]",
                          recolour.desaturate, recolour.brighten),
              "give strengths from 0 (none) to 1 (all)");
}

Linear recoloured(const Linear& colour, const Recolour& recolour) {
  const float k = float(recolour.desaturate), b = float(recolour.brighten);
  const float grey = luma(colour);
  Linear changed;
  for (std::size_t i = 0; i < 3; ++i) {
    const float duller = colour[i] + k * (grey - colour[i]);
    changed[i] = std::clamp(duller + b * (1 - duller), 0.0f, 1.0f);
  }
  return changed;
}

Result<Image<Rgba8>> recoloured(const Image<Rgba8>& picture, const Recolour& recolour) {
  if (const auto checked = check_recolour(recolour); !checked) {
    return tl::unexpected(checked.error());
  }
  return unless_out_of_memory([&]() -> Result<Image<Rgba8>> {
    Image<Rgba8> changed = picture;
    for (Rgba8& pixel : changed.pixels) {
      const auto [r, g, b] = recoloured(linear_of(pixel), recolour);
      pixel = {encode_srgb(r), encode_srgb(g), encode_srgb(b), pixel.a};
    }
    return changed;
  });
}

Result<Compromise> measure_recolour(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                    const AnaglyphViewing& viewing, const Recolour& recolour) {
  if (const auto checked = check_eyes("recolour", left, right); !checked) {
    return tl::unexpected(checked.error());
  }
  if (const auto checked = check_recolour(recolour); !checked) {
    return tl::unexpected(checked.error());
  }
  return unless_out_of_memory([&]() -> Result<Compromise> {
    return measure(palette_of(left, right), Rivalry(viewing), recolour);
  });
}

Result<Suggestion> suggest_recolour(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                    const AnaglyphViewing& viewing, double target,
                                    int curve_points) {
  if (const auto checked = check_eyes("recolour", left, right); !checked) {
    return tl::unexpected(checked.error());
  }
  if (!(target >= 0) || !std::isfinite(target)) {
    return fail("rivalry target", fmt::format("{} is not a number of at least 0", target),
                "give a mean rivalry, such as 0.1");
  }
  return unless_out_of_memory([&]() -> Result<Suggestion> {
    const Rivalry rivalry(viewing);
    const Palette palette = palette_of(left, right);
    const Palette searched = grouped_colours(palette);
    Suggestion suggestion;

    const double unchanged = mean_rivalry(searched, rivalry, {});
    const int steps = std::max(curve_points, 2) - 1;
    for (int i = 0; i <= steps; ++i) {
      suggestion.curve.push_back(best(searched, rivalry, unchanged * (steps - i) / steps));
    }

    Recolour chosen = best(searched, rivalry, target).recolour;
    chosen.desaturate =
        std::max(chosen.desaturate, least_desaturation(palette, rivalry, chosen.brighten, target));
    suggestion.chosen = measure(palette, rivalry, chosen);
    suggestion.meets_target = suggestion.chosen.rivalry <= target + kNoRivalry;
    return suggestion;
  });
}

}  // namespace glassbox
