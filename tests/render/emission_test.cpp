// Emission of surfaces: added once after lighting, with the same bytes in both engines, and no
// effect where no material emits.
#include <glassbox/images/srgb.h>
#include <glassbox/render/trace/tracer.h>
#include "app/trace/json.h"

#include <nlohmann/json.hpp>

#include "tests/render/plan/plan_checks.h"

namespace glassbox {
namespace {

using namespace test;

constexpr Shading kShadings[] = {Shading::kPhong, Shading::kGouraud, Shading::kFlat,
                                 Shading::kUnlit};

Material emitting_material(const std::array<float, 3>& emission) {
  Material material;
  material.base_color = {0.3f, 0.2f, 0.1f, 1};
  material.specular = {0.4f, 0.4f, 0.4f};
  material.emission = emission;
  return material;
}

// A quad across the view, with texture coordinates; texture 0 is the base colour, texture 1 the
// emission.
Scene textured_quad(bool base_texture, bool emission_texture, const Sampler& sampler = {}) {
  Mesh mesh;
  mesh.positions = {{-1, -1, -3}, {1, -1, -3}, {1, 1, -5}, {-1, 1, -5}};
  mesh.texcoords = {{0, 0}, {3, 0}, {3, 2}, {0, 2}};
  mesh.faces = {{0, 4}};
  for (std::uint32_t i = 0; i < 4; ++i) mesh.corners.push_back({i, kNone, i, kNone});
  Scene scene = scene_of(mesh, emitting_material({0.2f, 2.0f, 0.7f}));
  for (int i = 0; i < 2; ++i) {
    Image<Rgba8> image(4, 4);
    for (std::size_t k = 0; k < 16; ++k) {
      const auto byte = [&](std::size_t salt) {
        return std::uint8_t((k * 37 + salt * 91 + std::size_t(i) * 13) & 255);
      };
      image.pixels[k] = {byte(0), byte(1), byte(2), 255};
    }
    scene.images.push_back(image);
    scene.textures.push_back({std::uint32_t(i), sampler});
  }
  if (base_texture) scene.materials[0].texture = 0;
  if (emission_texture) scene.materials[0].emission_texture = 1;
  return scene;
}

TEST_CASE("what a surface emits is added to its light, in linear light") {
  // Black except for its emission: on black the ambient light gives 0.
  Material black = emitting_material({0.25f, 0.5f, 4.0f});
  black.base_color = {0, 0, 0, 1};
  black.specular = {0, 0, 0};
  Mesh mesh;
  mesh.positions = {{-9, -9, -3}, {9, -9, -3}, {9, 9, -3}, {-9, 9, -3}};
  add_face(mesh, {0, 1, 2, 3});
  const Scene scene = scene_of(mesh, black);
  RenderSettings settings;
  const auto middle = [&] {
    return render_tiled(scene, planned_view(), settings).buffers.color.at(48, 32);
  };
  CHECK(middle() == Rgba8{encode_srgb(0.25f), encode_srgb(0.5f), 255, 255});
  settings.transfer = Transfer::kNone;
  CHECK(middle() == Rgba8{64, 128, 255, 255});
  // Unlit surfaces show no emission either.
  settings.shading = Shading::kUnlit;
  CHECK(middle() == Rgba8{0, 0, 0, 255});
}

TEST_CASE("emission has the same bytes in both engines, with the plan and without it") {
  for (const Shading shading : kShadings) {
    for (const Transfer transfer : {Transfer::kSrgb, Transfer::kNone}) {
      RenderSettings settings;
      settings.shading = shading;
      settings.transfer = transfer;
      check_planned(ball_at({0, 0, -4}, emitting_material({0.1f, 0.0f, 0.6f})), planned_view(),
                    settings);
      for (const int samples : {1, 4}) {
        settings.samples = samples;
        check_same(textured_quad(true, true), planned_view(), settings);
      }
    }
  }
}

TEST_CASE("an emission's texture is sampled as that of the base colour is") {
  for (const MipFilter mip : {MipFilter::kNone, MipFilter::kNearest, MipFilter::kLinear}) {
    for (const Filter filter : {Filter::kNearest, Filter::kLinear}) {
      const Sampler sampler{Wrap::kMirroredRepeat, Wrap::kRepeat, filter, filter, mip};
      for (const bool base : {false, true}) {
        check_planned(textured_quad(base, true, sampler), planned_view());
        check_planned(textured_quad(base, false, sampler), planned_view());
      }
    }
  }
  CHECK(render_tiled(textured_quad(false, true), planned_view(), {}).buffers.color.pixels !=
        render_tiled(textured_quad(false, false), planned_view(), {}).buffers.color.pixels);
}

TEST_CASE("masked and blended surfaces, lines and mixed corners emit the same in both engines") {
  for (const AlphaMode mode : {AlphaMode::kMask, AlphaMode::kBlend}) {
    Scene scene = textured_quad(true, true);
    scene.materials[0].alpha_mode = mode;
    scene.materials[0].base_color.a = 0.7f;
    check_planned(scene, planned_view());
  }
  RenderSettings lines;
  lines.wireframe = true;
  check_planned(textured_quad(true, true), planned_view(), lines);
  Scene mixed = textured_quad(false, true);
  mixed.meshes[0].corners[2].texcoord = kNone;
  check_planned(mixed, planned_view());
  for (Corner& corner : mixed.meshes[0].corners) corner.texcoord = kNone;
  check_planned(mixed, planned_view());
}

TEST_CASE("emission is left out where no material emits, and the picture is black without it") {
  const View view = planned_view();
  const Scene dark = ball_at({0, 0, -4}),
              bright = ball_at({0, 0, -4}, emitting_material({0, 0.5f, 0}));
  CHECK_FALSE(plan_of(dark, view).plan.methods[0].emission);
  CHECK(plan_of(dark, view, {}, false).plan.methods[0].emission);
  CHECK(plan_of(bright, view).plan.methods[0].emission);
  CHECK_FALSE(decision(dark, view, "emission").needed);
  CHECK(decision(bright, view, "emission").needed);
  Scene unlit = bright;
  unlit.materials[0].unlit = true;
  CHECK_FALSE(plan_of(unlit, view).plan.methods[0].emission);
  check_planned(unlit, view);
  const auto without = [](std::span<const PlannedEye> eyes, bool leave_out) {
    std::vector<Plan> plans = make_plans(eyes, leave_out);
    for (Plan& plan : plans) plan.methods[0].emission = false;
    return plans;
  };
  CHECK(differs_with_planner(bright, view, {}, without));
  const Scene quad = textured_quad(false, true);
  CHECK(decision(quad, view, "texture coordinates").needed);
  CHECK(decision(quad, view, "choice of a mip level").needed);
  const auto without_texture = [](std::span<const PlannedEye> eyes, bool leave_out) {
    std::vector<Plan> plans = make_plans(eyes, leave_out);
    for (Plan& plan : plans) plan.methods[0].emission_texture = false;
    return plans;
  };
  CHECK(differs_with_planner(quad, view, {}, without_texture));
}

TEST_CASE("a surface without the coordinates that its emission's texture needs emits nothing") {
  Scene scene = textured_quad(false, true);
  Scene dark = textured_quad(false, false);
  dark.materials[0].emission = {};
  for (Scene* each : {&scene, &dark}) {
    each->meshes[0].texcoords.clear();
    for (Corner& corner : each->meshes[0].corners) corner.texcoord = kNone;
  }
  CHECK(render_tiled(scene, planned_view(), {}).buffers.color.pixels ==
        render_tiled(dark, planned_view(), {}).buffers.color.pixels);
  CHECK_FALSE(decision(scene, planned_view(), "emission").needed);
  check_planned(scene, planned_view());
}

TEST_CASE("a trace has what was emitted beside the light that it is part of") {
  const Scene scene = ball_at({0, 0, -4}, emitting_material({0.125f, 0.5f, 0}));
  TraceFilter filter;
  filter.pixels = PixelRect{48, 32, 49, 33};
  const auto run = trace(scene, planned_view(), {}, filter);
  REQUIRE(!run.trace.fragments.empty());
  const nlohmann::json json = nlohmann::json::parse(to_json(scene, run.trace).dump());
  bool any = false;
  for (const auto& fragment : json.at("fragments")) {
    if (!fragment.contains("light")) continue;
    any = true;
    CHECK(fragment.at("emission") == nlohmann::json({0.125, 0.5, 0.0}));
    CHECK(fragment.at("light").at(1).get<double>() > 0.5);
  }
  CHECK(any);
}

}  // namespace
}  // namespace glassbox
