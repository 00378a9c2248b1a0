#include "views/commands/geometry.h"

#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/arguments.h"
#include "cli/options/choices.h"
#include "cli/options/scene_input.h"

#include <glassbox/base/trig.h>
#include <glassbox/pipeline/stereo/constructions.h>

namespace glassbox::views {

namespace {

constexpr const char* kGroup = "Pair of a scene";

void add_triple(CLI::App& command, const std::string& name,
                std::optional<std::array<double, 3>>& value, const std::string& type,
                const std::string& help) {
  command
      .add_option_function<std::string>(
          name, [&value, name](const std::string& text) { value = parse_numbers<3>(name, text); },
          help)
      ->type_name(type)
      ->group(kGroup);
}

void add_real(CLI::App& command, const std::string& name, double& value, const std::string& type,
              const std::string& help) {
  command
      .add_option_function<std::string>(
          name, [&value, name](const std::string& text) { value = parse_number(name, text); }, help)
      ->type_name(type)
      ->group(kGroup);
}

using Rotation = glm::dmat3;

// The rotation by an angle that turns the first of two axes towards the second. glm stores columns.
Rotation rotation_in_plane(int first, int second, double degrees) {
  const SinCos angle = sin_cos_degrees(degrees);
  Rotation turned(1.0);
  turned[first][first] = turned[second][second] = angle.cos;
  turned[first][second] = angle.sin;
  turned[second][first] = -angle.sin;
  return turned;
}

// The camera of `view`, moved and turned. In eye space x is right, y is up, and the direction of
// view is -z.
View moved_view(const View& view, const std::array<double, 3>& move,
                const std::array<double, 3>& turn) {
  constexpr int kX = 0, kY = 1, kZ = 2;
  // A turn to the right is from -z to x, a turn up from -z to y, and a clockwise turn from y to x.
  const Rotation own = rotation_in_plane(kX, kZ, turn[0]) * rotation_in_plane(kY, kZ, turn[1]) *
                       rotation_in_plane(kY, kX, turn[2]);
  const Rotation back = glm::transpose(own);
  glm::dmat4 step(back);
  step[3] = glm::dvec4(back * -glm::dvec3(move[0], move[1], -move[2]), 1);
  View other = view;
  other.eye_from_world = Transform<Eye, World>(step * view.eye_from_world.columns);
  return other;
}

struct ViewPair {
  View left, right;
  std::string description;
};

Result<ViewPair> arbitrary_pair(const GeometryScene& scene, const Scene& loaded) {
  const auto chosen = choose_view(loaded, scene.picture);
  if (!chosen) return tl::unexpected(chosen.error());
  const std::array<double, 3> none{};
  const auto move = scene.move.value_or(none), turn = scene.turn.value_or(none);
  return ViewPair{chosen->view, moved_view(chosen->view, move, turn),
                  fmt::format("arbitrary: the second camera {:g} to the right, {:g} up, {:g} "
                              "forward, turned by {:g} to the right, {:g} up, {:g} deg clockwise",
                              move[0], move[1], move[2], turn[0], turn[1], turn[2])};
}

Result<ViewPair> pair_of(const GeometryScene& scene, const Scene& loaded) {
  if (scene.chosen() == Arrangement::kArbitrary) return arbitrary_pair(scene, loaded);
  const auto chosen = choose_eyes(loaded, scene.picture);
  if (!chosen) return tl::unexpected(chosen.error());
  const StereoPair& eyes = chosen->eyes.pair;
  const std::string apart = fmt::format("eyes {:.6g} apart ({})", 2 * eyes.half_separation,
                                        chosen->eyes.separation_is_from);
  if (scene.chosen() == Arrangement::kParallel) {
    return ViewPair{eye_view(chosen->centre, eyes, Side::kLeft),
                    eye_view(chosen->centre, eyes, Side::kRight), apart + ", axes parallel"};
  }
  if (std::isinf(eyes.window)) {
    return fail("--window", "converging axes meet at a finite distance", "give that distance");
  }
  return ViewPair{toe_in_view(chosen->centre, eyes, Side::kLeft),
                  toe_in_view(chosen->centre, eyes, Side::kRight),
                  fmt::format("{}, axes converging at {:.6g} ({})", apart, eyes.window,
                              chosen->eyes.window_is_at)};
}

PixelVisibility pixel_visibility(const Image<views::TrueMatch>& truth) {
  PixelVisibility visibility;
  for (const views::TrueMatch& match : truth.pixels) {
    switch (match.visibility) {
      case OtherEyeVisibility::kNothingDrawn:
        ++visibility.nothing;
        break;
      case OtherEyeVisibility::kVisible:
        ++visibility.seen;
        break;
      case OtherEyeVisibility::kOutsidePicture:
        ++visibility.outside;
        break;
      case OtherEyeVisibility::kHidden:
        ++visibility.hidden;
        break;
      case OtherEyeVisibility::kMissing:
        ++visibility.missing;
        break;
    }
  }
  return visibility;
}

}  // namespace

const char* name_of(Arrangement arrangement) {
  switch (arrangement) {
    case Arrangement::kParallel:
      return "parallel";
    case Arrangement::kConverging:
      return "converging";
    case Arrangement::kArbitrary:
      break;
  }
  return "arbitrary";
}

Arrangement GeometryScene::chosen() const {
  return arrangement.value_or(move || turn ? Arrangement::kArbitrary : Arrangement::kParallel);
}

void add_geometry_scene_options(CLI::App& command, GeometryScene& scene) {
  const std::size_t before = command.get_options().size();
  command.add_option("--scene", scene.scene, "draw the pair: " + std::string(kSceneHelp))
      ->type_name("SCENE")
      ->group(kGroup);
  add_choice<std::optional<Arrangement>>(
      command, "--arrangement", scene.arrangement,
      choices_of({Arrangement::kParallel, Arrangement::kConverging, Arrangement::kArbitrary}),
      "arrangement of the cameras: eyes with parallel axes, eyes whose axes meet at the window, or "
      "the camera and an arbitrary second one [parallel; with --move or --turn arbitrary]")
      ->group(kGroup);
  add_triple(
      command, "--move", scene.move, "R,U,F",
      "position of the second camera: right, up, forward of the first one (world units) [0,0,0]");
  add_triple(command, "--turn", scene.turn, "R,U,C",
             "rotation of the second camera: right, up, clockwise (degrees) [0,0,0]");
  add_real(command, "--noise", scene.sampling.noise, "PX",
           "standard deviation of each coordinate of a match (px) [0]");
  add_real(
      command, "--outliers", scene.sampling.outliers, "SHARE",
      "share of wrong matches, whose point in the right picture is random, 0 <= SHARE < 1 [0]");
  command
      .add_option("--count", scene.sampling.count,
                  fmt::format("largest number of matches [{}]", scene.sampling.count))
      ->type_name("N")
      ->group(kGroup);
  const auto all = command.get_options();
  scene.options.assign(all.begin() + std::ptrdiff_t(before), all.end());
  add_picture_options(command, scene.picture);
}

Result<void> check_geometry_scene(const GeometryScene& scene) {
  const auto& [count, noise, outliers, seed] = scene.sampling;
  constexpr int kMaxMatches = 100'000;
  constexpr double kMaxNoise = 1000;
  if (!(noise >= 0 && noise <= kMaxNoise)) {
    return fail("--noise", fmt::format("{:g} px is not possible as a standard deviation", noise),
                fmt::format("give 0 to {:g}", kMaxNoise));
  }
  if (!(outliers >= 0 && outliers < 1)) {
    return fail("--outliers", fmt::format("{:g} is not a share from 0 to below 1", outliers),
                "give 0 <= SHARE < 1, such as 0.3");
  }
  if (count < 8 || count > kMaxMatches) {
    return fail("--count",
                fmt::format("{} matches are {}", count, count < 8 ? "too few" : "too many"),
                fmt::format("give 8 to {}", kMaxMatches));
  }
  if (scene.picture.eyes.seen_by) {
    return fail("--seen-by", "the geometry is computed from both pictures", "leave it out");
  }
  const bool is_arbitrary = scene.chosen() == Arrangement::kArbitrary;
  if (!is_arbitrary && (scene.move || scene.turn)) {
    return fail(
        scene.move ? "--move" : "--turn",
        fmt::format("with --arrangement {}, --eye-separation and --window place the cameras",
                    name_of(scene.chosen())),
        "leave this option out, or give --arrangement arbitrary");
  }
  if (is_arbitrary && !scene.move && !scene.turn) {
    return fail("--arrangement", "the position of the second camera is not given",
                "give --move or --turn");
  }
  const EyesOptions& eyes = scene.picture.eyes;
  if (is_arbitrary && (eyes.separation || eyes.window)) {
    return fail(eyes.separation ? "--eye-separation" : "--window",
                "with --arrangement arbitrary, --move and --turn place the cameras",
                "leave it out");
  }
  if (is_arbitrary && scene.turn) {
    for (const double degrees : *scene.turn) {
      constexpr double kMaxTurnDegrees = 360;
      if (!(std::abs(degrees) <= kMaxTurnDegrees))
        return fail("--turn", fmt::format("{:g} degrees is more than a full turn", degrees),
                    "give -360 to 360");
    }
  }
  return {};
}

Result<SceneGeometry> draw_geometry_scene(const GeometryScene& scene, Progress& progress) {
  const Result<Scene> loaded = load_scene_argument(*scene.scene, scene.picture, progress);
  if (!loaded) return tl::unexpected(loaded.error());
  progress.phase("rendering " + scene_title(*scene.scene));
  const auto pair = pair_of(scene, *loaded);
  if (!pair) return tl::unexpected(pair.error());
  auto left = views::known_picture(*loaded, pair->left, scene.picture.settings);
  if (!left) return tl::unexpected(left.error());
  auto right = views::known_picture(*loaded, pair->right, scene.picture.settings);
  if (!right) return tl::unexpected(right.error());

  progress.phase("matching");
  const Image<views::TrueMatch> truth = views::true_matches(*left, *right);
  SceneGeometry made;
  GeometryInput& input = made.input;
  input.visibility = pixel_visibility(truth);
  if (input.visibility->seen < 8) {
    return fail("--scene",
                fmt::format("the right picture shows {} of the left one's points, but 8 are needed",
                            input.visibility->seen),
                "move the cameras closer together, or make the pictures larger");
  }
  auto sampled = views::sample_matches(truth, right->distance, scene.sampling);
  input.description =
      fmt::format("{}, {} x {}", scene_title(*scene.scene), truth.width, truth.height);
  input.pair_description = pair->description;
  input.matches = std::move(sampled.matches);
  input.is_outlier = std::move(sampled.is_outlier);
  input.intrinsics = {left->camera.intrinsic, right->camera.intrinsic};
  input.truth = views::relative_pose(left->camera, right->camera);
  made.cameras = {left->camera, right->camera};
  input.pictures = {std::move(left->color), std::move(right->color)};
  return made;
}

}  // namespace glassbox::views
