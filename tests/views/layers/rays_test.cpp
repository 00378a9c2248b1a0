// Layers by rays: the ray caster, compared with testing every triangle; the distribution of the
// rays; and the surfaces that they find (S1-03).
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/render/renderer.h>

#include "tests/support/catch.h"
#include "views/layers/draw_layers.h"
#include "views/layers/layer_builder.h"
#include "views/layers/ray_layers.h"
#include "views/layers/ray_surfaces.h"

using namespace glassbox;
using namespace glassbox::views;

namespace {

constexpr double kRounding = 0x1p-53;
const auto kAll = [](const RayHit&) { return true; };

Eigen::Vector3d random_point(Random& random, double reach) {
  return {random.between(-reach, reach), random.between(-reach, reach),
          random.between(-reach, reach)};
}

// Small and large triangles in a cube of side 20, some of them slivers.
std::vector<TriangleCorners> random_triangles(Random& random, int count) {
  std::vector<TriangleCorners> triangles;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d at = random_point(random, 10);
    const double size = std::exp2(random.between(-6, 3));
    triangles.push_back(
        {at, at + random_point(random, size), at + random_point(random, size * random.unit())});
  }
  return triangles;
}

Ray random_ray(Random& random) {
  return {random_point(random, 12).cast<float>(), random_point(random, 1)};
}

}  // namespace

TEST_CASE("the tree of boxes finds the hit that trying every triangle finds, bit for bit") {
  Random random(1);
  int hits_of_many = 0;
  for (const int count : {0, 1, 4, 5, 300, 3000}) {
    const std::vector<TriangleCorners> triangles = random_triangles(random, count);
    const RayCaster caster(triangles);
    for (int i = 0; i < 400; ++i) {
      Ray ray = random_ray(random);
      if (i % 4 == 0) ray.direction[int(random.integer(0, 2))] = 0;
      RayHit nearest;
      bool found = false;
      for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        auto hit = ShearedRay(ray).intersect(triangles[t]);
        if (!hit || hit->distance >= nearest.distance) continue;
        nearest = *hit;
        nearest.triangle = t;
        found = true;
      }
      const auto cast = caster.cast(ray, kAll);
      REQUIRE(cast.has_value() == found);
      if (!found) continue;
      hits_of_many += count >= 300;
      CHECK(cast->triangle == nearest.triangle);
      CHECK(cast->distance == nearest.distance);
      CHECK(cast->front == nearest.front);
    }
  }
  CHECK(hits_of_many > 80);
}

TEST_CASE("a hit is where the ray meets the triangle's plane, and inside") {
  Random random(2);
  int compared = 0;
  for (const TriangleCorners& corners : random_triangles(random, 4000)) {
    // Towards a point in the triangle's plane, near the triangle.
    const double s = random.between(-0.5, 1.5), t = random.between(-0.5, 1.5);
    const Eigen::Vector3d a = corners[1] - corners[0], b = corners[2] - corners[0];
    Ray ray{random_point(random, 12).cast<float>(), {}};
    const Eigen::Vector3d to = corners[0] + s * a + t * b;
    ray.direction = to - ray.origin.cast<double>();
    // Skips triangles seen edge-on and points near an edge, so that sums in double cannot decide
    // wrongly.
    const double facing = std::abs(a.cross(b).normalized().dot(ray.direction.normalized()));
    const double edge = std::min({std::abs(s), std::abs(t), std::abs(1 - s - t)});
    if (facing < 1e-2 || edge < 1e-3 || a.cross(b).norm() < 1e-4) continue;
    ++compared;
    const bool inside = s > 0 && t > 0 && s + t < 1;
    const RayCaster caster({corners});
    const auto hit = caster.cast(ray, kAll);
    REQUIRE(hit.has_value() == inside);
    if (!inside) continue;
    CHECK(hit->front == (a.cross(b).dot(ray.direction) < 0));
    // The weighted mean of the corners is on the plane up to the rounding of three products and two
    // sums: 8 u of the largest coordinate, here 18, along each axis, and as much for the check
    // itself.
    const Eigen::Vector3d at = caster.hit_point(*hit), normal = a.cross(b).normalized();
    CHECK(std::abs(normal.dot(at - corners[0])) < 2 * 8 * kRounding * 18 * std::sqrt(3.0));
    // After the shear, coordinates have an error of 4 u M, where M is the largest coordinate
    // relative to the origin, and an edge function, two products, has an error of 48 u M^2. A point
    // whose weights are shares of the area A is off the ray by 3 * 48 u M^2 * 2 M / A and 4 u M.
    // The shear lengthens by at most sqrt(3), and `to` and the direction were rounded, too, by M u
    // each.
    double reach = 0;
    for (const Eigen::Vector3d& corner : corners)
      reach = std::max(reach, (corner - ray.origin.cast<double>()).cwiseAbs().maxCoeff());
    const double area =
        std::abs(a.cross(b).dot(ray.direction)) / ray.direction.cwiseAbs().maxCoeff();
    const double bound =
        std::sqrt(3.0) * kRounding * (288 * reach * reach * reach / area + 8 * reach);
    const Eigen::Vector3d off = at - ray.origin.cast<double>();
    CHECK(off.cross(ray.direction.normalized()).norm() < bound);
  }
  CHECK(compared > 2000);
}

