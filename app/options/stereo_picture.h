// render --stereo: both eyes in one picture.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/options/cli_fwd.h"
#include "app/options/picture_options.h"

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
  std::optional<AnaglyphMethod> method;  // absent: mask
  std::optional<Glasses> glasses;        // absent: red-cyan
};

// --anaglyph and --glasses.
void add_anaglyph_options(CLI::App& command, AnaglyphOptions& anaglyph);

struct StereoForm {
  bool wanted = false;                 // --stereo was given
  std::optional<StereoLayout> layout;  // absent: an anaglyph
};

// kSkew: skewed frusta. kCrop: wider frusta that are not skewed, aligned and cropped (S0-08).
enum class EyesBy { kSkew, kCrop };

struct StereoPictureOptions {
  StereoForm form;
  AnaglyphOptions anaglyph;
  Recolour recolour;  // of each eye's picture, before they are put together
  // What an anaglyph goes through on its way to the screen; absent: nothing.
  std::optional<Cable> cable;
  StereoCulling culling = StereoCulling::kUnion;
  EyesBy eyes_by = EyesBy::kSkew;
  std::optional<views::SecondEyeSettings> second_eye;  // absent: drawn as the first one is
  std::vector<const CLI::Option*> options;  // those that add_stereo_picture_options has added
};

void add_stereo_picture_options(CLI::App& command, StereoPictureOptions& stereo);

// Options that contradict each other or the picture's, and sizes that cannot be laid out.
Result<void> check_stereo_picture(const PictureOptions& picture,
                                  const StereoPictureOptions& stereo);

// A right eye's picture that was not drawn.
struct WarpedRightEye {
  int layers = 1;                     // that were asked for
  std::size_t pixels = 0, holes = 0;  // of its picture, and that no layer reached
  double left_ms = 0, layers_ms = 0, warp_ms = 0;
};

struct StereoPicture {
  Image<Rgba8> image;
  StereoRendering rendering;             // its colours may be spent on the image
  std::optional<AlignAndCrop> cropped;   // how, where the eyes were cropped
  std::optional<WarpedRightEye> warped;  // how, where the right eye was
};

// The options count as checked. `second` is for right eyes that are warped: one for a sequence keeps its threads and memory.
Result<StereoPicture> render_stereo_picture(Renderer& renderer, const Scene& scene,
                                            const ChosenEyes& chosen,
                                            const RenderSettings& settings,
                                            const StereoPictureOptions& stereo,
                                            views::SecondEye& second);

// The parallax of near plane, window and far plane, in pixels and per cent of the width, and what was culled.
std::string eyes_text(const ChosenEyes& chosen, const StereoRendering& rendering);
nlohmann::ordered_json eyes_json(const ChosenEyes& chosen, const StereoRendering& rendering);

// How far the eyes' pictures are from the skewed ones; empty where they were not cropped.
std::string cropped_text(const StereoPicture& picture);

// What the right eye was warped from, and how long that took; empty where it was drawn.
std::string warped_text(const StereoPicture& picture);
nlohmann::ordered_json warped_json(const WarpedRightEye& warped);

}  // namespace glassbox::app
