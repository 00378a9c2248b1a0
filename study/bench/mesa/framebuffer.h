// Where the OpenGL peer draws: 8-bit colours and 32-bit depths. Row 0 is the picture's first, so that everything is drawn upside
// down: OpenGL's edge rule and its samples are then those of a picture whose rows run downwards.
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

  // What is drawn goes to the samples of pixels, or to their centres: with one sample, and to see what is covered.
  void draw_to_samples() const;
  void draw_to_centres() const;
  // The means of the samples, as the picture. Nothing with one sample.
  void resolve() const;

  Image<Rgba8> colors() const;
  // Where something was drawn to centres.
  Image<std::uint8_t> covered() const;

private:
  GlFramebuffer(const gl::Functions& gl, const Form& form) : gl_(&gl), form_(form) {}
  gl::Uint make_planes(int samples) const;

  const gl::Functions* gl_;
  Form form_;
  gl::Uint centres_ = 0, samples_ = 0;  // the same with one sample
};

}  // namespace glassbox::study
