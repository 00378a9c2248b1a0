// One run of a scene as one HTML page that needs nothing else: no network, no other file.
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

namespace glassbox::app {

struct InspectOptions {
  std::string scene_name;          // as the user gave it
  std::vector<std::string> words;  // the picture options that the user gave
  std::string program;             // "glassbox 0.1.0"
  std::string command;             // the command line that made the page
  std::optional<PixelAt> pixel;    // chosen on opening, with all records of its fragments
  // Only what reaches into it, with all records of its fragments.
  std::optional<PixelRect> rectangle;
  // Of 32 bits: CLI11 wraps a negative number of 64.
  std::uint32_t max_triangles = 1'000'000;
  std::uint32_t max_fragments = 4'000'000;

  // A run in which somebody takes part (glassbox lab render).
  Observer* stages = nullptr;
  std::string student;  // JSON of drawing_page.h: their records; empty: nobody's
  const Image<Rgba8>* reference = nullptr;  // the picture as it would be without them
  // Where they make another picture than the run's: theirs, of which `reference` is then the counterpart, and what is really there.
  const Image<Rgba8>* made = nullptr;
  const Image<Rgba8>* truth = nullptr;
};

struct PageFacts {
  std::string html;
  std::uint64_t triangles = 0;
  std::uint64_t fragments = 0;
};

// An error if there is more to show than the limits allow.
Result<PageFacts> make_inspect_page(const Scene& scene, const Camera& camera, const View& view,
                                    const RenderSettings& settings, const InspectOptions& options);

}  // namespace glassbox::app
