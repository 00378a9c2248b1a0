#include "study/bench/mesa/framebuffer.h"

#include <array>

#include "study/bench/mesa/refusal.h"

namespace glassbox::study {

Result<GlFramebuffer> GlFramebuffer::make(const gl::Functions& gl, const Form& form) {
  GlFramebuffer made(gl, form);
  made.centres_ = made.make_planes(1);
  made.samples_ = form.samples == 1 ? made.centres_ : made.make_planes(form.samples);
  if (made.centres_ == 0 || made.samples_ == 0) {
    return refused("OpenGL cannot make a framebuffer of this size with this number of samples");
  }
  gl.Viewport(0, 0, form.width, form.height);
  if (form.transfer == Transfer::kSrgb) gl.Enable(gl::kFramebufferSrgb);
  return made;
}

// Returns 0 if OpenGL cannot make such a framebuffer.
gl::Uint GlFramebuffer::make_planes(int samples) const {
  std::array<gl::Uint, 2> planes{};
  gl::Uint framebuffer = 0;
  gl_->GenFramebuffers(1, &framebuffer);
  gl_->BindFramebuffer(gl::kFramebuffer, framebuffer);
  gl_->GenRenderbuffers(2, planes.data());
  const auto attach = [&](gl::Uint plane, gl::Enum format, gl::Enum where) {
    gl_->BindRenderbuffer(gl::kRenderbuffer, plane);
    if (samples == 1) {
      gl_->RenderbufferStorage(gl::kRenderbuffer, format, form_.width, form_.height);
    } else {
      gl_->RenderbufferStorageMultisample(gl::kRenderbuffer, samples, format, form_.width,
                                          form_.height);
    }
    gl_->FramebufferRenderbuffer(gl::kFramebuffer, where, gl::kRenderbuffer, plane);
  };
  const gl::Int color = form_.transfer == Transfer::kSrgb ? gl::kSrgb8Alpha8 : gl::kRgba8;
  attach(planes[0], gl::Enum(color), gl::kColorAttachment0);
  attach(planes[1], gl::kDepthComponent32F, gl::kDepthAttachment);
  const bool complete = gl_->CheckFramebufferStatus(gl::kFramebuffer) == gl::kFramebufferComplete;
  return complete ? framebuffer : 0;
}

void GlFramebuffer::draw_to_samples() const {
  gl_->BindFramebuffer(gl::kFramebuffer, samples_);
}

void GlFramebuffer::draw_to_centres() const {
  gl_->BindFramebuffer(gl::kFramebuffer, centres_);
}

void GlFramebuffer::resolve() const {
  if (samples_ == centres_) return;
  gl_->BindFramebuffer(gl::kReadFramebuffer, samples_);
  gl_->BindFramebuffer(gl::kDrawFramebuffer, centres_);
  gl_->BlitFramebuffer(0, 0, form_.width, form_.height, 0, 0, form_.width, form_.height,
                       gl::kColorBufferBit, gl::Enum(gl::kNearest));
}

Image<Rgba8> GlFramebuffer::colors() const {
  Image<Rgba8> image(form_.width, form_.height);
  draw_to_centres();
  gl_->ReadPixels(0, 0, form_.width, form_.height, gl::kRgba, gl::kUnsignedByte,
                  image.pixels.data());
  return image;
}

Image<std::uint8_t> GlFramebuffer::covered() const {
  Image<float> depth(form_.width, form_.height);
  draw_to_centres();
  gl_->ReadPixels(0, 0, form_.width, form_.height, gl::kDepthComponent, gl::kFloat,
                  depth.pixels.data());
  Image<std::uint8_t> covered(form_.width, form_.height);
  for (std::size_t i = 0; i < depth.pixels.size(); ++i) {
    covered.pixels[i] = depth.pixels[i] < 1.0f ? 1 : 0;
  }
  return covered;
}

}  // namespace glassbox::study
