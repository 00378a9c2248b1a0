#include "cli/options/picture_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/choices.h"
#include "cli/options/scene_input.h"

#include <glassbox/render/engine/setting_names.h>

namespace glassbox {

namespace {

void add_drawing_options(CLI::App& command, PictureOptions& picture) {
  RenderSettings& settings = picture.settings;
  const std::string group = "Picture";
  add_choice(command, "--shade", settings.shading,
             choices_of({Shading::kUnlit, Shading::kFlat, Shading::kGouraud, Shading::kPhong}),
             "where lighting is computed [phong]")
      ->group(group);
  add_choice(command, "--show", settings.show,
             choices_of({Show::kDepth, Show::kNormal, Show::kUv, Show::kId, Show::kOverdraw}),
             "show this quantity instead of colours")
      ->group(group);
  add_choice(command, "--cull", settings.cull, choices_of({Cull::kBack, Cull::kFront, Cull::kNone}),
             "faces to cull [as each material says]")
      ->group(group);
  add_choice(command, "--cull-stage", settings.cull_stage,
             {{"screen", CullStage::kScreen}, {"object", CullStage::kObject}},
             "where faces are culled: by their area on the screen, or in object space before "
             "clipping where that is certain; both give the same bytes [screen]")
      ->group(group);
  command.add_flag("--wireframe", settings.wireframe, "draw only the edges of triangles")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--background",
          [&settings](const std::string& text) { settings.background = parse_background(text); },
          "background colour as displayed, each channel 0 .. 1 [0.1,0.12,0.15]")
      ->type_name("R,G,B")
      ->group(group);
  add_choice(command, "--transfer", settings.transfer,
             choices_of({Transfer::kSrgb, Transfer::kNone}), "encoding of stored colours [srgb]")
      ->group(group);
  add_choice<int>(command, "--samples", settings.samples,
                  {{"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}, {"16", 16}},
                  "samples per pixel, whose mean is the pixel's colour [1]")
      ->group(group);
  add_choice<std::optional<TextureFilter>>(
      command, "--filter", picture.filter,
      choices_of({TextureFilter::kNearest, TextureFilter::kBilinear, TextureFilter::kBilinearLevels,
                  TextureFilter::kTrilinear}),
      "how textures are filtered [as each texture's sampler says]")
      ->group(group);
  add_choice(command, "--depth", settings.depth,
             choices_of({DepthFormat::kFloat32, DepthFormat::kFloat32Reversed,
                         DepthFormat::kUnorm24, DepthFormat::kUnorm16}),
             "depth buffer format; d32r is reversed [d32]")
      ->group(group);
}

Result<ChosenView> choose_centre(const Scene& scene, const PictureOptions& picture) {
  const auto [width, height] = picture.size;
  const Result<Camera> camera =
      choose_camera(scene, picture.camera, double(width) / double(height));
  if (!camera) return tl::unexpected(camera.error());
  const DepthRange range = picture.settings.depth == DepthFormat::kFloat32Reversed
                               ? DepthRange::kReversed
                               : DepthRange::kStandard;
  const Result<View> view = make_view(*camera, width, height, range, picture.camera.formulation);
  if (!view) {
    Error error = view.error();
    // name the option that the user gave
    if (error.place == "projection form") error.place = "--projection";
    return tl::unexpected(error);
  }
  return ChosenView{*camera, *view};
}

}  // namespace

void add_picture_options(CLI::App& command, PictureOptions& picture) {
  const std::size_t before = command.get_options().size();
  command
      .add_option_function<std::string>(
          "--size", [&picture](const std::string& text) { picture.size = parse_size(text); },
          "image size in pixels [1280x720]")
      ->type_name("WxH");
  add_camera_options(command, picture.camera);
  add_eyes_options(command, picture.eyes);
  add_drawing_options(command, picture);
  const auto all = command.get_options();
  picture.options.assign(all.begin() + std::ptrdiff_t(before), all.end());
}

Scene with_texture_filter(Scene scene, const PictureOptions& picture) {
  return picture.filter ? with_filter(std::move(scene), *picture.filter) : scene;
}

Result<Scene> load_scene_argument(const std::string& word, const PictureOptions& picture,
                                  Progress& progress, const LoadLimits& limits) {
  return load_scene_argument(word, progress, limits).map([&](Scene scene) {
    return with_texture_filter(std::move(scene), picture);
  });
}

void print_pixel_centres_note(const PictureOptions& picture) {
  if (picture.settings.samples == 1) return;
  fmt::print(stderr,
             "glassbox: note: --samples {} is ignored: this command looks at pixel centres, as "
             "with --samples 1\n",
             picture.settings.samples);
}

std::vector<std::string> option_words(std::span<const CLI::Option* const> options) {
  std::vector<std::string> words;
  for (const CLI::Option* option : options) {
    if (option->count() == 0) continue;
    words.push_back(option->get_name());
    const bool flag = option->get_expected_max() == 0;
    if (!flag) words.push_back(option->results().back());
  }
  return words;
}

std::vector<std::string> given_option_words(const PictureOptions& picture) {
  return option_words(picture.options);
}

Result<ChosenView> choose_view(const Scene& scene, const PictureOptions& picture) {
  const EyesOptions& eyes = picture.eyes;
  if (!eyes.seen_by) {
    if (!eyes.separation && !eyes.window) return choose_centre(scene, picture);
    return fail(eyes.separation ? "--eye-separation" : "--window",
                "it needs two eyes, but the picture is for one",
                "choose an eye with --seen-by left or --seen-by right");
  }
  return choose_eyes(scene, picture).map([&](const ChosenEyes& chosen) {
    return ChosenView{chosen.camera, eye_view(chosen.centre, chosen.eyes.pair, *eyes.seen_by)};
  });
}

Result<View> choose_view(const Scene& scene, const PictureOptions& picture,
                         const RenderSettings& settings, int factor) {
  PictureOptions large = picture;
  large.settings = settings;
  large.size = {picture.size.width * factor, picture.size.height * factor};
  return choose_view(scene, large).map([](const ChosenView& chosen) { return chosen.view; });
}

Result<ChosenEyes> choose_eyes(const Scene& scene, const PictureOptions& picture) {
  const Result<ChosenView> centre = choose_centre(scene, picture);
  if (!centre) return tl::unexpected(centre.error());
  std::optional<double> look_at;
  if (const auto& target = picture.camera.look_at) {
    look_at = -(centre->view.eye_from_world *
                Point<World, double>{(*target)[0], (*target)[1], (*target)[2]})
                   .z;
  }
  return choose_pair(scene, centre->view, picture.settings, picture.eyes, look_at)
      .map([&](const ChosenPair& eyes) {
        ChosenEyes chosen{centre->camera, centre->view, eyes};
        return chosen;
      });
}

}  // namespace glassbox
