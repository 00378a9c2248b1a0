// Layered depth images made from samples, in whatever order they come (S1-02).
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/engine/settings.h>

#include "views/layers/depth_peeling.h"
#include "views/layers/layered_image.h"

namespace glassbox::views {

// What samples may have besides a depth and a colour, and whether they are to have it.
struct SampleSource {
  SampleNormal normal;
  std::uint32_t triangle = 0;
};
struct SampleWishes {
  bool normals = false, triangles = false;
};

// A list for each pixel, which is packed at the end.
class LayerBuilder {
public:
  // Samples of a pixel whose depths differ by at most epsilon of the nearer one's are one sample: the one of the lowest rank, and of
  // those the nearest. Which ones are one is decided from the front: the first that is left takes in all that are near to it, and
  // none of what is near only to those (C-84).
  LayerBuilder(const LayerCamera& camera, double epsilon, const SampleWishes& wishes = {});

  // The pixel must be in the picture. A depth that is not positive and finite is left out.
  // `rank`: 0 of what the camera itself sees.
  void add(int x, int y, float depth, Rgba8 color, std::uint32_t rank = 0,
           const SampleSource& source = {});

  // Colours and distances along the gaze (infinite: nothing there) of a picture from any view, each where it is in this camera. How
  // many lie beside the picture or not before the camera.
  std::size_t add_picture(const View& from, const Image<Rgba8>& color, const Image<float>& distance,
                          std::uint32_t rank = 0);
  // The same of a layer; `normals` by its triangles' numbers, if there are any.
  std::size_t add_layer(const View& from, const Layer& layer, std::span<const SampleNormal> normals,
                        std::uint32_t rank = 0);

  // Does not depend on the order of what was added.
  LayeredImage pack() const;

private:
  struct Sample {
    float depth;
    Rgba8 color;
    std::uint32_t rank;
    std::uint32_t next;  // of the pixel; kNone: it is the last
    SampleSource source;
  };
  // `source_of(x, y)` is a SampleSource.
  template <class SourceOf>
  std::size_t add_pixels(const View& from, const Image<Rgba8>& color, const Image<float>& distance,
                         std::uint32_t rank, const SourceOf& source_of);
  static bool is_behind(const Sample& a, const Sample& b);

  LayerCamera camera_;
  double epsilon_;
  SampleWishes wishes_;
  std::vector<std::uint32_t> last_added_;  // by place in the packed order; kNone: nothing yet
  std::deque<Sample> samples_;             // which are many, and not to be there twice
};

// Of each pixel the nearest sample and the farthest, which parallax uncovers first and most.
LayeredImage ends_of(const LayeredImage& image);

// Two pictures that are one surface's differ in depth by rounding, and by the slope of the surface over a pixel; 1/1024 takes in both on
// all but grazing surfaces.
inline constexpr double kMergedDepths = 0x1p-10;

// By depth peeling of one view: `layers` at most, of the settings' shading.
LayeredImage build_layers(const Scene& scene, const View& view, const RenderSettings& settings,
                          int layers);

}  // namespace glassbox::views
