#include <glassbox/render/stereo/pair_driver.h>

#include <glassbox/raster/blend.h>

namespace glassbox {

namespace {

// Pictures of a plane of the buffer are coloured after the run, all channels at once.
bool painted_by_fragments(Show what) {
  return what == Show::kColor || what == Show::kNormal || what == Show::kUv;
}

// Zero separation: the eyes stand in one place, and one pass serves both.
void draw_once(PairDriver& driver, const RenderSettings& settings, StereoRendering& into) {
  into.passes = 1;
  into.right = {};
  into.right_statistics = {};
  into.culled = into.lost = 0;
  driver.draw_centre(settings, into);
}

// Puts the channels of the right eye's mask into the left eye's picture.
void merge_channels(const ColorMask& mask, StereoRendering& both) {
  for (std::size_t i = 0; i < both.left.color.pixels.size(); ++i) {
    write_masked(mask, both.right.color.pixels[i], both.left.color.pixels[i]);
  }
  both.right.color = {};
}

RenderSettings with_mask(RenderSettings settings, const ColorMask& mask) {
  settings.mask = mask;
  return settings;
}

}  // namespace

void draw_pair(PairDriver& driver, const StereoPair& pair, const RenderSettings& settings,
               StereoRendering& into) {
  if (pair.half_separation == 0) {
    draw_once(driver, settings, into);
    into.right = into.left;
    return;
  }
  into.passes = 2;
  driver.draw_eyes(settings, settings, false, into);
}

void draw_masked_anaglyph(PairDriver& driver, const StereoPair& pair,
                          const RenderSettings& settings, const AnaglyphMasks& masks,
                          StereoRendering& into) {
  if (pair.half_separation == 0) {
    draw_once(driver, with_mask(settings, {}), into);
  } else if (painted_by_fragments(settings.show)) {
    into.passes = 2;
    driver.draw_eyes(with_mask(settings, masks.left), with_mask(settings, masks.right), true, into);
  } else {
    draw_pair(driver, pair, settings, into);
    merge_channels(masks.right, into);
  }
}

}  // namespace glassbox
