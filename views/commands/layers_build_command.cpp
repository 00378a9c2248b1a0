// glassbox views layers build: writes a file with the surfaces that one camera sees, and the
// surfaces behind them.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/builtin_help.h"
#include "cli/options/choices.h"
#include "cli/options/engine_options.h"
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "views/commands/commands.h"
#include "views/layers/depth_peeling.h"
#include "views/layers/layer_builder.h"
#include "views/layers/layer_file.h"
#include "views/layers/layer_sources.h"
#include "views/layers/ray_layers.h"
#include "views/layers/ray_surfaces.h"
#include "views/layers/triangle_normals.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>

namespace glassbox::views {

class LayersBuildCommand {
public:
  void add_to(CLI::App& layers, int& exit_code);

private:
  // The layers, and the facts for the report about them.
  struct BuiltLayers {
    views::StoredLayers layers;
    std::size_t views = 1;
    std::size_t outside = 0;  // samples of other views that are outside this camera's picture
    std::vector<std::string> left_out;
    std::optional<views::RayCounts> rays;
  };

  int run();
  Result<void> check_sources() const;
  Result<void> check_options(const Scene& scene) const;
  Result<BuiltLayers> build(Progress& progress) const;
  Result<BuiltLayers> build_from_scene(Progress& progress) const;
  Result<BuiltLayers> build_from_pictures() const;
  Result<void> check_rays() const;
  BuiltLayers build_by_rays(const Scene& scene, const Camera& camera, const View& view) const;
  double epsilon() const;
  double cube_side(const View& view) const;  // world units
  views::WantedAttributes wanted_attributes() const { return {normals_, ids_}; }

