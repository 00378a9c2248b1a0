// Stereo pairs with errors.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glassbox/images/stereo/anaglyph.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/render/engine/framebuffer.h>

namespace glassbox::study::naive {

// ---- two passes over one buffer ----

// Tests the right eye's pixels against the depths that the left eye has left in the buffer: objects
// that are nearer in the left eye's picture punch holes into the right eye's picture.
inline Image<Rgba8> anaglyph_without_clearing_depth(const Framebuffer& left,
                                                    const Framebuffer& right,
                                                    const Rgba8& background) {
  Image<Rgba8> shown = left.color;
  for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
    const bool passes = right.depth.pixels[i] < left.depth.pixels[i];
    const Rgba8& source = passes ? right.color.pixels[i] : background;
    shown.pixels[i].g = source.g;
    shown.pixels[i].b = source.b;
  }
  return shown;
}

// Clears colour as well as depth between the passes of the two eyes: nothing remains of the left
// eye's picture.
inline Image<Rgba8> anaglyph_with_colour_cleared(const Framebuffer& right,
                                                 const Rgba8& background) {
  Image<Rgba8> shown = right.color;
  for (Rgba8& pixel : shown.pixels) pixel.r = background.r;
  return shown;
}

// ---- anaglyphs in bytes ----

// A number that does not fit wraps around: negative values of red become bright.
inline std::uint8_t wrapped_byte(double value) {
  return std::uint8_t(std::int64_t(std::lround(value * 255)) & 255);
}

// ---- changes of the window ----

// Smooths the distance of the stereo window with a low-pass filter. It should smooth the inverse of
// the distance, because parallax is linear in the inverse.
class FilterOfDistance {
public:
  explicit FilterOfDistance(double frames) : share_(1 / (1 + frames)) {}
  double next(double window) {
    if (std::isnan(current_)) current_ = window;
    return current_ += share_ * (window - current_);
  }

private:
  double share_, current_ = NAN;
};

// Moves the stereo window like a spring with too little damping: it overshoots the goal.
class Spring {
public:
  double next(double window) {
    const double goal = 1 / window;
    if (std::isnan(current_)) current_ = goal;
    speed_ = 0.9 * speed_ + 0.02 * (goal - current_);
    current_ += speed_;
    return 1 / current_;
  }

private:
  double current_ = NAN, speed_ = 0;
};

}  // namespace glassbox::study::naive
