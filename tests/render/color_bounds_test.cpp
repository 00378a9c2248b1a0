// The colour bounds of whole runs, compared with arithmetic of 320 bits that starts from the
// matrices and tables: every attribute, texture sample, light and byte of random textured scenes,
// which planes cut, too.
#include <glassbox/render/trace/color_bounds.h>

#include <cmath>
#include <cstdio>

#include <glassbox/raster/color_bounds.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/trace/picture_bounds.h>

#include "tests/render/exact_attributes.h"
#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

using bounded::Bounded;
using in_full::Big;
using test::affine;
using test::Big3;
using test::BigMatrix;
using test::exactly;
using test::eye_normal;
using test::face_normal_of;
using test::negated;
using test::operator*;

// The largest error in units of its bound.
struct ColorErrorRatio {
  const char* name;
  double ratio = 0;
  int count = 0, unbounded = 0;

  void add(const Big& value, const Big& exact, double bound) {
    ++count;
    if (!std::isfinite(bound)) {
      ++unbounded;
      return;
    }
    const double error = double(abs(value - exact));
    CAPTURE(name, double(value), double(exact), bound);
    // The oracle's textures are computed in double.
    REQUIRE(error <= bound + 1e-12);
    if (bound > 0) ratio = std::max(ratio, error / bound);
  }
  void add(const Bounded& computed, const Big& exact) {
    add(Big(computed.value), exact, computed.bound);
  }
  void check() const {
    std::printf("  %-20s %8d numbers, %6d without bound, largest error / bound = %.3f\n", name,
                count, unbounded, ratio);
    CAPTURE(name, count, unbounded, ratio);
    CHECK(count > 1000);
    CHECK(ratio > 0.01);
    CHECK(unbounded < count / 50);
  }
};

struct All {
  ColorErrorRatio texcoord{"texture coordinates"}, normal{"normals"}, sample{"texture samples"},
      surface{"surface"}, light{"light"}, stored{"stored bytes"};
};

// ---- scenes ----

Scene random_scene(Random& random) {
  Mesh mesh;
  mesh.name = "soup";
  for (int i = 0; i < 12; ++i) {
    const std::array<double, 3> centre{random.between(-1, 1), random.between(-1, 1),
                                       random.between(-1, 1)};
    for (int k = 0; k < 3; ++k) {
      mesh.positions.push_back({float(centre[0] + random.between(-1, 1)),
                                float(centre[1] + random.between(-1, 1)),
                                float(centre[2] + random.between(-1, 1))});
      mesh.texcoords.push_back({float(random.between(-3, 3)), float(random.between(0, 1))});
      mesh.normals.push_back({float(random.between(-1, 1)), float(random.between(-1, 1)), 0.7f});
      mesh.colors.push_back({float(random.unit()), 1, 0.5f, 1});
      const auto last = std::uint32_t(mesh.positions.size() - 1);
      const bool has_normal = random.unit() < 0.8;
      mesh.corners.push_back({last, has_normal ? last : kNone, last, last});
    }
    mesh.faces.push_back({std::uint32_t(3 * i), 3});
  }
  Material material;
  material.texture = 0;
  material.double_sided = true;
  material.specular = {0.3f, 0.3f, 0.3f};
  material.shininess = int(random.integer(1, 40));
  material.emission = {0.1f, 0, 0};
  Scene scene = test::scene_of(std::move(mesh), material);
  scene.textures.push_back({0, Sampler{Wrap(random.integer(0, 2)), Wrap(random.integer(0, 2)),
                                       Filter(random.integer(0, 1)), Filter(random.integer(0, 1)),
                                       MipFilter(random.integer(0, 2))}});
  Image<Rgba8>& image = scene.images.emplace_back(16, 8);
  for (Rgba8& c : image.pixels) {
    const auto byte = [&] { return std::uint8_t(random.integer(0, 255)); };
    c = {byte(), byte(), byte(), 255};
  }
  Light light;
  light.kind = LightKind(random.integer(0, 2));
  light.intensity = 12;
  light.position = {2, 3, 4};
  light.direction = {0, -0.6, -0.8};
  scene.lights = {light};
  const Vector<Object, double> axis{1, random.between(-1, 1), 0.5};
  const auto turn = rotate_degrees<World>(axis, random.between(-180, 180));
  REQUIRE(turn);
  const double height = random.between(0.5, 2);
  scene.nodes[0].world_from_node =
      *turn * scale<Object, Object>(1, height, random.unit() < 0.5 ? 1 : -1);
  return scene;
}

