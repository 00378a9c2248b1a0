#include <glassbox/render/tile/tile_pair.h>

#include <array>

#include <glassbox/render/stereo/pair_driver.h>

namespace glassbox {

namespace {

class TilePair : public PairDriver {
public:
  TilePair(TileEngine& engine, const Scene& scene, const PreparedScene& prepared,
           const View& centre, const StereoPair& pair)
      : engine_(engine),
        scene_(scene),
        prepared_(prepared),
        centre_(centre),
        left_view_(eye_view(centre, pair, Side::kLeft)),
        right_view_(eye_view(centre, pair, Side::kRight)) {}

  void draw_centre(const RenderSettings& settings, StereoRendering& into) override {
    const EyePicture eye{centre_, settings, into.left, into.left.color, into.left_statistics};
    engine_.render(scene_, prepared_, {&eye, 1});
  }

  void draw_eyes(const RenderSettings& left_settings, const RenderSettings& right_settings,
                 bool one_color_buffer, StereoRendering& into) override {
    into.culled = into.lost = 0;
    const std::array<EyePicture, 2> eyes{
        {{left_view_, left_settings, into.left, into.left.color, into.left_statistics},
         {right_view_, right_settings, into.right,
          one_color_buffer ? into.left.color : into.right.color, into.right_statistics}}};
    engine_.render(scene_, prepared_, eyes);
  }

private:
  TileEngine& engine_;
  const Scene& scene_;
  const PreparedScene& prepared_;
  const View& centre_;
  const View left_view_, right_view_;
};

}  // namespace

void render_pair(TileEngine& engine, const Scene& scene, const PreparedScene& prepared,
                 const View& centre, const StereoPair& pair, const StereoSettings& settings,
                 StereoRendering& into) {
  if (settings.culling == StereoCulling::kCentre) {
    into = render_pair(scene, centre, pair, settings);
    return;
  }
  TilePair tiles(engine, scene, prepared, centre, pair);
  draw_pair(tiles, pair, settings.render, into);
}

void render_masked_anaglyph(TileEngine& engine, const Scene& scene, const PreparedScene& prepared,
                            const View& centre, const StereoPair& pair,
                            const StereoSettings& settings, const AnaglyphMasks& masks,
                            StereoRendering& into) {
  if (settings.culling == StereoCulling::kCentre) {
    into = render_masked_anaglyph(scene, centre, pair, settings, masks);
    return;
  }
  TilePair tiles(engine, scene, prepared, centre, pair);
  draw_masked_anaglyph(tiles, pair, settings.render, masks, into);
}

}  // namespace glassbox