TEST_CASE("no ray slips through the edges of a closed surface") {
  // A fan of triangles around the axis; the rays aim at its edges and at its apex.
  Random random(3);
  std::vector<TriangleCorners> fan;
  std::vector<Eigen::Vector3d> rim;
  for (int i = 0; i < 24; ++i)
    rim.emplace_back(std::cos(i * 0.2617993877991494), std::sin(i * 0.2617993877991494),
                     random.between(2, 4));
  const Eigen::Vector3d apex(0.1, 0.05, 3);
  for (std::size_t i = 0; i < rim.size(); ++i)
    fan.push_back({apex, rim[i], rim[(i + 1) % rim.size()]});
  const RayCaster caster(fan);
  for (int i = 0; i < 4000; ++i) {
    const Eigen::Vector3d& edge = rim[std::size_t(i) % rim.size()];
    const double along = i < 24 ? 0 : random.between(0, 0.99);
    Ray ray{{float(random.between(-0.1, 0.1)), float(random.between(-0.1, 0.1)), -1}, {}};
    ray.direction = apex + along * (edge - apex) - ray.origin.cast<double>();
    CHECK(caster.cast(ray, kAll));
  }
}

TEST_CASE("a ray that meets an edge or a corner exactly has a triangle there") {
  // Eight triangles around the corner (0, 0, -4), whose edges are parallel to the axes or diagonal.
  // The rays to the corner and to the edges have dyadic numbers, so that edge functions are exactly
  // 0.
  std::vector<TriangleCorners> around;
  const Eigen::Vector3d middle(0, 0, -4);
  const Eigen::Vector3d rim[] = {{4, 0, -4},  {4, 4, -4},   {0, 4, -4},  {-4, 4, -4},
                                 {-4, 0, -4}, {-4, -4, -4}, {0, -4, -4}, {4, -4, -4}};
  for (std::size_t i = 0; i < 8; ++i) around.push_back({middle, rim[i], rim[(i + 1) % 8]});
  const RayCaster caster(around);
  for (const Eigen::Vector3f& origin :
       {Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(0.5f, -0.25f, 0), Eigen::Vector3f(1, 1, 4)}) {
    for (const Eigen::Vector3d& end : rim) {
      for (const double along : {0.0, 0.25, 0.5, 0.75}) {
        const Eigen::Vector3d to = middle + along * (end - middle);
        const Ray ray{origin, to - origin.cast<double>()};
        int meet = 0;
        for (const TriangleCorners& triangle : around)
          meet += ShearedRay(ray).intersect(triangle).has_value();
        CHECK(meet == (along == 0 ? 8 : 2));  // on an edge both neighbours are hit
        const auto hit = caster.cast(ray, kAll);
        REQUIRE(hit);
        CHECK(caster.hit_point(*hit) == to);
      }
    }
  }
}

