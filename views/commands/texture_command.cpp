// glassbox views texture: draws a surface from another eye, with the colours of pictures.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/camera_options.h"
#include "cli/options/choices.h"
#include "cli/options/ignored_options.h"
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"
#include "views/commands/commands.h"
#include "views/commands/picture_choice.h"
#include "views/commands/surface_page.h"
#include "views/texture/static_texture.h"
#include "views/texture/textured_surface.h"
#include "views/texture/unlit_renderer.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/elementary.h>
#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>
#include <glassbox/mesh/gltf/write.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::views {

class ViewsTextureCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  struct TexturingResult;
  int run();
  Result<void> check_options() const;
  Result<void> check_outputs() const;
  void print_unused_options() const;
  double bytes_for(const Scene& scene, const ChosenPictures& pictures) const;
  Result<TexturingResult> texture(const Scene& scene, const ChosenPictures& pictures,
                                  Progress& progress) const;
  Result<void> write_outputs(const Scene& scene, const ChosenPictures& pictures,
                             const TexturingResult& found) const;
  std::string text(const ChosenPictures& pictures, const TexturingResult& found) const;
  nlohmann::ordered_json json(const ChosenPictures& pictures, const TexturingResult& found) const;
  std::string command_line() const;

  std::string mesh_;
  PictureChoice choice_;
  bool each_ = false;
  views::Blend blend_ = views::Blend::kBarycentric;
  int neighbours_ = 4, texels_ = 8;
  CameraOptions camera_;
  std::optional<Size> size_;
  Rgba8 background_{26, 31, 38, 255};
  std::optional<std::string> output_, fixed_, left_out_output_, json_output_, page_;
  const CLI::App* command_ = nullptr;
  std::vector<std::string> camera_words_;  // names of the camera options
  std::vector<const CLI::Option*> options_;
};

struct ViewsTextureCommand::TexturingResult {
  explicit TexturingResult(views::TexturedSurface textured) : surface(std::move(textured)) {}

  // One picture reconstructed from the other pictures with one kind of blending.
  struct HeldOutPicture {
    std::string picture;
    Blend blend = Blend::kBarycentric;
    views::TextureErrors errors;
  };
  // The PSNR over all pictures as if they were one picture; NaN if no pixel is covered.
  double psnr_of_all(Blend blend) const {
    double squares = 0, pixels = 0;
    for (const HeldOutPicture& one : each) {
      if (one.blend != blend) continue;
      const double covered = one.errors.covered * double(one.errors.pixels);
      if (covered > 0) squares += one.errors.rms * one.errors.rms * covered;
      pixels += covered;
    }
    return 10 * logarithm_10(255 * 255 * pixels / squares);
  }

  views::TexturedSurface surface;
  std::uint64_t bytes = 0;  // expected memory for everything
  std::int64_t polygons = 0, unseen = 0;
  std::size_t triangles = 0;  // of the sphere of view directions
  std::optional<views::TexturedPicture> drawn, left_out;
  std::optional<views::TextureErrors> errors;
  std::vector<HeldOutPicture> each;
  std::optional<Scene> fixed;
  std::vector<std::uint8_t> views;  // for each polygon: how many pictures see it
};

