#include "cli/options/picture_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/choices.h"
#include "cli/options/scene_input.h"
#include "cli/report/progress.h"

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

DepthRange depth_range_of(const PictureOptions& picture) {
  return picture.settings.depth == DepthFormat::kFloat32Reversed ? DepthRange::kReversed
                                                                 : DepthRange::kStandard;
}

// ---- the user's own matrices ----

// An option of the camera that says the same as a matrix; nullptr if there is none. --view fixes
// the pose, and --proj the pose and the lens.
const char* second_camera(const CameraOptions& camera, bool lens_is_given) {
  if (camera.camera) return "--camera";
  if (camera.eye) return "--eye";
  if (camera.look_at) return "--look-at";
  if (camera.up) return "--up";
  if (camera.formulation.view != Formulation{}.view) return "--view-from";
  if (!lens_is_given) return nullptr;
  if (camera.fov_degrees) return "--fov";
  if (camera.ortho_height) return "--ortho";
  if (camera.frustum) return "--frustum";
  if (camera.near) return "--near";
  if (camera.far) return "--far";
  if (camera.formulation.projection != Formulation{}.projection) return "--projection";
  return nullptr;
}

Result<void> check_one_camera(const PictureOptions& picture) {
  const bool lens_is_given = picture.matrices.projection.given;
  const char* second = second_camera(picture.camera, lens_is_given);
  if (second == nullptr) return {};
  return fail(
      second,
      lens_is_given ? "the camera is also given by --proj" : "the pose is also given by --view",
      "give one of them");
}

// The aspect ratio of the picture over that of the projection's window; nothing if they are as
// equal as whole pixels allow.
std::optional<double> stretch_of(const PictureOptions& picture) {
  const std::optional<double> meant = aspect_of_projection(picture.matrices.projection);
  if (!meant) return std::nullopt;
  const auto [width, height] = picture.size;
  const double stretch = double(width) / height / *meant;
  // Rounding a side to whole pixels changes the ratio by at most half a pixel of the shorter side.
  if (std::abs(stretch - 1) <= 0.5 / std::min(width, height)) return std::nullopt;
  return stretch;
}

std::vector<std::string> notes_on_projection(const PictureOptions& picture) {
  const NamedSetup named = setup_of(picture.matrices);
  const auto [width, height] = picture.size;
  std::vector<std::string> notes{fmt::format("--proj is taken as a matrix for {} ({})",
                                             named.setup.dialect.title, named.dialect_reason)};
  if (const auto stretch = stretch_of(picture)) {
    notes.push_back(
        fmt::format("a picture of {} x {} stretches what --proj draws by {:.3g} in x: its window "
                    "has the aspect "
                    "ratio {:.6g}",
                    width, height, *stretch, width / *stretch / height));
  }
  const auto made = view_of_matrices(named.setup, width, height, depth_range_of(picture));
  if (made && made->mirrors && !named.setup.front) {
    notes.push_back(
        "the matrices mirror the scene: its outside runs clockwise on the screen. It is drawn all "
        "the same; --front ccw or --front cw draws what your API takes for front faces");
  }
  if (made && !made->eye_space_is_given) {
    notes.push_back(
        "--view is not a rotation and a translation, or --proj has a view in it: eye space is that "
        "of the eye found in their product");
  }
  return notes;
}

Result<ChosenView> view_of_both(const PictureOptions& picture) {
  const auto [width, height] = picture.size;
  const Result<MatrixView> made =
      view_of_matrices(setup_of(picture.matrices).setup, width, height, depth_range_of(picture));
  if (!made) return tl::unexpected(made.error());
  return ChosenView{made->camera, made->view, *made};
}

// ---- the camera ----

Result<Camera> choose_camera_and_pose(const Scene& scene, const PictureOptions& picture) {
  const auto [width, height] = picture.size;
  const double aspect = double(width) / double(height);
  const GivenMatrix& view = picture.matrices.view;
  return choose_camera(scene, picture.camera, aspect,
                       view.given ? std::optional(Transform<Eye, World>(view.m)) : std::nullopt);
}

Result<ChosenView> choose_centre(const Scene& scene, const PictureOptions& picture) {
  const MatrixOptions& matrices = picture.matrices;
  if (const auto read = check_matrices_read(matrices); !read) return tl::unexpected(read.error());
  if (matrices.replace_camera()) {
    if (const auto one = check_one_camera(picture); !one) return tl::unexpected(one.error());
  }
  if (matrices.projection.given) return view_of_both(picture);
  const auto [width, height] = picture.size;
  const Result<Camera> camera = choose_camera_and_pose(scene, picture);
  if (!camera) return tl::unexpected(camera.error());
  const Result<View> view =
      make_view(*camera, width, height, depth_range_of(picture), picture.camera.formulation);
  if (!view) {
    Error error = view.error();
    // name the option that the user gave
    if (error.place == "projection form") error.place = "--projection";
    if (error.place == "camera pose" && matrices.view.given) error.place = "--view";
    return tl::unexpected(error);
  }
  return ChosenView{*camera, *view, std::nullopt};
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
  add_matrix_options(command, picture.matrices, picture.size);
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
  if (const auto read = check_matrices_read(picture.matrices); !read) {
    return tl::unexpected(read.error());
  }
  if (word == "-" && picture.matrices.reads_standard_input) {
    return fail("SCENE", "the scene and a matrix are both standard input",
                "name a file for one of them");
  }
  return load_scene_argument(word, progress, limits)
      .and_then([&](Scene scene) { return with_model_matrix(std::move(scene), picture.matrices); })
      .map([&](Scene scene) {
        if (picture.matrices.projection.given) {
          for (const std::string& note : notes_on_projection(picture)) {
            progress.print_line("note: " + note);
          }
        }
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
  if (picture.matrices.reads_standard_input) return portable_option_words(picture);
  return option_words(picture.options);
}

std::vector<std::string> portable_option_words(const PictureOptions& picture) {
  const MatrixOptions& m = picture.matrices;
  const std::pair<const char*, const GivenMatrix*> matrices[] = {
      {"--model", &m.model}, {"--view", &m.view}, {"--proj", &m.projection}};
  std::vector<std::string> words;
  for (const CLI::Option* option : picture.options) {
    const std::string name = option->get_name();
    // The numbers are written by rows, so that no order is needed.
    if (name.ends_with("order")) continue;
    std::vector<std::string> of_option = option_words(std::array{option});
    for (const auto& [matrix_name, matrix] : matrices) {
      if (name == matrix_name && matrix->given) of_option = {name, numbers_text(*matrix)};
    }
    std::ranges::move(of_option, std::back_inserter(words));
  }
  return words;
}

Result<ChosenView> choose_view(const Scene& scene, const PictureOptions& picture) {
  const EyesOptions& eyes = picture.eyes;
  if (!eyes.seen_by) {
    if (!eyes.separation && !eyes.window) return choose_centre(scene, picture);
    return fail(eyes.separation ? "--eye-separation" : "--window",
                "this option needs two eyes, but the picture is for one",
                "choose an eye with --seen-by left or --seen-by right");
  }
  return choose_eyes(scene, picture).map([&](const ChosenEyes& chosen) {
    return ChosenView{chosen.camera, eye_view(chosen.centre, chosen.eyes.pair, *eyes.seen_by),
                      std::nullopt};
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
