// A right eye that is warped, beside the one that is drawn: how far off it is, and what it costs.
#pragma once

#include "views/layers/second_eye.h"

namespace glassbox::views {

inline constexpr int kVisibleDifference = 8;  // of a channel, in steps of a byte

// How far a picture is from the one that was to be.
struct EyeError {
  double rms = 0;         // of red, green and blue, in steps of a byte
  int largest = 0;        // of a channel, in steps of a byte
  std::size_t wrong = 0;  // pixels with a channel off by more than kVisibleDifference
};
EyeError eye_error(const Image<Rgba8>& picture, const Image<Rgba8>& truth);

struct SecondEyeError {
  int layers = 1;
  std::size_t pixels = 0;
  std::size_t holes = 0;  // filled from behind
  EyeError warped;
  EyeError left;                              // the left eye's picture in its place
  Image<Rgba8> drawn, picture, left_picture;  // the right eye drawn and warped, and the left one
  // Processor time of all threads: the lower quartiles of runs in turns.
  double one_eye_ms = 0, both_drawn_ms = 0, both_warped_ms = 0;
};

// The pair and the settings count as checked.
SecondEyeError second_eye_error(Renderer& renderer, const View& centre, const StereoPair& pair,
                                const RenderSettings& settings, const SecondEyeSettings& by);

}  // namespace glassbox::views