TEST_CASE("parts of a sampling have all of its rays, each once, and none has many") {
  for (const RaySampling& sampling :
       {RaySampling{.strata = 4, .rays = 16}, RaySampling{.strata = 12, .rays = 3},
        RaySampling{.strata = 1, .rays = 3 * kRaysOfPart + 5}}) {
    RayParts parts(sampling);
    std::uint64_t all = 0, stratum = 0;
    int done = 0;
    Random random = stratum_random(stratum_of(0, sampling.strata), sampling.strata);
    while (const auto part = parts.next()) {
      CHECK(part->strata * std::uint64_t(part->rays) <= std::uint64_t(kRaysOfPart));
      all += part->strata * std::uint64_t(part->rays);
      CHECK(part->stratum == stratum);
      // The random numbers continue where the previous part ended.
      Random own = part->random;
      CHECK(own.bits() == Random(random).bits());
      for (int i = 0; i < part->rays; ++i)
        stratified_numbers(stratum_of(stratum, sampling.strata), sampling.strata, random);
      done += part->rays;
      if (done < sampling.rays) continue;
      done = 0;
      stratum += part->strata;
      if (all < sampling.count())
        random = stratum_random(stratum_of(stratum, sampling.strata), sampling.strata);
    }
    CHECK(all == sampling.count());
  }
}

TEST_CASE("rays are spread as the cosine law asks, and each in its stratum") {
  constexpr int kStrata = 6, kRays = 4;
  double cosines = 0, squares = 0;
  std::size_t count = 0, aside = 0;
  std::array<int, 10> by_height{};
  for (int number = 0; number < kStrata * kStrata * kStrata * kStrata; ++number) {
    const std::array<int, 4> stratum{number / (kStrata * kStrata * kStrata),
                                     number / (kStrata * kStrata) % kStrata,
                                     number / kStrata % kStrata, number % kStrata};
    Random random = stratum_random(stratum, kStrata);
    for (int i = 0; i < kRays; ++i) {
      const auto numbers = stratified_numbers(stratum, kStrata, random);
      for (std::size_t k = 0; k < 4; ++k) REQUIRE(int(numbers[k] * kStrata) == stratum[k]);
      const Ray ray = ray_of(numbers, 0.5);
      CHECK(ray.origin.z() == -0.5f);
      aside += ray.origin.cwiseAbs().maxCoeff() > 0.5f;
      CHECK(std::abs(ray.direction.norm() - 1) < 8 * kRounding);
      const double cosine = -ray.direction.z();
      cosines += cosine;
      squares += cosine * cosine;
      ++by_height[std::size_t(std::min(9.0, 10 * cosine * cosine))];
      ++count;
    }
  }
  CHECK(aside == 0);
  // Cosines c with density 2 c have mean 2/3, and their squares have mean 1/2. Means of n
  // unstratified samples would be within 4 sigma = 4 sqrt(1/18 / n) and 4 sqrt(1/12 / n); strata
  // only reduce that.
  const auto n = double(count);
  CHECK(std::abs(cosines / n - 2.0 / 3) < 4 * std::sqrt(1.0 / 18 / n));
  CHECK(std::abs(squares / n - 0.5) < 4 * std::sqrt(1.0 / 12 / n));
  // The square is uniformly distributed: chi squared of 10 classes is below the 0.9999 quantile of
  // 9 degrees of freedom.
  double chi = 0;
  for (const int here : by_height) chi += (here - n / 10) * (here - n / 10) / (n / 10);
  CHECK(chi < 33.7);
}

