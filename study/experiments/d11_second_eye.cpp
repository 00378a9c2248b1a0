// D-11: where a pair's second picture comes from: drawn, drawn together with the first, or warped from it.
#include <algorithm>
#include <cmath>
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
#include "study/experiments/warp/depth_peeling.h"
#include "study/experiments/warp/warp.h"

namespace glassbox::study {

namespace {

using namespace d11;

using Picture = Image<Rgba8>;

struct Stage {
  std::string name;
  Scene scene;
  View centre, left, right;
  StereoPair pair;
  RenderSettings settings = {};
};

Stage make_stage(std::string name, Scene scene, const View& centre, const StereoPair& pair) {
  Stage stage{.name = std::move(name),
              .scene = std::move(scene),
              .centre = centre,
              .left = eye_view(centre, pair, Side::kLeft),
              .right = eye_view(centre, pair, Side::kRight),
              .pair = pair};
  stage.settings.transfer = Transfer::kNone;
  stage.settings.background = {0, 0, 0, 255};
  stage.settings.want_distance = true;
  return stage;
}

// ---- ways to the right eye's picture, the left one's included ----

Picture draw_again(const Stage& s) {
  render_staged(s.scene, s.left, s.settings);
  return render_staged(s.scene, s.right, s.settings).buffers.color;
}
Picture draw_together(const Stage& s) {
  return render_pair(s.scene, s.centre, s.pair, {.render = s.settings}).right.color;
}
Picture take_the_left_one(const Stage& s) {
  return render_staged(s.scene, s.left, s.settings).buffers.color;
}
template <int layers, bool fill>
Picture warp_layers(const Stage& s) {
  Warped warped =
      warp(peel(s.scene, s.left, s.settings, layers), s.centre, s.pair, s.settings.background);
  if (fill) fill_holes(warped);
  return std::move(warped.color);
}
Picture draw_both_over_tiles(const Stage& s) {
  render_tiled(s.scene, s.left, s.settings, {.threads = 1});
  return render_tiled(s.scene, s.right, s.settings, {.threads = 1}).buffers.color;
}
Picture draw_together_over_tiles(const Stage& s) {
  Renderer renderer(s.scene, s.settings.transfer, EngineKind::kTile, {.threads = 1});
  return renderer.render_pair(s.centre, s.pair, {.render = s.settings}).right.color;
}

Picture warp_from_tiles(const Stage& s) {
  Framebuffer left = render_tiled(s.scene, s.left, s.settings, {.threads = 1}).buffers;
  return warp({{std::move(left.color), std::move(left.distance)}}, s.centre, s.pair,
              s.settings.background)
      .color;
}

struct Way {
  const char* name;
  int layers;  // that a warp has to take from; 0: no warp
  bool fill;
  bool exact;
  Picture (*right)(const Stage&);
};
constexpr Way kWays[] = {{"left picture twice", 0, false, false, take_the_left_one},
                         {"two full passes", 0, false, true, draw_again},
                         {"shared vertex stage", 0, false, true, draw_together},
                         {"depth-image warp", 1, false, false, warp_layers<1, false>},
                         {"depth-image warp, holes filled", 1, true, false, warp_layers<1, true>},
                         {"warp of 2 layers", 2, false, false, warp_layers<2, false>},
                         {"warp of 2 layers, holes filled", 2, true, false, warp_layers<2, true>},
                         {"warp of 3 layers", 3, false, false, warp_layers<3, false>},
                         {"warp of 4 layers", 4, false, false, warp_layers<4, false>},
                         {"tile engine, two full passes", 0, false, true, draw_both_over_tiles},
                         {"tile engine, shared stages", 0, false, true, draw_together_over_tiles},
                         {"tile engine, depth-image warp", 1, false, false, warp_from_tiles}};

// In steps of 1/255, over red, green and blue.
double rms_difference(const Picture& reference, const Picture& test) {
  const StoredImage one = as_stored(reference), other = as_stored(test);
  const Selection everything(reference.width, reference.height);
  return 255 * sample_errors({one, other, everything}).rmse;
}

double error_of(const Way& way, const Stage& stage) {
  return rms_difference(render_staged(stage.scene, stage.right, stage.settings).buffers.color,
                        way.right(stage));
}

View view_of(const Camera& camera) {
  return make_view(camera, kWidth, kHeight).value();
}

Stage card_stage() {
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
  return make_stage("cards before a wall", std::move(scene), centre, pair);
}

// Bytes drawn evenly from 0 .. 255: the mean square of one is 255 * 511/6, of the difference of two (256^2 - 1)/6. Holes are
// black, or have the colour of another cell of the wall.
std::optional<double> predicted_on_cards(const Way& way) {
  if (way.exact) return 0;
  if (way.layers == 0) return std::nullopt;
  const double share = hole_pixels(way.layers) / (kWidth * kHeight);
  return std::sqrt(share * (way.fill ? (256.0 * 256 - 1) / 6 : 255.0 * 511 / 6));
}

Stage forest_stage(double share) {
  Scene forest = make_forest();
  const View centre = view_of(forest.cameras.front());
  return make_stage("forest", std::move(forest), centre, {share * 12, 12});
}

void add_stage(const std::shared_ptr<const Stage>& stage, bool cards,
               std::vector<Configuration>& all) {
  for (const Way& way : kWays) {
    all.push_back({.series = way.name,
                   .parameter = 100 * stage->pair.half_separation / stage->pair.window,
                   .scene = stage->name,
                   .error = [way, stage] { return error_of(way, *stage); },
                   .predicted_error = cards       ? predicted_on_cards(way)
                                      : way.exact ? std::optional<double>(0)
                                                  : std::nullopt,
                   .work = [way, stage](int) { way.right(*stage); }});
  }
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  add_stage(std::make_shared<const Stage>(card_stage()), true, all);
  std::vector<double> shares{0.02};
  if (effort == Effort::kFull) shares = {0.005, 0.01, 0.02, 0.05};
  for (const double share : shares)
    add_stage(std::make_shared<const Stage>(forest_stage(share)), false, all);
  return all;
}

}  // namespace

Experiment d11_second_eye() {
  return {
      .id = "D-11",
      .name = "The second eye: drawn or warped",
      .question =
          "How much of the second picture's time can be saved, and what does it look like then?",
      .axis = "half the separation of the eyes over the distance of the window",
      .axis_unit = "%",
      .error = "RMS difference of the right eye's picture",
      .error_unit = "1/255",
      .reference = "the right eye's picture, drawn by itself",
      .theory =
          "Shared stages are the same bytes: 0. A warp lacks (W/2)(d/h) B (1/z_front - 1/z_back) "
          "columns beside every edge in depth (B.9): over the cards' rows that is a share of the "
          "picture, whose colours are black or, filled, another cell's: sqrt(share 255 511/6), "
          "sqrt(share (256^2 - 1)/6). Two layers have the first thing behind every edge, three the "
          "next: enough for cards; between the forest's trees most of what comes into view lies "
          "behind two surfaces or more.",
      .item = "pair of pictures",
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