void ViewsTextureCommand::add_to(CLI::App& views, int& exit_code) {
  CLI::App& command = *views.add_subcommand(
      "texture", "draw a surface from another view with the colours of the pictures around it");
  command.footer(
      "Examples:\n"
      "  glassbox views texture teapot.glb ring --eye 4,3,5 --look-at 0,1,0 -o picture.png\n"
      "  glassbox views texture teapot.glb ring --leave-out 4 --left-out-output again.png\n"
      "  glassbox views texture teapot.glb ring --each --json -\n"
      "  glassbox views texture teapot.glb ring --fixed textured.glb\n\n"
      "Each polygon gets the colours of the three pictures whose directions surround that of the "
      "eye, by\n"
      "their barycentric weights, without pictures that do not see it. From a picture's own "
      "position the\n"
      "result is that picture. docs/polygons.md has more.");
  command.add_option("MESH", mesh_, kSceneHelp)->required();
  command_ = &command;
  const std::size_t before = command.get_options().size();
  add_picture_choice(command, choice_);
  command
      .add_flag("--each", each_,
                "leave out each picture in turn, and measure how well each --blend reproduces it "
                "from the others")
      ->group("Pictures");
  std::string group = "Blend";
  add_choice(command, "--blend", blend_,
             choices_of({Blend::kNearest, Blend::kBarycentric, Blend::kNeighbours}),
             "blend the nearest picture, the three around the eye, or the nearest few by their "
             "angles [barycentric]")
      ->group(group);
  command.add_option("--neighbours", neighbours_, "number of pictures for --blend neighbours [4]")
      ->type_name("K")
      ->check(CLI::Range(1, views::kMaxNeighbours))
      ->group(group);
  const std::size_t before_camera = command.get_options().size();
  add_camera_options(command, camera_);
  const auto with_camera = command.get_options();
  for (std::size_t i = before_camera; i < with_camera.size(); ++i)
    camera_words_.push_back(with_camera[i]->get_name());
  command
      .add_option_function<std::string>(
          "--size", [this](const std::string& text) { size_ = parse_size(text); },
          "size of the picture in pixels [that of the first of PICTURES]")
      ->type_name("WxH")
      ->group("Picture");
  command
      .add_option_function<std::string>(
          "--background", [this](const std::string& text) { background_ = parse_background(text); },
          "background colour as displayed, each channel 0 .. 1 [0.1,0.12,0.15]")
      ->type_name("R,G,B")
      ->group("Picture");
  command
      .add_option("--texels", texels_,
                  "for --fixed: size of the texture: each pair of triangles gets a square of N x N "
                  "texels [8]")
      ->type_name("N")
      ->check(CLI::Range(views::kMinTexels, views::kMaxTexels))
      ->group(group);
  const auto all = command.get_options();
  options_.assign(all.begin() + std::ptrdiff_t(before) + 1, all.end());
  group = "Outputs";
  command.add_option("-o,--output", output_, "the picture: .png or .ppm")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option("--fixed", fixed_,
                  "the surface with one texture for all eyes, which `render` draws: .glb")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option("--left-out-output", left_out_output_,
                  "the picture that was left out, made from the others: .png or .ppm")
      ->type_name("FILE")
      ->group(group);
  add_json_output(command, json_output_)->group(group);
  add_html_output(command, page_,
                  "a page with the surface in 3D, which you can turn, and the pictures that give "
                  "it its colours")
      ->group(group);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> ViewsTextureCommand::check_options() const {
  if (left_out_output_ && !choice_.leave_out)
    return fail("--left-out-output", "no picture is left out", "add --leave-out N");
  if (each_ && choice_.leave_out)
    return fail("--each", "--leave-out is given too", "leave one of them out");
  return check_choice(choice_);
}

Result<void> ViewsTextureCommand::check_outputs() const {
  return Outputs()
      .picture(output_)
      .picture(left_out_output_)
      .file(fixed_, ".glb")
      .file(page_, ".html")
      .data(json_output_)
      .check();
}

void ViewsTextureCommand::print_unused_options() const {
  const bool no_picture = !output_;
  print_ignored_options(
      *command_, {{blend_ != Blend::kNeighbours && !each_,
                   {"--neighbours"},
                   "it is only for --blend " + std::string(views::name_of(Blend::kNeighbours))},
                  {!fixed_, {"--texels"}, "it is only for --fixed"},
                  {no_picture, camera_words_, "no picture is drawn without -o"},
                  {no_picture, {"--size"}, "no picture is drawn without -o"}});
}

// An upper bound of the memory in bytes for all outputs. All data are counted as if they existed at
// the same time.
double ViewsTextureCommand::bytes_for(const Scene& scene, const ChosenPictures& pictures) const {
  const views::PictureSet& set = pictures.set;
  double largest = 0;
  const auto draw = [&](double pixels) { largest = std::max(largest, pixels); };
  for (const views::CalibratedPicture& picture : set.pictures)
    draw(double(picture.color.pixels.size()));
  if (size_) draw(double(size_->width) * size_->height);
  double bytes = views::bytes_of(set) + views::TexturedSurface::bytes_for(scene, set);
  if (pictures.left_out) {
    bytes += views::bytes_of(*pictures.left_out);
    draw(double(pictures.left_out->color.pixels.size()));
  }
  if (fixed_) bytes += views::static_texture_bytes(views::triangle_number_count(scene), texels_);
  // The pictures drawn for outputs are kept, with a colour and the number of a polygon for each
  // pixel.
  const double outputs = double(output_.has_value()) + double(pictures.left_out.has_value());
  return bytes + outputs * largest * (sizeof(Rgba8) + sizeof(std::uint32_t)) +
         views::UnlitRenderer::bytes_for(double(views::triangle_number_count(scene)), largest);
}

Result<ViewsTextureCommand::TexturingResult> ViewsTextureCommand::texture(
    const Scene& scene, const ChosenPictures& pictures, Progress& progress) const {
  progress.phase("computing what each picture sees");
  const views::PictureSet& set = pictures.set;
  const double bytes = bytes_for(scene, pictures);
  const auto legal = check_memory("--max-mb", "the surface, and what each picture sees of it,",
                                  bytes, choice_.most_bytes());
  if (!legal) return tl::unexpected(legal.error());
  auto made = views::TexturedSurface::create(scene, set, blend_, neighbours_);
  if (!made) return tl::unexpected(made.error());
  TexturingResult found(std::move(*made));
  found.bytes = std::uint64_t(bytes);
  const views::TexturedSurface& surface = found.surface;
  found.polygons = std::int64_t(surface.visible_polygons().polygons());
  found.unseen = surface.visible_polygons().unseen();
  found.triangles = surface.blend().sphere().triangles().size();
  for (std::uint32_t i = 0; i < found.polygons; ++i) {
    int seen = 0;
    for (std::size_t view = 0; view < set.pictures.size(); ++view)
      seen += surface.visible_polygons().sees(view, i);
    found.views.push_back(std::uint8_t(std::min(seen, 255)));
  }
  const Size size = size_.value_or(Size{set.pictures[0].color.width, set.pictures[0].color.height});
  if (output_) {
    progress.phase("drawing");
    const auto camera = choose_camera(scene, camera_, double(size.width) / size.height);
    if (!camera) return tl::unexpected(camera.error());
    const auto view = make_view(*camera, size.width, size.height);
    if (!view) return tl::unexpected(view.error());
    const auto pinhole = views::camera_of(*view);
    if (!pinhole) return tl::unexpected(pinhole.error());
    auto drawn = surface.draw(*pinhole, size.width, size.height, background_);
    if (!drawn) return tl::unexpected(drawn.error());
    found.drawn = std::move(*drawn);
  }
  if (const auto& left_out = pictures.left_out) {
    auto drawn =
        surface.draw(left_out->camera, left_out->color.width, left_out->color.height, background_);
    if (!drawn) return tl::unexpected(drawn.error());
    found.errors = views::textured_picture_errors(*drawn, *left_out);
    found.left_out = std::move(*drawn);
  }
  for (std::size_t i = 0; each_ && i < set.pictures.size(); ++i) {
    progress.phase("leaving out " + set.pictures[i].name);
    const views::CalibratedPicture& picture = set.pictures[i];
    for (const Blend blend : {Blend::kNearest, Blend::kBarycentric, Blend::kNeighbours}) {
      const auto drawn =
          surface.with_blend(blend, neighbours_, i)
              .draw(picture.camera, picture.color.width, picture.color.height, background_);
      if (!drawn) return tl::unexpected(drawn.error());
      found.each.push_back({picture.name, blend, views::textured_picture_errors(*drawn, picture)});
    }
  }
  if (fixed_) {
    progress.phase("making the texture");
    auto fixed = views::with_static_texture(scene, surface, texels_, double(choice_.most_bytes()));
    if (!fixed) return tl::unexpected(fixed.error());
    found.fixed = std::move(*fixed);
  }
  return found;
}

std::string ViewsTextureCommand::text(const ChosenPictures& pictures,
                                      const TexturingResult& found) const {
  std::string text = fmt::format(
      "{}: {}, {} whose directions make {}\n", printable(mesh_, kLongestMessage),
      counted(found.polygons, "polygon"), counted(pictures.set.pictures.size(), "picture"),
      counted(found.triangles, "triangle"));
  if (const auto& drawn = found.drawn)
    text +=
        fmt::format("{}: {} pixels of the surface, with {} blend\n",
                    printable(*output_, kLongestMessage), drawn->surface, views::name_of(blend_));
  if (found.errors) text += left_out_text(pictures.left_out->name, *found.errors);
  if (!found.each.empty()) {
    text += "each picture made from the others, PSNR over all of them:\n";
    for (const Blend blend : {Blend::kNearest, Blend::kBarycentric, Blend::kNeighbours}) {
      const double psnr = found.psnr_of_all(blend);
      text += fmt::format("  {:<12}{}\n", views::name_of(blend),
                          std::isnan(psnr) ? "covers no pixel" : fmt::format("{:.2f} dB", psnr));
    }
  }
  if (found.fixed) {
    const Image<Rgba8>& image = found.fixed->images.front();
    text += fmt::format("{}: a texture of {} x {} for all eyes\n",
                        printable(*fixed_, kLongestMessage), image.width, image.height);
  }
  if (found.unseen > 0)
    text += fmt::format(
        "Left out: the pictures' colours of {} that no picture shows. Such a polygon has "
        "the mesh's own colours.\n",
        counted(found.unseen, "polygon"));
  return text;
}

nlohmann::ordered_json ViewsTextureCommand::json(const ChosenPictures& pictures,
                                                 const TexturingResult& found) const {
  nlohmann::ordered_json json{{"mesh", mesh_},
                              {"cameras", pictures.set.source},
                              {"pictures", pictures.set.pictures.size()},
                              {"bytes", found.bytes},
                              {"polygons", found.polygons},
                              {"unseen", found.unseen},
                              {"view_triangles", found.triangles},
                              {"blend", views::name_of(blend_)}};
  if (found.drawn)
    json["drawn"] = {{"surface", found.drawn->surface},
                     {"without_view", found.drawn->without_view}};
  if (found.errors) json["left_out"] = left_out_json(pictures.left_out->name, *found.errors);
  for (const TexturingResult::HeldOutPicture& one : found.each) {
    nlohmann::ordered_json entry = left_out_json(one.picture, one.errors);
    entry["blend"] = views::name_of(one.blend);
    json["each"].push_back(entry);
  }
  if (!found.each.empty()) {
    for (const Blend blend : {Blend::kNearest, Blend::kBarycentric, Blend::kNeighbours})
      json["psnr"][std::string(views::name_of(blend))] = found.psnr_of_all(blend);
  }
  return json;
}

std::string ViewsTextureCommand::command_line() const {
  std::vector<std::string> page;
  if (page_) page = {"--html", *page_};
  return shell_line({{"views", "texture", mesh_, choice_.path}, option_words(options_), page});
}

Result<void> ViewsTextureCommand::write_outputs(const Scene& scene, const ChosenPictures& pictures,
                                                const TexturingResult& found) const {
  // All outputs are made before the first file is written, so that an error in making them leaves
  // no file.
  Result<std::string> made;
  if (page_) {
    SurfacePage page;
    page.verb = "texture";
    page.title = mesh_;
    page.summary = fmt::format("{} polygons with the colours of {} pictures", found.polygons,
                               pictures.set.pictures.size());
    page.text = text(pictures, found);
    page.command = command_line();
    page.scene = &scene;
    page.views = found.views;
    page.textured = &found.surface;
    page.pictures = &pictures.set;
    if (found.left_out) {
      page.left_out = &*pictures.left_out;
      page.drawn = &found.left_out->color;
    }
    made = make_surface_page(page);
    if (!made) return tl::unexpected(made.error());
  }
  if (output_) {
    if (const auto written = write_image(*output_, found.drawn->color); !written) return written;
  }
  if (left_out_output_) {
    if (const auto written = write_image(*left_out_output_, found.left_out->color); !written)
      return written;
  }
  if (fixed_) {
    if (const auto written = write_glb(*found.fixed, *fixed_); !written) return written;
  }
  if (page_) {
    if (const auto written = write_text(*page_, *made); !written) return written;
  }
  return json_output_ ? write_json(*json_output_, json(pictures, found)) : Result<void>();
}

int ViewsTextureCommand::run() {
  for (const auto& legal : {check_options(), check_outputs()}) {
    if (!legal) return refuse(legal.error());
  }
  print_unused_options();
  Progress progress;
  const auto scene = load_scene_argument(mesh_, progress);
  if (!scene) return refuse(scene.error());
  const auto pictures = read_pictures(choice_, progress);
  if (!pictures) return refuse(pictures.error());
  if (each_ && pictures->set.pictures.size() == 1)
    return refuse(
        fail("--each", "the only picture cannot be left out", "use a set of several pictures")
            .value());
  const auto found = texture(*scene, *pictures, progress);
  if (!found) return refuse(found.error());
  progress.phase("writing");
  if (const auto written = write_outputs(*scene, *pictures, *found); !written)
    return refuse(written.error());
  progress.done();
  if (json_output_ == "-") return kSuccess;
  fmt::print("{}", text(*pictures, *found));
  if (page_) fmt::print("\n{}: open it in a browser\n", printable(*page_, kLongestMessage));
  return kSuccess;
}

void add_texture_command(CLI::App& views, int& exit_code) {
  add_command<ViewsTextureCommand>(views, exit_code);
}

}  // namespace glassbox::views