// ---- the same, computed exactly ----

struct ExactCorner {
  Big inverse_w{};
  Big3 position{}, normal{}, diffuse{}, specular{};
  std::array<Big, 4> color{};
  std::array<Big, 2> texcoord{};
};

class Oracle {
public:
  Oracle(const Scene& scene, const View& view, const RenderSettings& settings, const Draw& draw,
         const Lighting& lighting)
      : scene_(scene),
        settings_(settings),
        draw_(draw),
        lighting_(lighting),
        eye_(exactly(view.eye_from_world.columns) *
             exactly(scene.nodes[0].world_from_node.columns)),
        clip_(exactly(view.clip_from_eye.columns) * eye_),
        levels_(in_full::levels_of(scene.images[0], settings.transfer)) {}

  void compare(const Trace& trace, const TracedFragment& traced, const TracedTriangle& triangle,
               const ColorBounds& found, All& all) const {
    const TracedPiece& piece = triangle.pieces[traced.source.piece];
    const TriangleSetup& setup = *piece.setup;
    std::array<test::BigVector, 3> in_clip;
    std::array<ExactCorner, 3> whole, corners;
    for (std::size_t k = 0; k < 3; ++k) {
      in_clip[k] = clip_ * triangle.corners[k].object;
      whole[k] = corner(triangle, k, piece.front);
    }
    const auto polygon = test::exact_polygon(trace, triangle, in_clip);
    REQUIRE(polygon.size() == triangle.polygon.size());
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = weighed(whole, polygon[piece.polygon[std::size_t(setup.order[k])]]);
    }
    Big3 share;
    Big q = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      share[k] = Big(traced.coverage.edges[k]) / Big(setup.double_area) * corners[k].inverse_w;
      q += share[k];
    }
    const auto at = [&](const auto& of) {
      Big sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += share[k] / q * of(corners[k]);
      return sum;
    };
    std::array<Big, 2> uv;
    Big3 normal, position;
    ReflectionOf<Big> reflection;
    for (std::size_t i = 0; i < 3; ++i) {
      normal[i] = at([&](const ExactCorner& c) { return c.normal[i]; });
      position[i] = at([&](const ExactCorner& c) { return c.position[i]; });
      reflection.diffuse[i] = at([&](const ExactCorner& c) { return c.diffuse[i]; });
      reflection.specular[i] = at([&](const ExactCorner& c) { return c.specular[i]; });
      all.normal.add(found.at.normal[i], normal[i]);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      uv[i] = at([&](const ExactCorner& c) { return c.texcoord[i]; });
      all.texcoord.add(found.at.texcoord[i], uv[i]);
    }
    const Sampler& sampler = scene_.textures[0].sampler;
    const in_full::Light texel = in_full::sample(levels_, sampler, double(uv[0]), double(uv[1]),
                                                 level(setup, corners, uv, q));
    Big3 base;
    const Material& material = *draw_.material;
    const float tints[] = {material.base_color.r, material.base_color.g, material.base_color.b};
    for (std::size_t i = 0; i < 3; ++i) {
      const Big color = at([&](const ExactCorner& c) { return c.color[i]; });
      base[i] = Big(tints[i]) * color * Big(texel[i]);
      all.surface.add(found.surface[i], base[i]);
    }
    check_samples(traced, found, texel, all);
    const bool lit = settings_.shading != Shading::kUnlit;
    if (settings_.shading == Shading::kPhong) {
      reflection = in_full::reflected_light(lighting_, position, normal, material.shininess, true);
    }
    Big3 light =
        lit ? in_full::reflected_color(base, normal, reflection, material.specular, true) : base;
    const std::uint8_t bytes[] = {traced.after.r, traced.after.g, traced.after.b};
    for (std::size_t i = 0; i < 3; ++i) {
      if (lit) light[i] += Big(material.emission[i]);
      all.light.add(found.light[i], light[i]);
      all.stored.add(Big(bytes[i]),
                     Big(255 * in_full::encoded(settings_.transfer, double(light[i]))),
                     stored_bound(settings_.transfer, bytes[i], found.light[i]));
    }
  }

