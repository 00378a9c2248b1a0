#include "study/scenes/scenes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>

namespace glassbox::study {

namespace {

constexpr std::array<BenchSceneName, 9> kNames = {{
    {"S1", "small triangles"},
    {"S1b", "the same triangles in an order that suits a vertex cache"},
    {"S2", "a mesh with as many triangles as a scan"},
    {"S3", "texture"},
    {"S4bf", "overdraw, drawn from back to front"},
    {"S4fb", "overdraw, drawn from front to back"},
    {"S5", "depth only"},
    {"S6", "an anaglyph of two passes"},
    {"S7", "many vertices, all of them outside the view"},
}};

constexpr double kFieldOfView = 0.785398163397448309616;  // 45 degrees
constexpr double kEyeDistance = 2.9;
constexpr double kFar = 20;

struct Frame {
  int width, height;
};

// ---- parts ----

RenderSettings bench_settings() {
  RenderSettings settings;
  settings.transfer = Transfer::kNone;
  settings.background = {26, 31, 38, 255};  // red, green and blue of about 0.10, 0.12 and 0.15
  settings.want_depth = true;               // as in the programs it is compared with
  return settings;
}

// Returns the view of a camera. It always exists, because make_view accepts the cameras of all
// scenes in this file.
View view_of(const Camera& camera, const Frame& frame) {
  return make_view(camera, frame.width, frame.height).value();
}

View perspective_view(double eye_z, double near, const Frame& frame) {
  Camera camera;
  camera.lens = PerspectiveLens{kFieldOfView, near, kFar};
  camera.world_from_eye.at(2, 3) = eye_z;
  return view_of(camera, frame);
}

// Rotates about y first, then about x.
Transform<World, Object> turned(double about_x, double about_y) {
  const SinCos x = sin_cos(about_x), y = sin_cos(about_y);
  Transform<World, World> pitch;
  pitch.at(1, 1) = x.cos, pitch.at(1, 2) = -x.sin;
  pitch.at(2, 1) = x.sin, pitch.at(2, 2) = x.cos;
  Transform<World, Object> yaw;
  yaw.at(0, 0) = y.cos, yaw.at(0, 2) = y.sin;
  yaw.at(2, 0) = -y.sin, yaw.at(2, 2) = y.cos;
  return pitch * yaw;
}

BenchScene empty_scene(std::string name) {
  BenchScene bench;
  bench.name = std::move(name);
  bench.scene.name = bench.name;
  bench.settings = bench_settings();
  return bench;
}

// ---- S1, S1b, S2, S5, S6, S7: an ellipsoid in the light ----

BenchScene ellipsoid_scene(std::string name, const EllipsoidGrid& grid, double shift_x) {
  BenchScene bench = empty_scene(std::move(name));
  add_material(bench.scene, "matte", {0.8f, 0.6f, 0.4f, 1});
  Transform<World, Object> placed = turned(0.5, 0.3);
  placed.at(0, 3) = shift_x;
  add_object(bench.scene, make_ellipsoid(grid), placed);
  // The light has 0.9 of the strength that makes a white surface that faces it fully white; the
  // vector is the direction in which the light travels.
  add_directional(bench.scene, "light", unit({-1, -1, -2}), 0.9 * kPi);
  return bench;
}

BenchScene seen_once(BenchScene bench, const Frame& frame, const ColorMask& mask = {}) {
  bench.passes = {{perspective_view(kEyeDistance, 0.5, frame), mask}};
  return bench;
}

BenchScene anaglyph_scene(std::string name, const Frame& frame) {
  BenchScene bench = ellipsoid_scene(std::move(name), kScannedGrid, 0);
  const View centre = perspective_view(kEyeDistance, 0.5, frame);
  const StereoPair pair{0.03, kEyeDistance};
  bench.stereo = {centre, pair};
  bench.passes = {{eye_view(centre, pair, Side::kLeft), {true, false, false, false}},
                  {eye_view(centre, pair, Side::kRight), {false, true, true, true}}};
  return bench;
}

// ---- S3: a textured cube that fills the picture ----

// Adds the face whose normal is `out`; u x v = out. It has four vertices of its own and two
// triangles.
void add_cube_face(Mesh& mesh, const std::array<double, 3>& out, const std::array<double, 3>& u,
                   const std::array<double, 3>& v) {
  constexpr std::array<std::array<int, 2>, 4> kCorners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::array<Corner, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const int s = kCorners[i][0], t = kCorners[i][1];
    const auto at = [&](std::size_t k) { return out[k] + (2 * s - 1) * u[k] + (2 * t - 1) * v[k]; };
    const std::uint32_t index = add_position(mesh, at(0), at(1), at(2));
    add_texcoord(mesh, s, 1 - t);
    corners[i] = {index, kNone, index};
  }
  add_face(mesh, std::array<Corner, 3>{corners[0], corners[1], corners[2]});
  add_face(mesh, std::array<Corner, 3>{corners[0], corners[2], corners[3]});
}

Mesh make_textured_cube() {
  Mesh mesh;
  mesh.name = "cube";
  add_cube_face(mesh, {0, 0, 1}, {1, 0, 0}, {0, 1, 0});
  add_cube_face(mesh, {1, 0, 0}, {0, 0, -1}, {0, 1, 0});
  add_cube_face(mesh, {0, 0, -1}, {-1, 0, 0}, {0, 1, 0});
  add_cube_face(mesh, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0});
  add_cube_face(mesh, {0, 1, 0}, {1, 0, 0}, {0, 0, -1});
  add_cube_face(mesh, {0, -1, 0}, {1, 0, 0}, {0, 0, 1});
  return mesh;
}

