// Computes the right eye's picture by warping what the left eye sees, instead of drawing it (S0-06,
// S1-09).
#pragma once

#include <memory>

#include <glassbox/images/image.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/raster/lanes/target.h>
#include <glassbox/render/renderer.h>

namespace glassbox::views {

struct SecondEyeSettings {
  int layers = 1;   // layers of the left eye; each takes one more pass of the engine
  int threads = 1;  // for the warp; the result depends neither on their number nor on the target
  Target target = best_target();
  DepthFormat format = DepthFormat::kFloat32;  // the format of the layers' depths
};

struct LayerView {
  const Image<Rgba8>& color;
  const Image<std::uint32_t>& depth;  // as codes of a DepthFormat
};

// Warps pictures to the other eye. It keeps its threads and memory from one picture to the next.
class SecondEye {
public:
  SecondEye();
  ~SecondEye();
  SecondEye(const SecondEye&) = delete;
  SecondEye& operator=(const SecondEye&) = delete;

  // Warps one layer. The eyes look in the same direction, so their pictures differ only along rows:
  // a pixel moves along its row by the parallax of its distance, which is linear in its depth. A
  // pixel between two pixels of one surface is a mixture of them, and the nearest surface stays.
  // Holes are filled with the farther one of the two pixels at their sides, because it is the
  // background that comes into view. Empty pixels of the first layer are background at infinite
  // distance. Returns the number of pixels in holes.
  std::size_t warp(const LayerView& layer, const View& centre, const StereoPair& pair,
                   const SecondEyeSettings& settings, Image<Rgba8>& into);

  // The same for several layers, one after the other: begin() with the first layer, add() for each
  // further layer, then finish() for the picture and the number of pixels in holes.
  void begin(const LayerView& first, const View& centre, const StereoPair& pair,
             const SecondEyeSettings& settings);
  void add(const LayerView& layer);
  std::size_t finish(Image<Rgba8>& into);
  // To be called before the next layer is drawn and added: finds where the picture would show a
  // surface that no layer has yet. `last` has the depth codes of the last layer. For each pixel,
  // `behind` gets the code behind which the next layer's surface has to be, as for
  // EyePicture::behind_depth (engine.h). Layers after the first have more columns at the right, as
  // many as are missing there. Returns whether any pixel has such a code.
  bool find_disoccluded_depths(const Image<std::uint32_t>& last, Image<std::uint32_t>& behind);

private:
  struct State;
  std::unique_ptr<State> state_;
};

// Checks the conditions of the warp: a picture of colours, and for more than one layer neither
// transparent surfaces nor several samples per pixel. The error names the condition that is not
// met.
Result<void> check_second_eye(const Scene& scene, const RenderSettings& settings, int layers);

// A pair like that of Renderer::render_pair, with a right picture that is warped: colours only,
// and, if the settings ask for distances, the left picture's. The memory of the right picture is
// reused.
struct WarpedPair {
  StereoRendering rendering;
  std::size_t holes = 0;
  // The left eye's picture, the layer behind it, and the depths that the layer had to be behind:
  // memory for the next picture.
  Rendering drawn, layer;
  Image<std::uint32_t> behind;
  double left_ms = 0, layers_ms = 0, warp_ms = 0;
};
void render_pair_by_warp(Renderer& renderer, const View& centre, const StereoPair& pair,
                         const RenderSettings& settings, const SecondEyeSettings& warp_settings,
                         SecondEye& second, WarpedPair& into);

}  // namespace glassbox::views
