// Compares the warped picture of the right eye with the drawn one: its error and its cost.
#pragma once

#include "views/layers/second_eye.h"

namespace glassbox::views {

// The difference of a channel, in levels of 0 .. 255, above which a pixel is wrong.
inline constexpr int kVisibleDifference = 8;

// The error of a picture compared with the correct one.
struct EyeError {
  double rms = 0;         // of red, green and blue, in levels of 0 .. 255
  int largest = 0;        // of a channel, in levels of 0 .. 255
  std::size_t wrong = 0;  // pixels with a channel off by more than kVisibleDifference
};
EyeError eye_error(const Image<Rgba8>& picture, const Image<Rgba8>& truth);

struct SecondEyeError {
  int layers = 1;
  std::size_t pixels = 0;
  std::size_t holes = 0;  // pixels in holes, which were filled with what is behind
  EyeError warped;
  // The error of the left eye's picture when it is shown in place of the right eye's.
  EyeError left;
  Image<Rgba8> drawn, picture, left_picture;  // the right eye drawn and warped, and the left one
  // Processor time of all threads: lower quartiles of the times of several runs, which take turns.
  double one_eye_ms = 0, both_drawn_ms = 0, both_warped_ms = 0;
};

// The pair and the settings must have been checked before.
SecondEyeError second_eye_error(Renderer& renderer, const View& centre, const StereoPair& pair,
                                const RenderSettings& settings,
                                const SecondEyeSettings& warp_settings);

}  // namespace glassbox::views
