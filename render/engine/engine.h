// What draws: the staged reference and the tile engine, which make the same bytes; and whoever writes a third one.
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

// What an eye sees, and where it goes.
struct EyePicture {
  const View& view;
  const RenderSettings& settings;
  Framebuffer& target;  // memory of planes that have the right size is used again
  // target.color; or a picture of the view's size that is there already, over which this one is drawn. (Not with pictures of
  // planes of the buffer: Show::kDepth, kId, kOverdraw.)
  Image<Rgba8>& color;
  Statistics& statistics;
  Observers observers = {};  // called at every stage, by engines that have them
  // Of each pixel a depth code: what is there or nearer is not drawn, and nothing where it is kEmptyDepth. Null: all is drawn. (One sample of
  // a pixel; nothing is blended.)
  const Image<std::uint32_t>* behind = nullptr;

  bool draws_over() const { return &color != &target.color; }
};

inline std::vector<const View*> views_of(std::span<const EyePicture> eyes) {
  std::vector<const View*> views;
  for (const EyePicture& eye : eyes) views.push_back(&eye.view);
  return views;
}

// Which triangles are submitted to the eyes of a pair at all (S0-04).
//   kUnion   those that the frustum of one of the eyes may show: nothing is lost
//   kCentre  those that the frustum of the camera between the eyes may show: what only a skewed frustum sees is lost (E20)
enum class StereoCulling { kUnion, kCentre };

// Both eyes look from the sides of this camera.
struct PairCulling {
  StereoCulling how = StereoCulling::kUnion;
  const View& centre;
};

struct PictureJob {
  const Scene& scene;
  const PreparedScene& prepared;  // made from the scene with the settings' transfer
  // One eye, or the two of a stereo pair: then their views differ in the row of x of clip_from_eye alone, their settings in the
  // mask. Work done once for both is counted and timed with the first.
  std::span<const EyePicture> eyes;
  // Of a pair; an engine may leave kUnion out, which changes no picture.
  const PairCulling* culling = nullptr;
};

// Triangles that were not submitted to the eyes of a pair; and of these, those in the frustum of an eye.
struct NotSubmitted {
  std::uint64_t culled = 0, lost = 0;
};

class Engine {
public:
  virtual ~Engine() = default;

  // Every picture of the job, with all its planes.
  virtual NotSubmitted draw(const PictureJob& job) = 0;

  // Whether it leaves out what StereoCulling::kCentre leaves out. Pictures of one that does not are the reference's.
  virtual bool culls_as_centre() const { return false; }
};

}  // namespace glassbox
