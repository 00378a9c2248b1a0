// The framebuffer of the OpenGL peer: 8-bit colours and 32-bit depths. Row 0 is the top row of the
// picture, so everything is drawn upside down: OpenGL's edge rule and its sample positions then
// match a picture whose rows run downwards.
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/raster/transfer.h>

#include "study/bench/mesa/gl.h"
#include "study/scenes/picture_match.h"

namespace glassbox::study {

class GlFramebuffer {
public:
  struct Form {
    int width = 0, height = 0;
    int samples = 1;
    Transfer transfer = Transfer::kNone;
  };

  static Result<GlFramebuffer> make(const gl::Functions& gl, const Form& form);

  // Selects where the next draws go: to the samples of the pixels, or to the pixel centres. Centres
  // are used with one sample per pixel, and to find the covered pixels.
  void draw_to_samples() const;
  void draw_to_centres() const;
  // Averages the samples of each pixel into the picture. Does nothing with one sample.
  void resolve() const;

  Image<Rgba8> colors() const;
  // Is 1 where something was drawn at a pixel's centre.
  Image<std::uint8_t> covered() const;

private:
  GlFramebuffer(const gl::Functions& gl, const Form& form) : gl_(&gl), form_(form) {}
  gl::Uint make_planes(int samples) const;

  const gl::Functions* gl_;
  Form form_;
  gl::Uint centres_ = 0, samples_ = 0;  // equal if each pixel has one sample
};

}  // namespace glassbox::study
