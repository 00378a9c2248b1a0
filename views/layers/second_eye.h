// The right eye's picture from what the left eye sees, instead of drawing it (S0-06, S1-09).
#pragma once

#include <memory>

#include <glassbox/images/image.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/raster/lanes/target.h>
#include <glassbox/render/renderer.h>

namespace glassbox::views {

struct SecondEyeSettings {
  int layers = 1;   // of the left eye; each takes another pass of the engine
  int threads = 1;  // of the warp, which depends on neither
  Target target = best_target();
  DepthFormat format = DepthFormat::kFloat32;  // of the layers' depths
};

struct LayerView {
  const Image<Rgba8>& color;
  const Image<std::uint32_t>& depth;  // codes
};

// Keeps its threads and memory from one picture to the next.
class SecondEye {
public:
  SecondEye();
  ~SecondEye();
  SecondEye(const SecondEye&) = delete;
  SecondEye& operator=(const SecondEye&) = delete;

  // Eyes that look the same way differ in the rows of their pictures alone: a pixel moves along its row, by the parallax of its
  // distance, which is linear in its depth. What lies between two pixels of one surface is a mixture of them; the nearest stays; and holes
  // are filled with what is beside them, of both sides the farther: from behind. Empty pixels of the first layer are background and
  // infinitely far. How many pixels those holes are.
  std::size_t warp(const LayerView& layer, const View& centre, const StereoPair& pair,
                   const SecondEyeSettings& settings, Image<Rgba8>& into);

  // The same of several layers, one after the other: the first, any others, and the picture.
  void begin(const LayerView& first, const View& centre, const StereoPair& pair,
             const SecondEyeSettings& settings);
  void add(const LayerView& layer);
  std::size_t finish(Image<Rgba8>& into);
  // Before another one: which surfaces the picture would show that none of the layers has. `last`: the depth codes of the last of them. Of
  // each pixel the code behind which the next layer's surface has to be, as EyePicture::behind has it (seen_behind.h); layers after the first go on
  // to the right by as many columns as are missing there. Whether any pixel has one.
  bool find_behind(const Image<std::uint32_t>& last, Image<std::uint32_t>& behind);

private:
  struct State;
  std::unique_ptr<State> state_;
};

// What the warp needs to be right: a picture of colours, whose surfaces hide what is behind them; with more than one layer, of one sample
// too. The error says what is in its way.
Result<void> check_second_eye(const Scene& scene, const RenderSettings& settings, int layers);

// The pair as Renderer::render_pair has it, its right picture warped: colours alone, and, if the settings want them, distances that are the
// left one's. The right picture's memory is used again.
struct PairByWarp {
  StereoRendering rendering;
  std::size_t holes = 0;
  // The left eye, the layer behind it, and what that had to be behind of: memory for the next picture.
  Rendering drawn, layer;
  Image<std::uint32_t> behind;
  double left_ms = 0, layers_ms = 0, warp_ms = 0;
};
void render_pair_by_warp(Renderer& renderer, const View& centre, const StereoPair& pair,
                         const RenderSettings& settings, const SecondEyeSettings& by,
                         SecondEye& second, PairByWarp& into);

}  // namespace glassbox::views
