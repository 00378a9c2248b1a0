// The variants of drawing a scene, and the measurements of them.
#include <tests/support/catch.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>

#include "study/curve/curve.h"
#include "study/curve/renderer_cache.h"

namespace glassbox::study {
namespace {

Scene scene_of(const char* name) {
  const auto scene = make_builtin(name);
  REQUIRE(scene);
  return *scene;
}

// The whole scene, framed in 64 x 48 pixels.
ViewOf view_of(const Scene& scene) {
  return [&scene](const RenderSettings& settings, int factor) {
    const auto range = settings.depth == DepthFormat::kFloat32Reversed ? DepthRange::kReversed
                                                                       : DepthRange::kStandard;
    return make_view(
        scene.cameras.empty() ? *framing_camera(scene, 4.0 / 3) : scene.cameras.front(),
        64 * factor, 48 * factor, range);
  };
}

CurveRequest request_of(const Scene& scene) {
  CurveRequest request;
  request.scene = &scene;
  request.view = view_of(scene);
  request.variants.threads = 2;
  request.repetitions = 1;
  return request;
}

std::set<std::string> names_of(const std::vector<RenderVariant>& variants) {
  std::set<std::string> names;
  for (const RenderVariant& variant : variants) names.insert(name_of(variant));
  return names;
}

const CurvePoint& point(const Curve& curve, const std::string& name) {
  const auto found = std::ranges::find_if(
      curve.points, [&](const CurvePoint& each) { return name_of(each.variant) == name; });
  REQUIRE(found != curve.points.end());
  return *found;
}

TEST_CASE("pictures that would not fit are refused before any is drawn") {
  const Scene scene = scene_of("checker");
  CurveRequest request = request_of(scene);
  const std::size_t variants = single_knob_variants(scene, request.variants).all.size();
  const double bytes = 64 * 48 * 4;
  request.combine = false;
  request.most_bytes = bytes * double(variants) - 1;
  request.phase = [](const std::string& what) { FAIL(what); };
  const auto refused = measure_curve(request);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().place == std::to_string(variants) + " pictures");
}

TEST_CASE("without a page pictures are told apart by their packed bytes, and none is kept") {
  const Scene scene = scene_of("teapot");
  CurveRequest request = request_of(scene);
  request.combine = false;
  const auto kept = measure_curve(request);
  request.keep_pictures = false;
  request.most_bytes = 0;
  const auto packed = measure_curve(request);
  REQUIRE(kept);
  REQUIRE(packed);
  CHECK(packed->pictures.empty());
  CHECK(kept->pictures.size() == kept->different);
  CHECK(packed->different == kept->different);
  REQUIRE(packed->points.size() == kept->points.size());
  for (std::size_t i = 0; i < kept->points.size(); ++i) {
    CAPTURE(name_of(kept->points[i].variant));
    CHECK(packed->points[i].picture == kept->points[i].picture);
    CHECK(packed->points[i].error.rms == kept->points[i].error.rms);
  }
}

TEST_CASE("each knob is turned alone to all that it has but what is asked for") {
  const Scene room = scene_of("room");
  const RenderVariants variants = single_knob_variants(room, {.threads = 4});
  CHECK(variants.all.front().knob == Knob::kNone);
  const std::set<std::string> names = names_of(variants.all);
  CHECK(names.size() == variants.all.size());  // no name occurs twice
  for (const char* name :
       {"as asked", "--shade unlit", "--shade flat", "--shade gouraud", "--filter nearest",
        "--filter bilinear", "--filter bilinear-levels", "--samples 2", "--samples 16",
        "--depth d32r", "--depth d24", "--depth d16", "--no-plan", "--engine staged",
        "--cull-stage object", "--threads 2", "--threads 4"}) {
    INFO(name);
    CHECK(names.contains(name));
  }
  CHECK_FALSE(names.contains("--shade phong"));
  CHECK_FALSE(names.contains("--filter trilinear"));  // the samplers' own filter
}

TEST_CASE(
    "what is held is not turned, and what a scene does not have is left out, with the reason") {
  const Scene teapot = scene_of("teapot:2"), room = scene_of("room");
  const auto why = [](const RenderVariants& variants, Knob knob) {
    for (const SkippedKnob& each : variants.skipped) {
      if (each.knob == knob) return each.why;
    }
    return std::string();
  };
  const RenderVariants of_teapot = single_knob_variants(teapot, {.levels = {1, 4}});
  CHECK(why(of_teapot, Knob::kFilter) == "the scene has no texture");
  CHECK(names_of(of_teapot.all).contains("level 4"));
  const RenderVariants held =
      single_knob_variants(room, {.fixed_knobs = {Knob::kShading, Knob::kFilter, Knob::kSamples}});
  for (const Knob knob : {Knob::kShading, Knob::kFilter, Knob::kSamples}) {
    CHECK(why(held, knob) == "you gave this option's value");
    CHECK(std::ranges::none_of(held.all,
                               [&](const RenderVariant& variant) { return variant.knob == knob; }));
  }
  CHECK(why(held, Knob::kLevel) == "the scene has only one level of detail");
}

TEST_CASE("shading, filter and samples are combined, each with each, and nothing else") {
  const Scene room = scene_of("room");
  const RenderVariants variants = single_knob_variants(room, {});
  std::map<Knob, std::size_t> turns;
  for (const RenderVariant& variant : variants.all) ++turns[variant.knob];
  const std::vector<RenderVariant> combined = combined_variants(variants.all);
  const std::size_t a = turns[Knob::kShading], b = turns[Knob::kFilter], c = turns[Knob::kSamples];
  CHECK(combined.size() == a * b + b * c + a * c + a * b * c);
  CHECK(names_of(combined).size() == combined.size());
  for (const RenderVariant& variant : combined) {
    INFO(name_of(variant));
    CHECK(variant.knob == Knob::kSeveral);
    // Each option has the value of the setting.
    for (std::size_t i = 0; i < variant.options.size(); i += 2) {
      const std::string& option = variant.options[i];
      CHECK((option == "--shade" || option == "--filter" || option == "--samples"));
      if (option == "--samples")
        CHECK(std::stoi(variant.options[i + 1]) == variant.settings.samples);
      if (option == "--filter") CHECK(variant.options[i + 1] == name_of(*variant.filter));
    }
  }
}

TEST_CASE("errors of a picture: root mean square, largest, share of wrong pixels, FLIP") {
  Image<Rgba8> right(10, 10, {100, 100, 100, 255}), wrong = right;
  CHECK(picture_error(right, right).rms == 0);
  CHECK(picture_error(right, right).flip == 0);
  wrong.at(3, 4) = {100, 109, 100, 255};  // wrong
  wrong.at(5, 5) = {92, 100, 100, 255};   // hardly visible
  const PictureError error = picture_error(wrong, right);
  CHECK(error.largest == 9);
  CHECK(error.wrong == 0.01);
  // sqrt((81 + 64) / 300) / 255, with a rounding of double for each operation.
  CHECK(error.rms == Approx(std::sqrt(145.0 / 300) / 255).epsilon(1e-14));
  CHECK(error.flip > 0);
  CHECK(error.flip < 0.01);  // one and a half pixels of a hundred, which are hardly visible
}

TEST_CASE("a curve: more samples err less, the engine changes no byte, and all is timed") {
  const Scene checker = scene_of("checker");
  CurveRequest request = request_of(checker);
  request.combine = false;
  const auto curve = measure_curve(request);
  REQUIRE(curve);
  CHECK(curve->faults.empty());
  CHECK(curve->vertices > 0);
  // Half a step of snapping in x and y and some roundings of float: less than a hundredth of a
  // pixel.
  CHECK(curve->position_error > 0);
  CHECK(curve->position_error < 0.01);
  const CurvePoint& base = curve->points.front();
  for (const CurvePoint& each : curve->points) {
    INFO(name_of(each.variant));
    REQUIRE(each.picture < curve->pictures.size());
    CHECK(each.ns.lower <= each.ns.median);
    CHECK(each.ns.median > 0);
    CHECK(each.standing.has_value() == (each.variant.tile.threads == 1));
    if (each.variant.knob == Knob::kEngine) CHECK(each.picture == base.picture);
    // Each point has the error of its picture.
    CHECK(each.error.rms == picture_error(curve->pictures[each.picture], curve->reference).rms);
  }
  CHECK(point(*curve, "--samples 16").error.rms < base.error.rms);
  CHECK(point(*curve, "--filter nearest").error.rms > base.error.rms);
  // The eye's distance is of the order of the planes' distances, so unorm16 errs thousands of times
  // as much as a reversed float (B.3).
  CHECK(point(*curve, "--depth d16").depth_error > 100 * point(*curve, "--depth d32r").depth_error);
  std::set<std::size_t> different;
  for (const CurvePoint& each : curve->points) different.insert(each.picture);
  CHECK(different.size() == curve->pictures.size());
}

TEST_CASE("a curve has the pictures that render makes") {
  const Scene room = scene_of("room");
  const CurveRequest request = request_of(room);
  const auto curve = measure_curve(request);
  REQUIRE(curve);
  for (const CurvePoint& each : curve->points) {
    if (each.variant.knob != Knob::kSeveral) continue;
    INFO(name_of(each.variant));
    const Scene scene = each.variant.filter ? with_filter(room, *each.variant.filter) : room;
    Renderer renderer(scene, each.variant.settings.transfer, EngineKind::kStaged);
    const auto view = request.view(each.variant.settings, 1);
    CHECK(renderer.render(*view, each.variant.settings).buffers.color ==
          curve->pictures[each.picture]);
  }
}

TEST_CASE("the finest level is the reference, and coarser ones err more") {
  const Scene sphere = scene_of("sphere:16");
  CurveRequest request = request_of(sphere);
  request.level = 16;
  request.combine = false;
  for (const int level : {4, 8, 256}) {
    request.at_levels.emplace(level, scene_of(("sphere:" + std::to_string(level)).c_str()));
    request.variants.levels.push_back(level);
  }
  const auto curve = measure_curve(request);
  REQUIRE(curve);
  CHECK(curve->reference_is.find("level 256") != std::string::npos);
  const double four = point(*curve, "level 4").error.rms,
               eight = point(*curve, "level 8").error.rms;
  CHECK(four > eight);
  CHECK(eight > point(*curve, "level 256").error.rms);
}

TEST_CASE("a plan that leaves out what is seen is found out as a fault of the program") {
  const Scene room = scene_of("room");
  CurveRequest request = request_of(room);
  request.combine = false;
  request.variants.tile.planner = [](std::span<const PlannedEye> eyes, bool leave_out) {
    std::vector<Plan> plans = make_plans(eyes, leave_out);
    if (leave_out) plans.front().order.pop_back();  // for example a wall
    return plans;
  };
  const auto curve = measure_curve(request);
  REQUIRE(curve);
  CHECK(std::ranges::find(curve->faults, "--no-plan") != curve->faults.end());
}

}  // namespace
}  // namespace glassbox::study
