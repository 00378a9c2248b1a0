// Each eye of an anaglyph shades only the channels that it writes.
#include <glassbox/render/stereo/render_pair.h>

#include "tests/render/stereo/pairs.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

// The largest value of each channel over all fragments when they were stored.
class StoredChannels : public Observer {
public:
  void encoded(const Fragment& /*fragment*/, const Rgba8& /*before*/, Rgba8& after) override {
    largest.r = std::max(largest.r, after.r);
    largest.g = std::max(largest.g, after.g);
    largest.b = std::max(largest.b, after.b);
  }
  Rgba8 largest{0, 0, 0, 0};
};

}  // namespace

TEST_CASE("the left eye shades red alone, the right eye green and blue (S0-05)") {
  for (const PairCase& c : pair_cases()) {
    INFO(c.name);
    StoredChannels left, right;
    render_masked_anaglyph(c.scene, c.centre, c.pair, {}, {}, {&left, &right});
    CHECK(left.largest.r > 0);
    CHECK(left.largest.g == 0);
    CHECK(left.largest.b == 0);
    CHECK(right.largest.r == 0);
    CHECK(right.largest.g > 0);
    CHECK(right.largest.b > 0);
  }
}

TEST_CASE("blended and masked materials keep their alpha where it is not written (S0-05)") {
  for (const AlphaMode mode : {AlphaMode::kBlend, AlphaMode::kMask}) {
    PairCase c = pair_case("room", 0.03);
    for (Material& material : c.scene.materials) {
      material.alpha_mode = mode;
      material.base_color.a = 0.5f;
      material.alpha_cutoff = 0.25f;
    }
    const StereoRendering both = render_pair(c.scene, c.centre, c.pair, {});
    const StereoRendering masked = render_masked_anaglyph(c.scene, c.centre, c.pair, {}, {});
    std::size_t differing = 0;
    for (std::size_t i = 0; i < masked.left.color.pixels.size(); ++i) {
      const Rgba8 l = both.left.color.pixels[i], r = both.right.color.pixels[i];
      differing += !(masked.left.color.pixels[i] == Rgba8{l.r, r.g, r.b, r.a});
    }
    CHECK(differing == 0);
  }
}

}  // namespace glassbox
