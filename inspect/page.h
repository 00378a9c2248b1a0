// One run of a scene as one HTML page that needs no network and no other file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/compare/pixels/differences.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/raster/stages.h>
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox::inspect {

struct InspectOptions {
  std::string scene_name;          // as the user gave it
  std::vector<std::string> words;  // the picture options that the user gave
  std::string program;             // "glassbox 0.1.0"
  std::string command;             // the command line that made the page
  // the pixel that is selected when the page opens; all records of its fragments are included
  std::optional<PixelPosition> pixel;
  // If set, the page has only triangles and fragments that reach into this rectangle, with all
  // records of these fragments.
  std::optional<PixelRect> rectangle;
  // 32 bits, because CLI11 would accept a negative number for a 64-bit type and wrap it around.
  std::uint32_t max_triangles = 1'000'000;
  std::uint32_t max_fragments = 4'000'000;

  // A student's functions that take part in the run (glassbox lab render); null: none.
  Observer* stages = nullptr;
  // JSON of drawing_report.h on the student's functions; empty without a student
  std::string student;
  const Image<Rgba8>* reference = nullptr;  // the picture without the student's functions
  // Set if the student's functions draw a picture that is not the run's picture. `made` is the
  // picture that they draw, `reference` then is the picture it is compared with, and `truth` is the
  // scene drawn by the pipeline with the same camera.
  const Image<Rgba8>* made = nullptr;
  const Image<Rgba8>* truth = nullptr;
};

struct PageFacts {
  std::string html;
  std::uint64_t triangles = 0;
  std::uint64_t fragments = 0;
};

// Makes the page. An error if there is more to show than the limits allow.
Result<PageFacts> make_inspect_page(const Scene& scene, const Camera& camera, const View& view,
                                    const RenderSettings& settings, const InspectOptions& options);

}  // namespace glassbox::inspect