private:
  ExactCorner corner(const TracedTriangle& triangle, std::size_t k, bool front) const {
    const Mesh& mesh = scene_.meshes[0];
    const Corner& corner = mesh.corners[triangle.corners[k].corner];
    const Point<Object>& p = mesh.positions[corner.position];
    ExactCorner exact;
    exact.position = affine(eye_, p);
    exact.texcoord = {Big(mesh.texcoords[corner.texcoord].u),
                      Big(mesh.texcoords[corner.texcoord].v)};
    const Rgba& color = mesh.colors[corner.color];
    exact.color = {Big(color.r), Big(color.g), Big(color.b), Big(color.a)};
    if (settings_.shading == Shading::kUnlit) return exact;
    const bool flat = settings_.shading == Shading::kFlat;
    if (flat || corner.normal == kNone) {
      exact.normal = eye_normal(eye_, face_normal_of(triangle));
    } else {
      const Normal<Object>& n = mesh.normals[corner.normal];
      exact.normal = eye_normal(eye_, {Big(n.x), Big(n.y), Big(n.z)});
    }
    if (!front) exact.normal = negated(exact.normal);
    if (settings_.shading == Shading::kPhong) return exact;
    Big3 place = exact.position;
    if (flat) {
      place = {};
      for (std::size_t c = 0; c < 3; ++c) {
        const Big3 one = affine(eye_, triangle.corners[c].object);
        for (std::size_t i = 0; i < 3; ++i) place[i] += one[i] / 3;
      }
    }
    const auto reflection =
        in_full::reflected_light(lighting_, place, exact.normal, draw_.material->shininess, true);
    exact.diffuse = reflection.diffuse;
    exact.specular = reflection.specular;
    return exact;
  }

  // The attributes at a vertex that clipping has left, as a weighted sum of those at the corners.
  static ExactCorner weighed(const std::array<ExactCorner, 3>& corners,
                             const test::ExactVertex& vertex) {
    ExactCorner sum{};
    sum.inverse_w = 1 / vertex.clip[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto add = [&](auto& to, const auto& from) {
        for (std::size_t i = 0; i < to.size(); ++i) to[i] += vertex.weights[k] * from[i];
      };
      add(sum.position, corners[k].position);
      add(sum.normal, corners[k].normal);
      add(sum.diffuse, corners[k].diffuse);
      add(sum.specular, corners[k].specular);
      add(sum.color, corners[k].color);
      add(sum.texcoord, corners[k].texcoord);
    }
    return sum;
  }

  double level(const TriangleSetup& setup, const std::array<ExactCorner, 3>& corners,
               const std::array<Big, 2>& uv, const Big& q) const {
    std::array<Big3, 2> slopes;
    std::array<std::array<Big, 2>, 3> texcoords;
    for (std::size_t k = 0; k < 3; ++k) {
      const Big scale = Big(kSubpixels) / Big(setup.double_area) * corners[k].inverse_w;
      slopes[0][k] = Big(setup.edges[k].a) * scale;
      slopes[1][k] = Big(setup.edges[k].b) * scale;
      texcoords[k] = corners[k].texcoord;
    }
    const auto planes = in_full::planes_over_w(slopes, texcoords, false);
    const auto gradient = in_full::gradient_at(planes, uv, q);
    const int width = scene_.images[0].width, height = scene_.images[0].height;
    const Big squared = in_full::greatest(in_full::squared_texels(gradient.along_x, width, height),
                                          in_full::squared_texels(gradient.along_y, width, height));
    return 0.5 * double(log(squared) / log(Big(2)));
  }

  // Compares the texture sample with its bound. The surface's colour equals the sample only where
  // nothing tints it; other fragments are skipped.
  void check_samples(const TracedFragment& traced, const ColorBounds& found,
                     const in_full::Light& texel, All& all) const {
    const float tint = traced.at.color[1] * draw_.material->base_color.g;
    if (tint != 1) return;
    all.sample.add(Big(traced.surface.g), Big(texel[1]), *found.sample);
  }

  const Scene& scene_;
  const RenderSettings& settings_;
  const Draw& draw_;
  const Lighting& lighting_;
  BigMatrix eye_, clip_;
  std::vector<in_full::Level> levels_;
};

}  // namespace

