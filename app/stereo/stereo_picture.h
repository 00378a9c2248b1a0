// render --stereo: draws both eyes into one picture.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/options/cli_fwd.h"
#include "cli/options/picture_options.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/images/stereo/anaglyph.h>
#include <glassbox/images/stereo/cables.h>
#include <glassbox/images/stereo/layouts.h>
#include <glassbox/images/stereo/recolour.h>
#include <glassbox/pipeline/stereo/align_and_crop.h>
#include <glassbox/render/renderer.h>

#include "views/layers/second_eye.h"

namespace glassbox::app {

struct AnaglyphOptions {
  std::optional<AnaglyphMethod> method;  // absent: kMask
  std::optional<Glasses> glasses;        // absent: kRedCyan
};

// Adds --anaglyph and --glasses.
void add_anaglyph_options(CLI::App& command, AnaglyphOptions& anaglyph);

struct StereoForm {
  bool wanted = false;                 // --stereo was given
  std::optional<StereoLayout> layout;  // absent: an anaglyph
};

// kSkew: skewed frusta. kCrop: wider, symmetric frusta, whose pictures are aligned and cropped
// (S0-08).
enum class EyeFrusta { kSkew, kCrop };

struct StereoPictureOptions {
  StereoForm form;
  AnaglyphOptions anaglyph;
  Recolour recolour;  // applied to each eye's picture before they are combined
  // The video cable whose effect on an anaglyph is simulated; absent: none.
  std::optional<Cable> cable;
  StereoCulling culling = StereoCulling::kUnion;
  EyeFrusta eyes_by = EyeFrusta::kSkew;
  std::optional<views::SecondEyeSettings> second_eye;  // absent: drawn like the first eye
  std::vector<const CLI::Option*> options;  // the options that add_stereo_picture_options has added
};

void add_stereo_picture_options(CLI::App& command, StereoPictureOptions& stereo);

// Refuses options that contradict each other or the picture's options, and sizes that cannot be
// laid out.
Result<void> check_stereo_picture(const PictureOptions& picture,
                                  const StereoPictureOptions& stereo);

// A right eye's picture that was warped instead of drawn.
struct WarpedRightEye {
  int layers = 1;                     // number of layers that were asked for
  std::size_t pixels = 0, holes = 0;  // all pixels; how many of them no layer reached
  double left_ms = 0, layers_ms = 0, warp_ms = 0;
};

struct StereoPicture {
  Image<Rgba8> image;
  StereoRendering rendering;             // its colours may have been moved into the image
  std::optional<AlignAndCrop> cropped;   // how the eyes were cropped, if they were
  std::optional<WarpedRightEye> warped;  // how the right eye was warped, if it was
};

// Draws the picture. The options must have been checked. `second` draws right eyes that are warped;
// reusing one for a sequence keeps its threads and memory.
Result<StereoPicture> render_stereo_picture(Renderer& renderer, const Scene& scene,
                                            const ChosenEyes& chosen,
                                            const RenderSettings& settings,
                                            const StereoPictureOptions& stereo,
                                            views::SecondEye& second);

// As text: the parallax at the near plane, window and far plane, in pixels and per cent of the
// width, and how many triangles were culled although an eye can see them.
std::string eyes_text(const ChosenEyes& chosen, const StereoRendering& rendering);
nlohmann::ordered_json eyes_json(const ChosenEyes& chosen, const StereoRendering& rendering);

// How much the eyes' pictures differ from pictures with skewed frusta; empty if they were not
// cropped.
std::string cropped_text(const StereoPicture& picture);

// From how many layers the right eye's picture was warped, and how long that took; empty if it was
// drawn.
std::string warped_text(const StereoPicture& picture);
nlohmann::ordered_json warped_json(const WarpedRightEye& warped);

}  // namespace glassbox::app
