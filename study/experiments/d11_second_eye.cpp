// Compares sources of a pair's second picture: drawn separately, drawn together with the first one,
// or warped from it (D-11).
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include <glassbox/compare/metrics/errors.h>
#include <glassbox/images/stored_image.h>
#include <glassbox/mesh/builtin/forest.h>
#include <glassbox/mesh/builtin/images.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/pipeline/stereo/parallax.h>
#include <glassbox/render/renderer.h>

#include "study/experiment/experiment.h"
#include "study/experiments/d11_cards.h"
#include "study/experiments/d11_pair_setup.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/memoize.h"
#include "study/experiments/warp/warp.h"

namespace glassbox::study {

namespace d11 {

using Picture = Image<Rgba8>;

struct StereoTestScene {
  std::string name;
  Scene scene;
  View centre, left, right;
  StereoPair pair;
  RenderSettings settings = {};
};

StereoTestScene make_test_scene(std::string name, Scene scene, const View& centre,
                                const StereoPair& pair) {
  StereoTestScene test_scene{.name = std::move(name),
                             .scene = std::move(scene),
                             .centre = centre,
                             .left = eye_view(centre, pair, Side::kLeft),
                             .right = eye_view(centre, pair, Side::kRight),
                             .pair = pair};
  test_scene.settings.transfer = Transfer::kNone;
  test_scene.settings.background = {0, 0, 0, 255};
  test_scene.settings.want_distance = true;
  return test_scene;
}

// ---- methods for the right eye's picture, the left one's included ----

struct RightEyePicture {
  Picture color;
  Image<float> distance;  // infinite for empty pixels
};

RightEyePicture right_eye_picture(Framebuffer&& buffers) {
  return {std::move(buffers.color), std::move(buffers.distance)};
}
RightEyePicture right_eye_picture(Warped&& warped) {
  return {std::move(warped.color), std::move(warped.distance)};
}

RightEyePicture draw_separately(const StereoTestScene& s) {
  render_staged(s.scene, s.left, s.settings);
  return right_eye_picture(render_staged(s.scene, s.right, s.settings).buffers);
}
RightEyePicture draw_together(const StereoTestScene& s) {
  return right_eye_picture(render_pair(s.scene, s.centre, s.pair, {.render = s.settings}).right);
}
RightEyePicture reuse_left_picture(const StereoTestScene& s) {
  return right_eye_picture(render_staged(s.scene, s.left, s.settings).buffers);
}
template <int layers, bool fill>
RightEyePicture warp_layers(const StereoTestScene& s) {
  Warped warped =
      warp(peel(s.scene, s.left, s.settings, layers), s.centre, s.pair, s.settings.background);
  if (fill) fill_holes(warped);
  return right_eye_picture(std::move(warped));
}
RightEyePicture draw_both_over_tiles(const StereoTestScene& s) {
  render_tiled(s.scene, s.left, s.settings, {.threads = 1});
  return right_eye_picture(render_tiled(s.scene, s.right, s.settings, {.threads = 1}).buffers);
}
RightEyePicture draw_together_over_tiles(const StereoTestScene& s) {
  Renderer renderer(s.scene, s.settings.transfer, EngineKind::kTile, {.threads = 1});
  return right_eye_picture(renderer.render_pair(s.centre, s.pair, {.render = s.settings}).right);
}

RightEyePicture warp_from_tiles(const StereoTestScene& s) {
  Framebuffer left = render_tiled(s.scene, s.left, s.settings, {.threads = 1}).buffers;
  return right_eye_picture(warp({{std::move(left.color), std::move(left.distance)}}, s.centre,
                                s.pair, s.settings.background));
}

struct Method {
  const char* name;
  int layers;  // number of layers that a warp uses; 0: no warp
  bool fill;
  bool exact;
  RightEyePicture (*right)(const StereoTestScene&);
};
constexpr Method kMethods[] = {
    {"left picture twice", 0, false, false, reuse_left_picture},
    {"two full passes", 0, false, true, draw_separately},
    {"shared vertex stage", 0, false, true, draw_together},
    {"depth-image warp", 1, false, false, warp_layers<1, false>},
    {"depth-image warp, holes filled", 1, true, false, warp_layers<1, true>},
    {"warp of 2 layers", 2, false, false, warp_layers<2, false>},
    {"warp of 2 layers, holes filled", 2, true, false, warp_layers<2, true>},
    {"warp of 3 layers", 3, false, false, warp_layers<3, false>},
    {"warp of 4 layers", 4, false, false, warp_layers<4, false>},
    {"tile engine, two complete passes", 0, false, true, draw_both_over_tiles},
    {"tile engine, shared stages", 0, false, true, draw_together_over_tiles},
    {"tile engine, depth-image warp", 1, false, false, warp_from_tiles}};

// ---- measures ----

constexpr const char* kPsnr = "PSNR";
constexpr const char* kHoles = "holes";
constexpr const char* kDisparity = "disparity";
constexpr const char* kSetup = "set-up";

struct Errors {
  double rms = 0;        // in steps of 1/255, over red, green and blue
  double holes = 0;      // fraction of pixels that are empty but should not be
  double disparity = 0;  // in px: the largest error of the parallax of visible pixels
};

// In px. Smaller differences of parallax are rounding errors: a float distance z is wrong by a few
// units in its last place, and the parallax, about 100 px/z, by less than this.
constexpr double kMinDisparity = 0x1p-12;

double parallax_px(const StereoTestScene& s, float z) {
  return parallax_at(s.centre, s.pair, double(z)).px;
}

Errors errors_of(const RightEyePicture& right, const RightEyePicture& test,
                 const StereoTestScene& test_scene) {
  const StoredImage one = as_stored(right.color), other = as_stored(test.color);
  const Selection everything(right.color.width, right.color.height);
  Errors errors;
  errors.rms = 255 * sample_errors({one, other, everything}).rmse;
  for (std::size_t i = 0; i < right.distance.pixels.size(); ++i) {
    const float z = right.distance.pixels[i], found = test.distance.pixels[i];
    if (!std::isfinite(z)) continue;
    if (!std::isfinite(found)) {
      errors.holes += 1;
      continue;
    }
    const double off = std::abs(parallax_px(test_scene, z) - parallax_px(test_scene, found));
    if (off > kMinDisparity) errors.disparity = std::max(errors.disparity, off);
  }
  errors.holes /= double(right.distance.pixels.size());
  return errors;
}

double psnr(double rms) {
  return rms == 0 ? std::numeric_limits<double>::infinity() : 20 * std::log10(255 / rms);
}

// ---- scenes, and what is to be expected on them ----

View view_of(const Camera& camera) {
  return make_view(camera, kWidth, kHeight).value();
}

StereoTestScene card_scene() {
  Camera camera;
  camera.lens = PerspectiveLens{0.785398163397448309616, 0.5, 100.0};
  const View centre = view_of(camera);
  const StereoPair pair{0.25, kWindow};
  Scene scene;
  scene.materials[add_material(scene, "cells", {1, 1, 1, 1})].unlit = true;
  Mesh mesh;
  std::uint64_t stream = 1u << 20;
  add_cells(mesh, {0, 0, kWidth, kHeight, 0}, centre, pair, stream);
  for (const Card& card : cards()) add_cells(mesh, card, centre, pair, stream += 1u << 20);
  add_object(scene, std::move(mesh));
  return make_test_scene("cards before a wall", std::move(scene), centre, pair);
}

// The mean square of uniformly random bytes in 0 .. 255, and that of the difference of two such
// bytes.
constexpr double kByteSquare = 255.0 * 511 / 6, kDifferenceSquare = (256.0 * 256 - 1) / 6;

// The predicted errors for the cards. Holes are black, or are filled with the colour of another
// cell of the wall. Without a warp, a pixel that shows another surface in the left picture has
// another cell's colour. Where the rear card of a stack should be visible, the filled hole shows
// the wall, whose parallax differs by 4 px.
Errors predicted_on_cards(const Method& method) {
  constexpr double kPixels = kWidth * kHeight;
  if (method.exact) return {};
  if (method.layers == 0)
    return {std::sqrt(moved_pixels() / kPixels * kDifferenceSquare), 0, kLargestParallax};
  const double share = hole_pixels(method.layers) / kPixels;
  if (!method.fill) return {std::sqrt(share * kByteSquare), share, 0};
  return {std::sqrt(share * kDifferenceSquare), 0, method.layers == 1 ? 4.0 : 0.0};
}

StereoTestScene forest_scene(double share) {
  Scene forest = make_forest();
  const View centre = view_of(forest.cameras.front());
  return make_test_scene("forest", std::move(forest), centre, {share * 12, 12});
}

double square_of(const Rgba8& c) {
  return double(c.r) * c.r + double(c.g) * c.g + double(c.b) * c.b;
}

// What the left eye sees, for a scene whose depths are not known by construction.
struct LeftEye {
  std::vector<Layer> layers;
  double mean_square = 0, variance = 0;  // of a byte of the picture, without empty pixels
  double opened = 0;      // columns uncovered at depth edges, as a fraction of the picture
  double parallaxes = 0;  // difference in px between the nearest surface and the farthest
};

LeftEye seen_by_left_eye(const StereoTestScene& test_scene) {
  LeftEye seen{peel(test_scene.scene, test_scene.left, test_scene.settings, 5)};
  const auto& [color, distance, depth, id] = seen.layers.front();
  double sum = 0, squares = 0, count = 0, near = HUGE_VAL, far = -HUGE_VAL;
  for (int y = 0; y < kHeight; ++y) {
    double before = 0;  // the left border uncovers columns like an edge at the window's depth
    for (int x = 0; x < kWidth; ++x) {
      const float z = distance.at(x, y);
      const double p = parallax_px(test_scene, z);  // finite for the sky, too
      if (std::isfinite(z)) {
        const Rgba8& c = color.at(x, y);
        sum += c.r + c.g + c.b, squares += square_of(c), count += 3;
        near = std::min(near, p), far = std::max(far, p);
        seen.opened += std::max(0.0, p - before) / (kWidth * kHeight);
      }
      before = p;
    }
  }
  seen.mean_square = squares / count;
  seen.variance = seen.mean_square - sum / count * (sum / count);
  seen.parallaxes = far - near;
  return seen;
}

// The fraction of a layer's pixels that have another layer behind them.
double share_behind(const LeftEye& seen, std::size_t layer) {
  if (layer + 1 >= seen.layers.size()) return 0;
  const auto covered = [&](const Layer& each) {
    return double(
        std::ranges::count_if(each.distance.pixels, [](float z) { return std::isfinite(z); }));
  };
  return covered(seen.layers[layer + 1]) / covered(seen.layers[layer]);
}

// The predicted errors for many thin objects. In the correct picture, a hole of the first layer
// shows the second or third layer. The probability of this is predicted by the fraction of the left
// picture that has such a layer. Holes are black; filled holes, and pixels that show another
// surface in the left picture, have the colour of some other place.
Errors predicted_among_trees(const Method& method, const LeftEye& seen) {
  if (method.exact) return {};
  if (method.layers == 0) return {std::sqrt(2 * seen.variance), 0, seen.parallaxes};
  // If as many pixels as there are places move to random places, 1/e of the places stay empty. So
  // the fraction of holes is not larger than that, however far things move.
  double share = std::min(seen.opened, std::exp(-1.0));
  for (int layer = 1; layer < method.layers; ++layer)
    share *= share_behind(seen, std::size_t(layer - 1));
  const double square = method.fill ? 2 * seen.variance : seen.mean_square;
  return {std::sqrt(share * square), method.fill ? 0 : share, seen.parallaxes};
}

// Measured at 2 % on the axis: 9858 pixels stay empty with one layer, 5893 with two layers, and
// 4005 with two layers and back-face culling.
const Finding kOwnBack{
    "the second layer of a tree is its own back, which no hole shows; the third layer has the "
    "objects behind the tree, and fills more holes than other layers",
    0.25, 0.5};

const Finding kStillTheSame{
    "with parallaxes of a few px, less than the width of a tree, most pixels still show the same "
    "object",
    0.25, 0.5};

const Finding kWrongThing{
    "where layers leave few holes, the remaining errors are pixels that show something farther "
    "away, because no layer has the surface that belongs there",
    2, 3};

using Prediction = std::function<Errors(const Method&)>;

void add_scene(const std::shared_ptr<const StereoTestScene>& test_scene,
               const Prediction& prediction, std::vector<Configuration>& all) {
  const auto right = memoize([=] {
    return right_eye_picture(
        render_staged(test_scene->scene, test_scene->right, test_scene->settings).buffers);
  });
  const double parameter = 100 * test_scene->pair.half_separation / test_scene->pair.window;
  for (const Method& method : kMethods) {
    const auto errors =
        memoize([=] { return errors_of(right(), method.right(*test_scene), *test_scene); });
    const Errors predicted = prediction(method);
    const auto add = [&](const char* measure, double expected, auto error) {
      all.push_back({.series = method.name,
                     .parameter = parameter,
                     .scene = test_scene->name,
                     .measure = measure,
                     .error = [=] { return error(errors()); },
                     .predicted_error = expected});
    };
    add("", predicted.rms, [](const Errors& e) { return e.rms; });
    if (method.layers == 0) all.back().finding = kStillTheSame;
    if (method.layers >= 3) all.back().finding = kWrongThing;
    all.back().work = [method, test_scene](int) { method.right(*test_scene); };
    add(kPsnr, psnr(predicted.rms), [](const Errors& e) { return psnr(e.rms); });
    add(kHoles, predicted.holes, [](const Errors& e) { return e.holes; });
    if (method.layers >= 3) all.back().finding = kOwnBack;
    add(kDisparity, predicted.disparity, [](const Errors& e) { return e.disparity; });
  }
}

void add_setups(const StereoTestScene& test_scene, std::vector<Configuration>& all) {
  const auto triangles = std::make_shared<const std::vector<PairTriangle>>(
      pair_triangles(*d10::make_eyes(test_scene.scene, test_scene.centre, test_scene.pair)));
  const auto add = [&](const char* series, auto set_up) {
    all.push_back({.series = series,
                   .parameter = double(triangles->size()),
                   .scene = test_scene.name,
                   .measure = kSetup,
                   .error =
                       [=] {
                         return double(std::ranges::count_if(*triangles, [&](const auto& t) {
                           const auto one = set_up_each(t), other = set_up(t);
                           return !are_same(one[0], other[0]) || !are_same(one[1], other[1]);
                         }));
                       },
                   .predicted_error = 0,
                   .work =
                       [=](int) {
                         for (const PairTriangle& t : *triangles) do_not_optimize(set_up(t));
                       }});
  };
  add("set-up of each eye", set_up_each);
  add("shared y-setup", set_up_shared);
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  add_scene(std::make_shared<const StereoTestScene>(card_scene()), predicted_on_cards, all);
  std::vector<double> shares{0.02};
  if (effort == Effort::kFull) shares = {0.005, 0.01, 0.02, 0.05};
  for (const double share : shares) {
    const auto forest = std::make_shared<const StereoTestScene>(forest_scene(share));
    const LeftEye seen = seen_by_left_eye(*forest);
    const auto predicted = [seen](const Method& method) {
      return predicted_among_trees(method, seen);
    };
    add_scene(forest, predicted, all);
  }
  add_setups(forest_scene(0.02), all);
  return all;
}

}  // namespace d11

Experiment d11_second_eye() {
  using namespace d11;
  return {
      .id = "D-11",
      .name = "The second eye: drawn or warped",
      .question =
          "How much of the second picture's time can be saved, and how much does the picture then "
          "differ?",
      .axis = "half the separation of the eyes over the distance of the window",
      .axis_unit = "%",
      .error = "RMS difference of the right eye's picture",
      .error_unit = "1/255",
      .reference = "the right eye's picture, drawn by itself",
      .theory =
          "Shared stages give the same bytes, so the difference is 0. A warp lacks (W/2)(d/h) B "
          "(1/z_front - 1/z_back) columns beside every edge in depth (B.9 in docs/references.md). "
          "In the picture of cards these columns are a share of the pixels. They are black, which "
          "gives the difference sqrt(share 255 511/6), or filled with the colours of another cell, "
          "which gives sqrt(share (256^2 - 1)/6). Two layers contain the first object behind every "
          "edge, and three the next one, which is enough for the cards. A pixel that shows a wrong "
          "place differs by sqrt(2) times the picture's standard deviation, and its parallax is "
          "wrong by at most the largest parallax. Between the forest's trees, most of what comes "
          "into view is behind two surfaces or more.",
      .item = "pair of pictures",
      .measures = {{.name = kPsnr,
                    .error = "peak signal-to-noise ratio of the right eye's picture",
                    .error_unit = "dB",
                    .more_is_better = true},
                   {kHoles, "pixels that show nothing where a surface is, over all pixels", ""},
                   {kDisparity, "largest error of the parallax of what a pixel shows", "px"},
                   {kSetup,
                    "triangles whose set-up for an eye differs from the set-up for this eye alone",
                    "triangles", "triangles that are completely inside both pictures"}},
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
