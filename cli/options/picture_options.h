// The options that determine a picture: its size, the camera, and how it is drawn. Every subcommand
// that makes a picture takes them, and a picture's recipe consists of them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/options/arguments.h"
#include "cli/options/camera_options.h"
#include "cli/options/cli_fwd.h"
#include "cli/options/eyes_options.h"
#include "cli/options/matrix_options.h"

#include <glassbox/base/error.h>
#include <glassbox/matrices/view_of_matrices.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/mesh/texture_filter.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox {

class Progress;

struct PictureOptions {
  Size size;
  CameraOptions camera;
  MatrixOptions matrices;  // in place of the camera, if there are any
  EyesOptions eyes;
  RenderSettings settings;
  std::optional<TextureFilter> filter;      // for all textures; absent: each texture's own
  std::vector<const CLI::Option*> options;  // the options that add_picture_options has added
};

void add_picture_options(CLI::App& command, PictureOptions& picture);

// The scene with the texture filter of the options.
Scene with_texture_filter(Scene scene, const PictureOptions& picture);

// Loads the scene as it is drawn: with the texture filter and the model matrix of the options. Says
// in notes what was chosen for the user's own matrices.
Result<Scene> load_scene_argument(const std::string& word, const PictureOptions& picture,
                                  Progress& progress, const LoadLimits& limits = {});

// For commands that examine pixel centres only: prints a note if the picture has several samples
// per pixel.
void print_pixel_centres_note(const PictureOptions& picture);

// The options that the user gave, among `options`, as words: "--size", "640x480".
std::vector<std::string> option_words(std::span<const CLI::Option* const> options);

// The words that draw this picture again in the same directory: the options as the user gave them.
// (Matrices from standard input, which cannot be read twice, are written as numbers.)
std::vector<std::string> given_option_words(const PictureOptions& picture);

// The words that draw this picture again anywhere: matrices are written as numbers.
std::vector<std::string> portable_option_words(const PictureOptions& picture);

// The view of the scene that the options give, and the camera that it is computed from. With
// --seen-by it is that eye's view.
struct ChosenView {
  Camera camera;
  View view;
  std::optional<MatrixView> of_matrices;  // if the user gave --proj
};
Result<ChosenView> choose_view(const Scene& scene, const PictureOptions& picture);

// Like choose_view(), but with other settings, and for a picture `factor` times as wide and high.
Result<View> choose_view(const Scene& scene, const PictureOptions& picture,
                         const RenderSettings& settings, int factor);

// The camera between the eyes, and the two eyes.
struct ChosenEyes {
  Camera camera;
  View centre;
  ChosenPair eyes;
};
Result<ChosenEyes> choose_eyes(const Scene& scene, const PictureOptions& picture);

}  // namespace glassbox