TEST_CASE(
    "layers of rays have the same bytes for every number of threads, and look like the scene") {
  const Scene scene = make_builtin("room").value();
  const View view = make_view(scene.cameras.at(0), 48, 32).value();
  RaySampling sampling{.strata = 10, .rays = 12, .half_side = 0.1};
  RayCounts counts, again;
  const LayeredImage one = build_layers_by_rays(scene, view, {}, sampling, kMergedHits, counts);
  sampling.threads = 2;
  const LayeredImage two = build_layers_by_rays(scene, view, {}, sampling, kMergedHits, again);
  CHECK(one.first == two.first);
  CHECK(one.depth == two.depth);
  CHECK(one.color == two.color);
  CHECK(counts.hits == again.hits);
  CHECK(counts.followed == again.followed);
  REQUIRE(check(one, "rays"));
  CHECK(counts.followed <= sampling.count());
  CHECK(counts.hits <= counts.followed);
  CHECK(one.samples() <= counts.hits);

  // A pixel in the middle of a surface, whose neighbours have similar distances, has the same
  // distance as in the rasterizer, up to the change within half a pixel.
  RenderSettings settings;
  settings.want_distance = true;
  const Framebuffer drawn = Renderer(scene, settings.transfer).render(view, settings).buffers;
  const LayerPicture picture = draw_layers(one, one.camera, {.splat = Splat::kPoint});
  int compared = 0, alike = 0;
  for (int y = 1; y < 31; ++y) {
    for (int x = 1; x < 47; ++x) {
      double nearest = 1e9, farthest = 0;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          nearest = std::min(nearest, double(drawn.distance.at(x + dx, y + dy)));
          farthest = std::max(farthest, double(drawn.distance.at(x + dx, y + dy)));
        }
      }
      if (farthest > 1.1 * nearest || picture.depth.at(x, y) == 0) continue;
      ++compared;
      const double distance = view.near / double(picture.depth.at(x, y));
      alike += distance > 0.98 * nearest && distance < 1.02 * farthest;
    }
  }
  CHECK(compared > 500);
  CHECK(alike > 0.97 * compared);
}

// A mirrored teapot that emits light: the winding tells which side is the outside, and mirroring
// reverses it.
static Scene mirrored_lamp() {
  Scene scene = make_builtin("teapot").value();
  for (Material& material : scene.materials) material.emission = {0.3f, 0.1f, 0.05f};
  for (Node& node : scene.nodes) {
    for (int row = 0; row < 4; ++row) node.world_from_node.at(row, 0) *= -1;
  }
  return scene;
}

TEST_CASE("a hit has the colour that the rasterizer gives the same point") {
  for (const std::string name : {"room", "forest", "checker", "thicket", "mirrored lamp"}) {
    INFO(name);
    const Scene scene = name == "mirrored lamp" ? mirrored_lamp() : make_builtin(name).value();
    const Camera camera =
        scene.cameras.empty() ? framing_camera(scene, 64.0 / 48).value() : scene.cameras[0];
    const View view = make_view(camera, 64, 48).value();
    const RenderSettings settings;
    const Image<Rgba8> drawn =
        Renderer(scene, settings.transfer).render(view, settings).buffers.color;
    const RaySurfaces surfaces(scene, view, settings);
    int hits = 0, alike = 0, shown = 0;
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) {
        shown += drawn.at(x, y) != settings.background;
        Ray ray{{0, 0, 0}, {}};
        ray.direction = {(2 * (x + 0.5) / 64 - 1) / view.clip_from_eye.at(0, 0),
                         (1 - 2 * (y + 0.5) / 48) / view.clip_from_eye.at(1, 1), -1};
        const auto hit = surfaces.caster().cast(
            ray, [&](const RayHit& candidate) { return surfaces.is_drawn_at(candidate); });
        if (!hit) continue;
        ++hits;
        const Rgba8 there = surfaces.color(*hit), here = drawn.at(x, y);
        alike += std::abs(there.r - here.r) <= 2 && std::abs(there.g - here.g) <= 2 &&
                 std::abs(there.b - here.b) <= 2;
      }
    }
    CHECK(hits > 500);
    CHECK(std::abs(hits - shown) <= 0.03 * hits);
    // Vertices are snapped to 1/256 px, which moves edges across a few pixel centres and shifts
    // texels a little.
    CHECK(alike > 0.97 * hits);
  }
}
