#include "views/commands/match_input.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/options/scene_input.h"
#include "views/commands/geometry.h"
#include "views/commands/opaque_picture.h"
#include "views/commands/rectified_pair.h"
#include "views/matching/rendered_pair.h"

#include <glassbox/images/stored_image.h>

namespace glassbox::views {

namespace {

Result<Image<float>> read_truth(const std::string& path, double scale, const Image<Rgba8>& left) {
  const auto stored = read_stored(path);
  if (!stored) return tl::unexpected(stored.error());
  if (stored->width != left.width || stored->height != left.height) {
    return tl::unexpected(Error{path, "",
                                fmt::format("is {} x {}, but the pictures are {} x {}",
                                            stored->width, stored->height, left.width, left.height),
                                "give the truth of this pair"});
  }
  Image<float> values(stored->width, stored->height);
  std::visit(
      [&](const auto& samples) {
        for (std::size_t i = 0; i < values.pixels.size(); ++i) {
          values.pixels[i] = float(samples[i * std::size_t(stored->channels)]);
        }
      },
      stored->samples);
  return views::known_disparities(std::move(values), float(scale));
}

// Replaces the pictures by those that the cameras would have taken if their axes were parallel.
Result<void> rectify_input(const MatchSources& sources, MatchInput& input) {
  if (input.left.width != input.right.width || input.left.height != input.right.height) {
    return {};  // the matcher reports this error
  }
  const auto cameras =
      read_pair_cameras({{*sources.left, *sources.right}, std::nullopt, sources.cameras});
  if (!cameras) return tl::unexpected(cameras.error());
  const auto& [left, right] = *cameras;
  auto pair = rectify(input.left, input.right,
                      {left.intrinsic, right.intrinsic, views::relative_pose(left, right)});
  if (!pair) {
    Error error = pair.error();
    error.file = *sources.cameras;
    return tl::unexpected(error);
  }
  input.left = std::move(pair->left);
  input.right = std::move(pair->right);
  input.rectification = pair->rectification;
  const views::Matrix3d& k = pair->rectification.intrinsic;
  input.calibration = views::Calibration{k(0, 0), pair->rectification.baseline, 0,
                                         views::Principal{k(0, 2), k(1, 2)}};
  return {};
}

Result<MatchInput> read_files(const MatchSources& sources) {
  MatchInput input;
  auto left = read_opaque(*sources.left);
  if (!left) return tl::unexpected(left.error());
  auto right = read_opaque(*sources.right);
  if (!right) return tl::unexpected(right.error());
  input.description =
      fmt::format("{} and {}, {} x {}", *sources.left, *sources.right, left->width, left->height);
  const double scale = sources.truth_scale.value_or(1);
  if (sources.truth) {
    auto truth = read_truth(*sources.truth, scale, *left);
    if (!truth) return tl::unexpected(truth.error());
    input.truth = views::StereoTruth{*truth, views::visible_by_reprojection(*truth)};
    input.visible_by =
        "from the left truth: if it maps two pixels to one of the right picture, only the nearer "
        "one counts as visible";
    if (sources.truth_right) {
      const auto other = read_truth(*sources.truth_right, scale, *left);
      if (!other) return tl::unexpected(other.error());
      input.truth->is_visible = views::visible_by_right_truth(*truth, *other);
      input.visible_by = "a pixel counts as visible where both truths agree to within a pixel";
    }
  }
  input.left = std::move(*left);
  input.right = std::move(*right);
  if (sources.cameras) {
    if (const auto turned = rectify_input(sources, input); !turned) {
      return tl::unexpected(turned.error());
    }
  }
  return input;
}

Result<MatchInput> draw_scene(const MatchSources& sources, Progress& progress) {
  const Result<Scene> scene = load_scene_argument(*sources.scene, sources.picture, progress);
  if (!scene) return tl::unexpected(scene.error());
  progress.phase("rendering " + scene_title(*sources.scene));
  const auto chosen = choose_eyes(*scene, sources.picture);
  if (!chosen) return tl::unexpected(chosen.error());
  auto pair =
      views::rendered_pair(*scene, chosen->centre, chosen->eyes.pair, sources.picture.settings);
  if (!pair) return tl::unexpected(pair.error());
  MatchInput input;
  input.description = fmt::format(
      "{}, {} x {}, eyes {:.6g} apart ({})", scene_title(*sources.scene), pair->left.width,
      pair->left.height, 2 * chosen->eyes.pair.half_separation, chosen->eyes.separation_is_from);
  input.left = std::move(pair->left);
  input.right = std::move(pair->right);
  input.truth = std::move(pair->truth);
  input.is_textured = std::move(pair->is_textured);
  // If both eyes are at the same position, depth cannot be computed.
  if (views::check_calibration(pair->calibration)) input.calibration = pair->calibration;
  input.visible_by = "a pixel counts as visible if the distances of the right picture agree";
  return input;
}

}  // namespace

Result<MatchInput> read_match_input(const MatchSources& sources, Progress& progress) {
  if (sources.scene) return draw_scene(sources, progress);
  progress.phase("reading the pair");
  return read_files(sources);
}

views::DisparityRange range_of(const views::StereoTruth& truth) {
  float least = 0, greatest = 0;
  bool any = false;
  for (const float disparity : truth.disparity.pixels) {
    if (!std::isfinite(disparity)) continue;
    least = any ? std::min(least, disparity) : disparity;
    greatest = any ? std::max(greatest, disparity) : disparity;
    any = true;
  }
  if (!any) return {};
  constexpr float kFarthest = 16000;  // px
  return {int(std::floor(std::clamp(least, -kFarthest, kFarthest))) - 1,
          int(std::ceil(std::clamp(greatest, -kFarthest, kFarthest))) + 1};
}

}  // namespace glassbox::views
