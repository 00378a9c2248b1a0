// What the pictures of a pair are made of, whichever engine draws them: for render_pair and render_masked_anaglyph alone.
#pragma once

#include <glassbox/render/stereo/render_pair.h>

namespace glassbox {

class PairDriver {
public:
  virtual ~PairDriver() = default;

  // The picture of the camera between the eyes, into the left eye's buffers.
  virtual void draw_centre(const RenderSettings& settings, StereoRendering& into) = 0;

  // Both eyes' pictures, which differ in the settings' masks at most. With one colour buffer it is the left eye's; then the
  // fragments themselves paint what is shown.
  virtual void draw_eyes(const RenderSettings& left, const RenderSettings& right,
                         bool one_color_buffer, StereoRendering& into) = 0;
};

void draw_pair(PairDriver& driver, const StereoPair& pair, const RenderSettings& settings,
               StereoRendering& into);
void draw_masked_anaglyph(PairDriver& driver, const StereoPair& pair,
                          const RenderSettings& settings, const AnaglyphMasks& masks,
                          StereoRendering& into);

}  // namespace glassbox
