#include "app/picture_options.h"

namespace glassbox::app {

namespace {

void add_drawing_options(CLI::App& command, RenderSettings& settings) {
  const std::string group = "Picture";
  add_choice(command, "--shade", settings.shading,
             {{"unlit", Shading::kUnlit},
              {"flat", Shading::kFlat},
              {"gouraud", Shading::kGouraud},
              {"phong", Shading::kPhong}},
             "where lighting is computed [phong]")
      ->group(group);
  add_choice(command, "--show", settings.show,
             {{"depth", Show::kDepth},
              {"normal", Show::kNormal},
              {"uv", Show::kUv},
              {"id", Show::kId},
              {"overdraw", Show::kOverdraw}},
             "a quantity in place of the colours")
      ->group(group);
  add_choice(command, "--cull", settings.cull,
             {{"back", Cull::kBack}, {"front", Cull::kFront}, {"none", Cull::kNone}},
             "faces to leave out [as each material says]")
      ->group(group);
  command.add_flag("--wireframe", settings.wireframe, "the edges of triangles only")->group(group);
  command
      .add_option_function<std::string>(
          "--background",
          [&settings](const std::string& text) { settings.background = parse_background(text); },
          "background as displayed, each 0 .. 1 [0.1,0.12,0.15]")
      ->type_name("R,G,B")
      ->group(group);
  add_choice(command, "--transfer", settings.transfer,
             {{"srgb", Transfer::kSrgb}, {"none", Transfer::kNone}},
             "encoding of stored colours [srgb]")
      ->group(group);
  add_choice(command, "--depth", settings.depth,
             {{"d32", DepthFormat::kFloat32},
              {"d32r", DepthFormat::kFloat32Reversed},
              {"d24", DepthFormat::kUnorm24},
              {"d16", DepthFormat::kUnorm16}},
             "depth buffer format; d32r is reversed [d32]")
      ->group(group);
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
  add_drawing_options(command, picture.settings);
  const auto all = command.get_options();
  picture.options.assign(all.begin() + std::ptrdiff_t(before), all.end());
}

std::vector<std::string> words_given(const PictureOptions& picture) {
  std::vector<std::string> words;
  for (const CLI::Option* option : picture.options) {
    if (option->count() == 0) continue;
    words.push_back(option->get_name());
    const bool flag = option->get_expected_max() == 0;
    if (!flag) words.push_back(option->results().back());
  }
  return words;
}

Result<ChosenView> choose_view(const Scene& scene, const PictureOptions& picture) {
  const auto [width, height] = picture.size;
  const Result<Camera> camera =
      choose_camera(scene, picture.camera, double(width) / double(height));
  if (!camera) return tl::unexpected(camera.error());
  const DepthRange range = picture.settings.depth == DepthFormat::kFloat32Reversed
                               ? DepthRange::kReversed
                               : DepthRange::kStandard;
  const Result<View> view = make_view(*camera, width, height, range);
  if (!view) return tl::unexpected(view.error());
  return ChosenView{*camera, *view};
}

}  // namespace glassbox::app
