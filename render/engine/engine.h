// The interface of engines, which draw pictures. The staged reference and the tile engine draw the
// same bytes; more engines can be added.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/framebuffer.h>
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/engine/prepared_scene.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/engine/statistics.h>

namespace glassbox {

// The view of one eye, and where its picture is written.
struct EyePicture {
  const View& view;
  const RenderSettings& settings;
  Framebuffer& target;  // its images keep their memory if they already have the right size
  // Where the colours are written: target.color, or an existing picture of the view's size, over
  // which this one is drawn. (An existing picture is not possible with Show::kDepth, kId and
  // kOverdraw, which are coloured at the end from another image of the framebuffer.)
  Image<Rgba8>& color;
  Statistics& statistics;
  Observers observers = {};  // called at every stage by engines that support them
  // A depth code for each pixel: only fragments behind it are drawn, and none where it is
  // kEmptyDepth. Null: all fragments are drawn. (Allowed only with one sample per pixel and without
  // blending.)
  const Image<std::uint32_t>* behind_depth = nullptr;

  bool draws_over() const { return &color != &target.color; }
};

inline std::vector<const View*> views_of(std::span<const EyePicture> eyes) {
  std::vector<const View*> views;
  for (const EyePicture& eye : eyes) views.push_back(&eye.view);
  return views;
}

// Which triangles of a stereo pair are drawn. The other triangles are culled for both eyes, before
// the stages that run for each eye (S0-04).
//   kUnion   triangles that the frustum of either eye may show: nothing is lost
//   kCentre  triangles that the frustum of the camera between the eyes may show: what only a
//            skewed frustum sees is lost (E20)
enum class StereoCulling { kUnion, kCentre };

// How the triangles of a pair are culled. The two eyes are on either side of the camera `centre`.
struct PairCulling {
  StereoCulling how = StereoCulling::kUnion;
  const View& centre;
};

// A picture to draw, or the two pictures of a stereo pair.
struct PictureJob {
  const Scene& scene;
  const PreparedScene& prepared;  // made from the scene with the transfer function of the settings
  // One eye, or the two eyes of a stereo pair. The views of a pair differ only in the x row of
  // clip_from_eye, their settings only in the colour mask. Work that is done once for both eyes is
  // counted and timed in the first eye's statistics.
  std::span<const EyePicture> eyes;
  // The culling of a pair; null: none. An engine may ignore kUnion, which changes no picture.
  const PairCulling* culling = nullptr;
};

// How many triangles were culled for both eyes of a pair, and how many of these the frustum of an
// eye may show (`lost`).
struct PairCullCounts {
  std::uint64_t culled = 0, lost = 0;
};

class Engine {
public:
  virtual ~Engine() = default;

  // Draws the picture of every eye of the job, with all images of its framebuffer.
  virtual PairCullCounts draw(const PictureJob& job) = 0;

  // Whether the engine can cull as StereoCulling::kCentre does. If it cannot, the staged reference
  // draws such pictures.
  virtual bool culls_as_centre() const { return false; }
};

}  // namespace glassbox