BenchScene textured_scene(std::string name, const Frame& frame) {
  BenchScene bench = empty_scene(std::move(name));
  const std::uint32_t material = add_material(bench.scene, "checker", {1, 1, 1, 1});
  bench.scene.materials[material].texture = add_texture(bench.scene, make_hashed_checker());
  bench.scene.materials[material].unlit = true;
  bench.scene.textures[0].sampler.mip = MipFilter::kNone;
  add_object(bench.scene, make_textured_cube(), turned(0.4, 0.6));
  bench.passes = {{perspective_view(1.75, 0.1, frame), {}}};
  return bench;
}

// ---- S4: sixty-four quads, each as large as the picture ----

Rgba quad_color(int k) {
  const auto channel = [](int value) { return float(value % 256) / 255.0f; };
  return {channel(37 * k + 20), channel(91 * k + 50), channel(153 * k + 90), 1};
}

// The positions are in the eye space of overdraw_scene's orthographic camera: clip x and y are +-1,
// and depth is -z.
void add_screen_quad(Mesh& mesh, int k, double aspect) {
  const double depth = (1 + (-0.96875 + 1.9375 * k / (kQuads - 1))) / 2;
  const auto first = std::uint32_t(mesh.positions.size());
  for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    add_position(mesh, x * aspect, y, -depth);
    add_color(mesh, quad_color(k));
  }
  const auto corner = [&](std::uint32_t i) { return Corner{first + i, kNone, kNone, first + i}; };
  add_face(mesh, std::array<Corner, 3>{corner(0), corner(1), corner(2)});
  add_face(mesh, std::array<Corner, 3>{corner(0), corner(2), corner(3)});
}

BenchScene overdraw_scene(std::string name, bool front_to_back, const Frame& frame) {
  BenchScene bench = empty_scene(std::move(name));
  const std::uint32_t material = add_material(bench.scene, "flat", {1, 1, 1, 1});
  bench.scene.materials[material].unlit = true;
  Mesh mesh;
  mesh.name = "quads";
  for (int i = 0; i < kQuads; ++i) {
    add_screen_quad(mesh, front_to_back ? i : kQuads - 1 - i,
                    double(frame.width) / double(frame.height));
  }
  add_object(bench.scene, std::move(mesh));
  Camera camera;
  camera.lens = OrthographicLens{1, 0, 1};
  bench.passes = {{view_of(camera, frame), {}}};
  return bench;
}

// ---- by name ----

BenchScene make(std::string_view name, const Frame& frame) {
  const std::string known(name);
  constexpr ColorMask kNoColors{false, false, false, false};
  if (name == "S1b") return seen_once(ellipsoid_scene(known, kBandedGrid, 0), frame);
  if (name == "S2") return seen_once(ellipsoid_scene(known, kScannedGrid, 0), frame);
  if (name == "S3") return textured_scene(known, frame);
  if (name == "S4bf") return overdraw_scene(known, false, frame);
  if (name == "S4fb") return overdraw_scene(known, true, frame);
  if (name == "S5") return seen_once(ellipsoid_scene(known, kFineGrid, 0), frame, kNoColors);
  if (name == "S6") return anaglyph_scene(known, frame);
  if (name == "S7") {
    // The ellipsoid is ten units to the right, outside the frustum, which ends at 3.4 there. Its
    // bounding box would be rejected at once, so that test is switched off: its triangles are to be
    // rejected one by one.
    BenchScene bench = seen_once(ellipsoid_scene(known, kFineGrid, 10), frame);
    bench.reject_objects = false;
    return bench;
  }
  return seen_once(ellipsoid_scene(known, kFineGrid, 0), frame);
}

}  // namespace

bool same_name(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::span<const BenchSceneName> bench_scene_names() {
  return kNames;
}

bool is_bench_scene(std::string_view name) {
  return std::ranges::any_of(
      kNames, [&](const BenchSceneName& known) { return same_name(known.name, name); });
}

Result<BenchScene> make_bench_scene(std::string_view name, int width, int height) {
  const auto found = std::ranges::find_if(
      kNames, [&](const BenchSceneName& known) { return same_name(known.name, name); });
  if (found != kNames.end()) return make(found->name, {width, height});
  std::string list;
  for (const BenchSceneName& known : kNames) {
    list += fmt::format("{}{}", list.empty() ? "" : ", ", known.name);
  }
  return fail(std::string(name), "is not a scene of the benchmark", "choose one of " + list);
}

BenchScene make_ellipsoid_scene(std::string name, const EllipsoidGrid& grid, int width,
                                int height) {
  return seen_once(ellipsoid_scene(std::move(name), grid, 0), {width, height});
}

BenchScene make_bench_scene(std::string name, Scene scene, const View& view) {
  BenchScene bench;
  bench.name = std::move(name);
  bench.scene = std::move(scene);
  bench.passes = {{view, {}}};
  return bench;
}

Image<Rgba8> make_hashed_checker() {
  Image<Rgba8> image(kCheckerSide, kCheckerSide);
  const auto channel = [](std::uint32_t value) { return std::uint8_t(std::min(value, 255u)); };
  constexpr std::uint32_t n = kCheckerSide;
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      std::uint32_t h = x * 0x9E3779B1u ^ y * 0x85EBCA77u;
      h ^= h >> 15;
      h *= 0x2C1B3C6Du;
      h ^= h >> 12;
      const std::uint32_t base = ((x >> 5 ^ y >> 5) & 1u) != 0 ? 200 : 90;
      image.at(int(x), int(y)) = {channel(base + (h & 31u)),
                                  channel(base + (h >> 5 & 31u) / 2 + 40 * x / n),
                                  channel(base + (h >> 10 & 31u) / 2 + 40 * y / n), 255};
    }
  }
  return image;
}

}  // namespace glassbox::study