  std::optional<std::string> scene_, views_, pictures_;
  std::string output_;
  std::optional<int> layers_;
  std::optional<double> epsilon_;
  std::optional<views::RaySampling> rays_;
  std::optional<double> cube_;
  std::optional<int> threads_;
  bool ends_ = false, normals_ = false, ids_ = false;
  PictureOptions picture_;
  std::optional<std::string> json_output_;
};

namespace {

using Clock = std::chrono::steady_clock;
constexpr int kMaxLayers = 255, kUsualLayers = 10;

// Parses "32,16" or "32". Throws CLI::ValidationError if the text has another form, or if there
// would be too many rays.
views::RaySampling parse_rays(const std::string& text) {
  constexpr int kMaxStrata = 90;  // the largest number whose fourth power is below kMaxRays
  views::RaySampling sampling;
  const auto read = [&](const std::string& part, int most, int& number) {
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (error != std::errc() || end != part.data() + part.size() || number < 1 || number > most)
      throw CLI::ValidationError(
          "--rays", fmt::format("\"{}\" is not N or N,M: N from 1 to {}, M from 1 to {}",
                                printable(text, kLongestMessage), kMaxStrata, views::kMaxRays));
  };
  const std::vector<std::string> parts = split(text, ',');
  read(parts.size() > 2 ? text : parts[0], kMaxStrata, sampling.strata);
  if (parts.size() > 1) read(parts[1], int(views::kMaxRays), sampling.rays);
  if (sampling.count() > views::kMaxRays)
    throw CLI::ValidationError("--rays",
                               fmt::format("N^4 M = {} rays are more than {}: give smaller numbers",
                                           sampling.count(), views::kMaxRays));
  return sampling;
}

}  // namespace

void LayersBuildCommand::add_to(CLI::App& layers, int& exit_code) {
  CLI::App& command = *layers.add_subcommand(
      "build", "write a layered depth image of a scene, or of pictures with distances");
  command.footer(
      "Examples:\n"
      "  glassbox views layers build room --size 300x300 -o room.ldi\n"
      "  glassbox views layers build forest --layers 4 -o forest.ldi --json -\n"
      "  glassbox views layers build room --views cameras.txt --layers 1 -o room.ldi\n"
      "  glassbox views layers build --pictures cameras.txt -o photos.ldi\n"
      "  glassbox views layers build room --size 300x300 --rays 16 --threads 2 -o rays.ldi\n\n"
      "Each pass draws the surfaces behind those that the earlier passes have drawn (depth "
      "peeling).\n"
      "Colours are those of the view that is peeled: a highlight stays where that view sees it. A "
      "file of\n"
      "cameras has the form of the Middlebury multi-view pictures: their number, then for each a "
      "name,\n"
      "the intrinsic matrix K, the rotation R and the translation t. --pictures reads each line's\n"
      "picture and its distances along the gaze, NAME.pfm; the first picture's camera is\n"
      "that of the layers.\n\n" +
      builtin_help());
  command.add_option("SCENE", scene_, kSceneHelp);
  command.add_option("-o,--output", output_, "the layers, .ldi")->type_name("FILE")->required();
  command
      .add_option("--layers", layers_,
                  fmt::format("largest number of passes, 1 .. {} [{}]", kMaxLayers, kUsualLayers))
      ->type_name("N")
      ->check(CLI::Range(1, kMaxLayers));
  command
      .add_option("--views", views_,
                  "a file of more cameras from which the scene is peeled; their pictures have the "
                  "--size too")
      ->type_name("FILE");
  command
      .add_option("--pictures", pictures_,
                  "instead of a scene: cameras whose pictures and distances are files")
      ->type_name("FILE");
  command
      .add_option("--epsilon", epsilon_,
                  "samples of several views are merged if the relative difference of their depths "
                  "is below this [1/1024]")
      ->type_name("E")
      ->check(number_between(0, 0.5));
  command.add_flag("--normals", normals_,
                   "store the surfaces' normals, from which draw computes the size of a sample");
  command.add_flag("--ids", ids_, "store the triangles' numbers, as --id-out writes them");
  command.add_flag("--ends", ends_,
                   "keep only two samples per pixel: the nearest and the farthest");
  command
      .add_option_function<std::string>(
          "--rays", [this](const std::string& text) { rays_ = parse_rays(text); },
          "cast rays instead of peeling: the starts and the directions of the rays are divided "
          "into N x N parts each, and each of the N^4 pairs of parts gets M rays [16]")
      ->type_name("N[,M]");
  command
      .add_option("--cube", cube_,
                  "width of the cube that the rays start from, in world units [twice --near]")
      ->type_name("SIDE");
  command
      .add_option("--threads", threads_,
                  fmt::format("number of threads for --rays, 1 .. {}; the bytes are the same [1]",
                              kMaxThreads))
      ->type_name("N")
      ->check(CLI::Range(1, kMaxThreads));
  add_picture_options(command, picture_);
  add_json_output(command, json_output_);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> LayersBuildCommand::check_sources() const {
  if (!scene_ && !pictures_)
    return fail("SCENE", "neither a scene nor pictures are given",
                "name a scene, or give --pictures");
  if (scene_ && pictures_)
    return fail("--pictures", "the layers cannot be made from both pictures and a scene",
                "leave the pictures or the scene out");
  if (const auto good = check_rays(); !good) return good;
  if (!pictures_) {
    if (epsilon_ && !views_ && !rays_)
      return fail("--epsilon",
                  "this option merges the samples of several views, but there is only one view",
                  "give --views, or leave this option out");
    return {};
  }
  if (views_)
    return fail("--views", "these cameras look at a scene, but none is given",
                "name a scene, or leave this option out");
  if (layers_)
    return fail("--layers",
                "with --pictures each pixel has only one distance, so there is one layer",
                "leave it out");
  if (normals_ || ids_)
    return fail(normals_ ? "--normals" : "--ids",
                "pictures contain no surfaces, from which normals or triangles would come",
                "name a scene, or leave this option out");
  if (const auto words = given_option_words(picture_); !words.empty())
    return fail(words.front(), "this option is for drawing a scene, but --pictures draws none",
                "leave it out");
  return {};
}

Result<void> LayersBuildCommand::check_rays() const {
  if (!rays_) {
    if (cube_ || threads_)
      return fail(cube_ ? "--cube" : "--threads", "no rays are cast",
                  "give --rays, or leave this option out");
    return {};
  }
  if (pictures_) return fail("--rays", "the rays need a scene, but none is given", "name a scene");
  if (views_ || layers_)
    return fail(views_ ? "--views" : "--layers",
                "this option is for peeling the scene, but --rays casts rays instead",
                "leave out one of the two options");
  if (cube_ && !(*cube_ > 0 && std::isfinite(*cube_)))
    return fail("--cube", fmt::format("{:g} is not a possible width", *cube_),
                "give a number above 0");
  if (const Shading shading = picture_.settings.shading;
      shading == Shading::kFlat || shading == Shading::kGouraud)
    return fail("--shade",
                "with --rays each point that a ray hits is lit separately, so there is no flat or "
                "Gouraud shading",
                "give phong or unlit");
  return {};
}

Result<void> LayersBuildCommand::check_options(const Scene& scene) const {
  const RenderSettings& settings = picture_.settings;
  if (settings.wireframe)
    return fail("--wireframe", "layers store surfaces, not lines", "leave it out");
  if (settings.samples > 1)
    return fail("--samples",
                "each pixel of a layer has only one depth, so it cannot have several samples",
                "leave it out");
  if (settings.show != Show::kColor) return fail("--show", "layers store colours", "leave it out");
  if (const Material* glass = views::transparent_material(scene))
    return fail(
        printable(*scene_), "material \"" + printable(glass->name) + "\" is transparent",
        "make its surfaces opaque or masked, because a sample of a layer hides what is behind it");
  return {};
}

double LayersBuildCommand::cube_side(const View& view) const {
  return cube_.value_or(2 * view.near);
}

double LayersBuildCommand::epsilon() const {
  return epsilon_.value_or(views::kMergedDepths);
}

Result<LayersBuildCommand::BuiltLayers> LayersBuildCommand::build_from_scene(
    Progress& progress) const {
  const auto scene = load_scene_argument(*scene_, picture_, progress);
  if (!scene) return tl::unexpected(scene.error());
  if (const auto good = check_options(*scene); !good) return tl::unexpected(good.error());
  const auto chosen = choose_view(*scene, picture_);
  if (!chosen) return tl::unexpected(chosen.error());
  if (chosen->of_matrices) {
    return fail("--proj", "a layered depth image has the lens of a camera, not a matrix",
                "describe the lens by --fov, --ortho or --frustum, with --near and --far");
  }
  if (rays_) {
    if (!chosen->view.perspective)
      return fail("--rays", "a parallel view has no eye for the cube around it",
                  "choose a perspective view, or leave --rays out");
    if (const double side = cube_side(chosen->view); !(side / 2 <= views::kFarthest))
      return fail(cube_ ? "--cube" : "--near",
                  fmt::format("rays would start {:g} world units from the eye", side / 2),
                  fmt::format("choose a smaller --cube or --near, so that they start at most {:g} "
                              "world units from the eye",
                              views::kFarthest));
    progress.phase("casting rays into " + scene_title(*scene_));
    return build_by_rays(*scene, chosen->camera, chosen->view);
  }
  const Size& size = picture_.size;
  std::vector<View> others;
  if (views_) {
    const auto cameras = views::read_cameras(*views_);
    if (!cameras) return tl::unexpected(cameras.error());
    const double near = chosen->view.near, far = chosen->view.far;
    if (!(near > 0))
      return fail("--views",
                  "these cameras use the near plane of the main camera, which is not in front of "
                  "that camera",
                  "give the distance of the near plane with --near");
    for (const views::NamedCamera& named : *cameras) {
      const auto view =
          views::camera_of_pinhole(named.camera, size.width, size.height, near,
                                   std::isinf(far) ? std::nullopt : std::optional(far))
              .and_then(
                  [&](const Camera& camera) { return make_view(camera, size.width, size.height); });
      if (!view)
        return tl::unexpected(
            Error{*views_, printable(named.picture), view.error().cause, view.error().remedy});
      others.push_back(*view);
    }
  }
  RenderSettings settings = picture_.settings;
  settings.want_distance = true;
  settings.want_id = normals_ || ids_;
  const std::vector<views::SampleNormal> normals =
      normals_ ? views::triangle_normals(*scene) : std::vector<views::SampleNormal>();
  const int layers = layers_.value_or(kUsualLayers);
  views::LayerBuilder builder(views::layer_camera(chosen->view), others.empty() ? 0 : epsilon(),
                              wanted_attributes());
  BuiltLayers built;
  built.views = 1 + others.size();
  std::uint32_t rank = 0;
  bool is_cut = false;  // the last allowed layer of a view was not empty, so there may be more
  const auto add = [&](const View& view) {
    progress.phase(others.empty() ? "peeling " + scene_title(*scene_)
                                  : fmt::format("peeling {}, view {} of {}", scene_title(*scene_),
                                                rank + 1, built.views));
    const std::vector<views::Layer> peeled = views::peel(*scene, view, settings, layers);
    for (const views::Layer& layer : peeled)
      built.outside += builder.add_layer(view, layer, normals, rank);
    is_cut = is_cut || (peeled.size() == std::size_t(layers) && !views::is_empty(peeled.back()));
    ++rank;
  };
  add(chosen->view);
  for (const View& view : others) add(view);
  built.layers = {chosen->camera, settings.background, builder.pack()};
  if (is_cut)
    built.left_out.push_back(
        fmt::format("surfaces behind {}, if there are any (--layers)", counted(layers, "surface")));
  return built;
}

LayersBuildCommand::BuiltLayers LayersBuildCommand::build_by_rays(const Scene& scene,
                                                                  const Camera& camera,
                                                                  const View& view) const {
  views::RaySampling sampling = *rays_;
  sampling.half_side = cube_side(view) / 2;
  sampling.threads = threads_.value_or(1);
  BuiltLayers built;
  built.rays.emplace();
  built.layers = {camera, picture_.settings.background,
                  views::build_layers_by_rays(scene, view, picture_.settings, sampling,
                                              epsilon_.value_or(views::kMergedHits), *built.rays,
                                              wanted_attributes())};
  built.left_out.emplace_back(
      "the position of a hit inside its pixel, up to half a pixel, and all but one of the hits "
      "that\n    share a pixel and a depth (--epsilon)");
  built.left_out.emplace_back(
      "surfaces that no ray has hit, and lines and points, which no ray can hit");
  if (sampling.half_side > view.near)
    built.left_out.emplace_back("surfaces in front of the cube's front face (--cube)");
  return built;
}

Result<LayersBuildCommand::BuiltLayers> LayersBuildCommand::build_from_pictures() const {
  const auto pictures = views::read_source_pictures(*pictures_);
  if (!pictures) return tl::unexpected(pictures.error());
  const views::SourcePicture& first = pictures->front();
  views::LayerBuilder builder(views::layer_camera(first.view),
                              pictures->size() == 1 ? 0 : epsilon());
  BuiltLayers built;
  built.views = pictures->size();
  std::uint32_t rank = 0;
  for (const views::SourcePicture& picture : *pictures) {
    built.outside += builder.add_picture(picture.view, picture.color, picture.distance, rank++);
  }
  built.layers = {first.camera, picture_.settings.background, builder.pack()};
  built.left_out.emplace_back("pixels without a distance");
  return built;
}

Result<LayersBuildCommand::BuiltLayers> LayersBuildCommand::build(Progress& progress) const {
  auto built = pictures_ ? build_from_pictures() : build_from_scene(progress);
  if (built && ends_) {
    const std::size_t before = built->layers.image.samples();
    built->layers.image = views::nearest_and_farthest(built->layers.image);
    built->left_out.push_back(
        fmt::format("{} between the nearest and the farthest of their pixels (--ends)",
                    counted(before - built->layers.image.samples(), "sample")));
  }
  if (!built || built->views == 1) return built;
  built->left_out.emplace_back(
      "the position of the other views' samples inside their pixels, up to half a pixel, and the\n"
      "    second of two samples that share a pixel and a depth (--epsilon)");
  return built;
}

int LayersBuildCommand::run() {
  if (const auto good = check_sources(); !good) return refuse(good.error());
  if (const auto good = check_extension(output_, ".ldi"); !good) return refuse(good.error());
  std::vector<std::string> outputs{output_};
  if (json_output_ && *json_output_ != "-") outputs.push_back(*json_output_);
  if (const auto good = check_outputs(outputs); !good) return refuse(good.error());
  Progress progress;
  const Clock::time_point start = Clock::now();
  const auto built = build(progress);
  if (!built) return refuse(built.error());
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const std::vector<std::byte> bytes = views::encode_layers(built->layers);
  if (const auto written = write_file(output_, bytes); !written) return refuse(written.error());
  progress.done();

  const views::LayeredImage& image = built->layers.image;
  const views::LayerCounts counts = views::count_layers(image);
  if (json_output_) {
    nlohmann::ordered_json json{{"layers", output_},
                                {"width", image.camera.width},
                                {"height", image.camera.height},
                                {"views", built->views},
                                {"samples", counts.samples},
                                {"covered_pixels", counts.covered},
                                {"most_samples_of_a_pixel", counts.most},
                                {"depth_complexity", counts.complexity()},
                                {"beside", built->outside},
                                {"bytes", bytes.size()},
                                {"left_out", built->left_out},
                                {"seconds", seconds}};
    if (built->rays)
      json["rays"] = {{"cast", rays_->count()},
                      {"strata", rays_->strata},
                      {"rays_of_stratum", rays_->rays},
                      {"followed", built->rays->followed},
                      {"hits", built->rays->hits}};
    if (const auto written = write_json(*json_output_, json); !written)
      return refuse(written.error());
  }
  if (json_output_ == "-") return kSuccess;
  fmt::print("{}: {} x {} pixels, {} samples, {} bytes\n", printable(output_, kLongestMessage),
             image.camera.width, image.camera.height, counts.samples, bytes.size());
  fmt::print("  depth complexity {:.2f} over {} covered pixels, at most {}; made in {:.2f} s\n",
             counts.complexity(), counts.covered, counts.most, seconds);
  if (built->views > 1)
    fmt::print("  from {} views; {} are outside the picture of the first one\n", built->views,
               counted(built->outside, "sample"));
  if (built->rays)
    fmt::print(
        "  {} rays: {} through what the picture shows, and {} of these hit a surface there\n",
        rays_->count(), built->rays->followed, built->rays->hits);
  for (const std::string& what : built->left_out) fmt::print("  Left out: {}.\n", what);
  return kSuccess;
}

void add_layers_build_command(CLI::App& views, int& exit_code) {
  add_command<LayersBuildCommand>(views, exit_code);
}

}  // namespace glassbox::views
