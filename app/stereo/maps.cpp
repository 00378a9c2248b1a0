#include "app/stereo/report.h"

#include <algorithm>
#include <cmath>

#include <glassbox/compare/pixels/heat_map.h>

namespace glassbox::app {

namespace {

constexpr Rgba8 kOrange{230, 126, 20, 255}, kBlue{70, 140, 225, 255};
constexpr Rgba8 kRed{225, 40, 40, 255}, kMagenta{215, 60, 190, 255};
constexpr Rgba8 kWindow{240, 240, 236, 255}, kNothing{88, 92, 100, 255};
constexpr Rgba8 kFarthestOut{150, 62, 0, 255}, kFarthestIn{16, 52, 140, 255};

std::uint8_t mix_channel(std::uint8_t a, std::uint8_t b, double share) {
  return std::uint8_t(std::lround(a + (b - a) * share));
}

Rgba8 mix_colours(const Rgba8& a, const Rgba8& b, double share) {
  return {mix_channel(a.r, b.r, share), mix_channel(a.g, b.g, share), mix_channel(a.b, b.b, share),
          255};
}

// Turns the picture into dark greys, so that coloured marks stand out.
Rgba8 darkened_grey(const Rgba8& pixel) {
  const auto level = std::uint8_t((299 * pixel.r + 587 * pixel.g + 114 * pixel.b) / 2000 + 16);
  return {level, level, level, pixel.a};
}

template <class Mark, class Colour>
Image<Rgba8> draw_marks(const Image<Rgba8>& picture, const Image<Mark>& marks,
                        const Colour& colour_of) {
  Image<Rgba8> out(picture.width, picture.height);
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    out.pixels[i] = colour_of(marks.pixels[i], darkened_grey(picture.pixels[i]));
  }
  return out;
}

}  // namespace

Rgba8 disparity_colour(double px, double limit_px) {
  const double share = limit_px > 0 ? std::clamp(px / limit_px, -1.0, 1.0) : 0;
  // On each side of 0 the scale runs over a medium to a dark colour: large disparities differ from
  // small ones in brightness too, so that the map can be read without seeing colours.
  const Rgba8& middle = share < 0 ? kOrange : kBlue;
  const Rgba8& end = share < 0 ? kFarthestOut : kFarthestIn;
  const double size = std::abs(share);
  return size < 0.5 ? mix_colours(kWindow, middle, 2 * size)
                    : mix_colours(middle, end, 2 * size - 1);
}

Image<Rgba8> disparity_picture(const Image<float>& disparity, const ParallaxBudget& budget,
                               double limit_px) {
  constexpr int kStripe = 4;  // width of a stripe, px
  Image<Rgba8> out(disparity.width, disparity.height, kNothing);
  for (int y = 0; y < disparity.height; ++y) {
    for (int x = 0; x < disparity.width; ++x) {
      const double px = double(disparity.at(x, y));
      if (!std::isfinite(px)) continue;
      const bool beyond = px < -budget.in_front_px || px > budget.behind_px;
      const bool striped = beyond && (x + y) / kStripe % 2 == 0;
      out.at(x, y) = striped ? Rgba8{20, 20, 20, 255} : disparity_colour(px, limit_px);
    }
  }
  return out;
}

Image<Rgba8> heat_of(const Image<float>& values, double limit) {
  Image<Rgba8> out(values.width, values.height);
  for (std::size_t i = 0; i < values.pixels.size(); ++i) {
    const double size = std::abs(double(values.pixels[i]));
    out.pixels[i] = heat_colour(limit > 0 ? size / limit : 0);
  }
  return out;
}

Image<float> larger_of(const Image<float>& a, const Image<float>& b) {
  Image<float> larger(a.width, a.height);
  for (std::size_t i = 0; i < larger.pixels.size(); ++i) {
    larger.pixels[i] = std::max(std::abs(a.pixels[i]), std::abs(b.pixels[i]));
  }
  return larger;
}

Image<Rgba8> information_picture(const Image<Rgba8>& left, const Image<std::uint8_t>& marks) {
  return draw_marks(left, marks, [](std::uint8_t mark, const Rgba8& dim) {
    if ((mark & kMarkEdge) == 0) return dim;
    return (mark & kMarkDisplaced) != 0 ? kOrange : kBlue;
  });
}

Image<Rgba8> violation_picture(const Image<Rgba8>& eye, const Image<std::uint8_t>& marks) {
  return draw_marks(eye, marks, [](std::uint8_t mark, const Rgba8& dim) {
    return mark != 0 ? mix_colours(dim, kRed, 0.75) : dim;
  });
}

Image<Rgba8> monocular_picture(const Image<Rgba8>& eye, const Image<OtherEyeVisibility>& map) {
  return draw_marks(eye, map, [](OtherEyeVisibility seen, const Rgba8& dim) {
    switch (seen) {
      case OtherEyeVisibility::kHidden:
        return kOrange;
      case OtherEyeVisibility::kOutsidePicture:
        return kBlue;
      case OtherEyeVisibility::kMissing:
        return kMagenta;
      case OtherEyeVisibility::kNothingDrawn:
      case OtherEyeVisibility::kVisible:
        break;
    }
    return dim;
  });
}

}  // namespace glassbox::app