TEST_CASE("every colour of a run is within its bound") {
  Random random(45);
  All all;
  int cut = 0;
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const Scene scene = random_scene(random);
    const PerspectiveLens lens{random.between(0.5, 1.5), std::pow(10, random.between(-4, -1)), {}};
    const Point<World, double> eye{random.between(-1, 1), 0.5, random.between(0, 4)};
    const Point<World, double> target{0, random.between(-1, 1), 0};
    const auto eye_from_world = look_at(eye, target, {random.between(-0.5, 0.5), 1, 0});
    REQUIRE(eye_from_world);
    const auto view = make_view({"random", lens, inverse_rigid(*eye_from_world)}, 40, 30);
    REQUIRE(view);
    RenderSettings settings;
    settings.shading = Shading(random.integer(0, 3));
    settings.transfer = random.unit() < 0.7 ? Transfer::kSrgb : Transfer::kNone;
    const PreparedScene prepared = prepare_scene(scene, settings.transfer);
    const DrawList list = make_draw_list(scene, prepared, *view);
    const TracedRun run = trace(scene, *view, settings, {});
    const DrawBounds draw_bounds = bounds_of(run.trace.draws[0], *view);
    const auto known = bounds_of_all(run.trace);
    const Oracle oracle(scene, *view, settings, list.draws[0], list.lighting);
    int taken = 0;
    for (const TracedFragment& fragment : run.trace.fragments) {
      const BoundsOfRun::KnownTriangle& triangle = known.at(fragment.source.number);
      if (fragment.result != FragmentResult::kWritten || ++taken % 5 != 0) continue;
      cut += !triangle.triangle->clipping.empty();
      const PieceColors colors(list.draws[0], draw_bounds, list.lighting, settings, triangle,
                               fragment.source.piece);
      oracle.compare(run.trace, fragment, *triangle.triangle,
                     colors.at(fragment, bounds_of(triangle, fragment)), all);
    }
  }
  CHECK(cut > 300);  // cut by the near plane
  for (const ColorErrorRatio* kept :
       {&all.texcoord, &all.normal, &all.sample, &all.surface, &all.light, &all.stored}) {
    kept->check();
  }
}

TEST_CASE("a summary has the largest bound, its place, and one that half keep below") {
  BoundSummary summary;
  for (std::uint32_t i = 1; i <= 1000; ++i) summary.add(i * 1e-6, {i, {}, -1, -1});
  CHECK(summary.largest() == 1000 * 1e-6);
  CHECK(summary.place().number == 1000);
  CHECK(summary.typical() >= 500e-6);
  CHECK(summary.typical() <= 500e-6 * (1 + 1.0 / 16));
  for (int i = 0; i < 2000; ++i) summary.add(std::numeric_limits<double>::infinity(), {});
  CHECK(summary.unbounded() == 2000);
  CHECK(std::isinf(summary.typical()));
  BoundSummary none;
  none.add(0, {7, {}, -1, -1});
  CHECK(none.typical() == 0);
  CHECK(none.place().number == 7);
}

}  // namespace glassbox
