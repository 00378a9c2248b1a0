// Builds layered depth images from samples in any order (S1-02).
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

// What a sample may have besides a depth and a colour (SampleAttributes), and which of it is wanted
// (WantedAttributes).
struct SampleAttributes {
  SampleNormal normal;
  std::uint32_t triangle = 0;
};
struct WantedAttributes {
  bool normals = false, triangles = false;
};

// Keeps a list of samples for each pixel, and packs the lists at the end.
class LayerBuilder {
public:
  // Samples of a pixel whose depths differ by at most epsilon times the depth of the nearest one
  // are merged. The merged sample with the lowest rank stays; if several have that rank, the
  // nearest. Groups are made from the front: the nearest remaining sample is merged with all that
  // are within epsilon of it, but not with samples that are only near another sample of the group
  // (C-84).
  LayerBuilder(const LayerCamera& camera, double epsilon, const WantedAttributes& wanted = {});

  // The pixel must be inside the picture. A sample whose depth is not positive and finite is left
  // out. `rank` is 0 for samples that the camera itself sees; of merged samples the one with the
  // lowest rank stays.
  void add(int x, int y, float depth, Rgba8 color, std::uint32_t rank = 0,
           const SampleAttributes& source = {});

  // Adds the pixels of a picture from any view, each where it is seen by this camera. `distance` is
  // along the direction of view (infinite: no surface). Returns how many samples are outside of the
  // picture or not in front of the camera.
  std::size_t add_picture(const View& from, const Image<Rgba8>& color, const Image<float>& distance,
                          std::uint32_t rank = 0);
  // Adds the pixels of a layer as add_picture() does. `normals` is indexed by triangle number; it
  // may be empty.
  std::size_t add_layer(const View& from, const Layer& layer, std::span<const SampleNormal> normals,
                        std::uint32_t rank = 0);

  // The result does not depend on the order in which samples were added.
  LayeredImage pack() const;

private:
  struct Sample {
    float depth;
    Rgba8 color;
    std::uint32_t rank;
    std::uint32_t next;  // the pixel's next sample; kNone: it is the last
    SampleAttributes source;
  };
  // `source_of(x, y)` returns a SampleAttributes.
  template <class SourceOf>
  std::size_t add_pixels(const View& from, const Image<Rgba8>& color, const Image<float>& distance,
                         std::uint32_t rank, const SourceOf& source_of);
  static bool is_behind(const Sample& a, const Sample& b);

  LayerCamera camera_;
  double epsilon_;
  WantedAttributes wanted_;
  // For each pixel in the packed order, the sample added last; kNone: no sample yet.
  std::vector<std::uint32_t> last_added_;
  // A deque, because a vector of so many samples would be copied when it grows.
  std::deque<Sample> samples_;
};

// Keeps the nearest and the farthest sample of each pixel: parallax uncovers these first and most.
LayeredImage nearest_and_farthest(const LayeredImage& image);

// A value for epsilon when pictures are merged: two pictures of one surface differ in depth by
// rounding, and by the slope of the surface over a pixel; 1/1024 covers both except on grazing
// surfaces.
inline constexpr double kMergedDepths = 0x1p-10;

// Builds layers by depth peeling from one view: at most `layers` of them, with the settings'
// shading.
LayeredImage build_layers(const Scene& scene, const View& view, const RenderSettings& settings,
                          int layers);

}  // namespace glassbox::views
