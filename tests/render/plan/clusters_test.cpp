// Clusters of triangles that are not visible are left out before their vertices are processed
// (S4-01), and no byte changes.
#include <cmath>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/render/engine/clusters.h>
#include <glassbox/render/plan/cluster_cull.h>
#include <glassbox/render/renderer.h>

#include "tests/render/plan/plan_checks.h"
#include "tests/render/stereo/pairs.h"

namespace glassbox {
namespace {

using namespace test;

// A rough ball of 6 n^2 quads around the origin, in rows, so that the triangles of many clusters
// face the same way.
Scene rough_ball(int n, double roughness, std::uint64_t seed, Material material = {}) {
  Random random(seed);
  return scene_of(star_shaped_surface(n, roughness, random), std::move(material));
}

Point<Object, double> corner(const Mesh& mesh, const Triangle& triangle, std::size_t k) {
  const Point<Object>& p = mesh.positions[mesh.corners[triangle.corners[k]].position];
  return {double(p.x), double(p.y), double(p.z)};
}

TEST_CASE("small meshes have no clusters; large ones have all their triangles in them, in order") {
  for (const int n : {9, 10, 12, 40}) {
    const Scene scene = rough_ball(n, 0.1, 3);
    const PreparedScene prepared = prepare_scene(scene, Transfer::kSrgb);
    const PreparedMesh& mesh = prepared.meshes[0];
    const std::size_t triangles = mesh.triangulation.triangles.size();
    REQUIRE(triangles == std::size_t(12 * n * n));
    const std::size_t expected = triangles < 1024 ? 0 : (triangles + 63) / 64;
    CHECK(mesh.clusters.clusters.size() == expected);
    for (std::size_t i = 0; i < triangles && expected > 0; ++i) {
      const Cluster& cluster = mesh.clusters.clusters[i / 64];
      const auto blocks = mesh.clusters.positions.of_cluster(i / 64);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t position = mesh.indices.positions[i * 3 + k];
        const Point<Object>& p = scene.meshes[0].positions[position];
        CHECK((cluster.low.x <= p.x && p.x <= cluster.high.x));
        CHECK((cluster.low.y <= p.y && p.y <= cluster.high.y));
        CHECK((cluster.low.z <= p.z && p.z <= cluster.high.z));
        CHECK(std::ranges::count(blocks, position / kTableBlock) == 1);
      }
    }
  }
}

TEST_CASE(
    "a cluster's cone holds the normals of all its triangles, and its two points lie on the sides "
    "that they say") {
  std::uint64_t with_cone = 0, without = 0;
  for (const double roughness : {0.0, 0.002, 0.02, 0.2, 1.0}) {
    const Scene scene = rough_ball(24, roughness, 5);
    const PreparedScene prepared = prepare_scene(scene, Transfer::kSrgb);
    const PreparedMesh& mesh = prepared.meshes[0];
    for (std::size_t i = 0; i < mesh.triangulation.triangles.size(); ++i) {
      const Cluster& cluster = mesh.clusters.clusters[i / 64];
      ++(cluster.cosine > 0 ? with_cone : without);
      if (cluster.cosine == 0) continue;
      const Triangle& t = mesh.triangulation.triangles[i];
      const auto a = corner(scene.meshes[0], t, 0), b = corner(scene.meshes[0], t, 1),
                 c = corner(scene.meshes[0], t, 2);
      const Vector<Object, double> newell = cross(b - a, c - a);
      const double size = std::sqrt(dot(newell, newell));
      const Vector<Object, double> axis = axis_of(cluster);
      // The roundings in these lines are below 2^-40.
      CHECK(dot(axis, newell) / size >= double(cluster.cosine));
      CHECK(size >= cluster.least_newell);
      const auto from = [&](double along) { return a - (centre_of(cluster) + axis * along); };
      CHECK(dot(from(cluster.along_backs), newell) >= 0);
      CHECK(dot(from(cluster.along_fronts), newell) <= 0);
      for (const auto& edge : {b - a, c - b, a - c}) {
        CHECK(std::sqrt(dot(edge, edge)) <= cluster.longest_edge);
      }
    }
  }
  CHECK(with_cone > 10000);
  CHECK(without > 1000);
}

TEST_CASE(
    "half of a closed surface's clusters are turned away, and their vertices are not carried "
    "over") {
  const Scene scene = *make_builtin("sphere:128");
  RenderSettings settings;
  settings.cull = Cull::kBack;
  const View view = make_view(camera_for(scene, 4.0 / 3), 480, 360).value();
  const Statistics s = check_planned(scene, view, settings);
  CHECK(s.clusters_turned_away > s.clusters / 4);
  CHECK(s.left_out_in_clusters > s.triangles / 4);
  const Statistics all = counts_without_plan(scene, view, settings);
  CHECK(all.clusters == 0);
  CHECK(s.vertices < all.vertices * 3 / 4);
  CHECK(s.normals < all.normals);
  // Without the plan these triangles would have been culled by their area on the screen, or had no
  // area.
  CHECK(s.culled + s.zero_area + s.left_out == all.culled + all.zero_area);
  CHECK(s.set_up == all.set_up);
}

TEST_CASE("clusters beside the picture are left out, those within it are not") {
  // Seen from the middle of the surface, all of whose faces show their backs: the picture shows
  // about a tenth of it.
  const Scene scene = rough_ball(40, 0.05, 7);
  for (const Cull cull : {Cull::kNone, Cull::kBack, Cull::kFront}) {
    RenderSettings settings;
    settings.cull = cull;
    const Statistics s = check_planned(scene, planned_view(), settings);
    CHECK(s.clusters_outside > s.clusters / 2);
    CHECK(s.clusters_outside < s.clusters);
    CHECK((s.clusters_turned_away > 0) == (cull == Cull::kBack));
  }
}

TEST_CASE(
    "a cluster that a plane cuts is not said to be turned away, since its pieces may be slivers") {
  // The near plane cuts the far half of a ball, where all clusters show their backs.
  Scene scene = *make_builtin("sphere:128");
  add_instance_at(scene, 0, {0, 0, -3});
  scene.instances.erase(scene.instances.begin());
  const View view = planned_view(PerspectiveLens{kDegrees45, 3.5, 20}, 640, 480);
  RenderSettings settings;
  settings.cull = Cull::kBack;
  const PlannedScene planned = plan_of(scene, view, settings);
  const Draw& draw = planned.list.draws[0];
  const ClusterCull test(draw, view, settings.cull, planned.plan.methods[0].classification.inside);
  int cut = 0, turned_away = 0;
  for (const Cluster& cluster : draw.prepared->clusters.clusters) {
    Box<Object> box;
    box.include(cluster.low);
    box.include(cluster.high);
    const bool is_cut =
        classify_box(box, draw.clip_from_anchored, render_planes(view)) == ClipVerdict::kClip;
    const ClusterVerdict verdict = test.classify(cluster);
    if (is_cut) CHECK(verdict != ClusterVerdict::kTurnedAway);
    cut += is_cut;
    turned_away += verdict == ClusterVerdict::kTurnedAway;
  }
  CHECK(cut > 10);
  CHECK(turned_away > 10);
  check_planned(scene, view, settings);
}

// Compares the bounds of a cluster with those of its triangles one by one, which other tests have
// proved correct.
TEST_CASE(
    "each triangle of a cluster that is turned away is so by more than its own margin (S4-13)") {
  std::uint64_t turned_away = 0, drawn = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    Scene scene = rough_ball(24, seed % 2 == 0 ? 0 : 0.01, seed);
    const auto stretch = [&] {
      const double size = random.between(0.1, 2);
      return random.integer(0, 1) == 0 ? -size : size;
    };
    const double x = random.between(-1, 1), z = random.between(-12, -2);
    const double wide = stretch(), high = stretch(), deep = stretch();
    const auto placed = translate<World, World>({x, 0, z}) * scale<World, Object>(wide, high, deep);
    scene.nodes[0] = Node{"placed", kNone, placed, placed};
    const Lens lens = seed % 3 == 0 ? Lens(OrthographicLens{2, 0.1, 40})
                                    : Lens(PerspectiveLens{random.between(0.1, 2.5), 0.1, 40.0});
    const int width = int(random.integer(40, 1000)), height = int(random.integer(40, 1000));
    const View view = planned_view(lens, width, height);
    const PlannedScene planned = plan_of(scene, view);
    const Draw& draw = planned.list.draws[0];
    for (const Cull cull : {Cull::kBack, Cull::kFront}) {
      const ObjectCulling culling = certain_culling(draw, view, cull);
      REQUIRE(culling.test);
      const std::vector<Triangle>& triangles = draw.triangulation->triangles;
      const std::vector<Cluster>& clusters = draw.prepared->clusters.clusters;
      for (std::size_t i = 0; i < clusters.size(); ++i) {
        const bool removed = culling.test->removes_all(clusters[i]);
        ++(removed ? turned_away : drawn);
        if (!removed) continue;
        const std::size_t first = i * kClusterTriangles;
        for (std::size_t t = first; t < std::min(first + kClusterTriangles, triangles.size());
             ++t) {
          const auto at = [&](std::size_t k) {
            return draw.mesh->positions[draw.mesh->corners[triangles[t].corners[k]].position];
          };
          if (!culling.test->removes({at(0), at(1), at(2)})) FAIL_CHECK("triangle " << t);
        }
      }
    }
  }
  WARN(turned_away << " clusters turned away, " << drawn << " drawn");
  CHECK(turned_away > 1000);
  CHECK(drawn > 1000);
}

TEST_CASE(
    "a ball of two-sided faces that lies across the picture's edge is asked, and loses what lies "
    "beyond") {
  Material both_sides;
  both_sides.double_sided = true;
  Scene scene = rough_ball(20, 0.1, 11, both_sides);
  add_instance_at(scene, 0, {3.1, 0, -5});
  scene.instances.erase(scene.instances.begin());
  const Statistics s = check_planned(scene, planned_view());
  CHECK(s.plane_tests == 0);
  CHECK(s.clusters_outside > 0);
  CHECK(s.clusters_turned_away == 0);
}

// ---- random scenes ----

struct Case {
  Scene scene;
  View view;
  RenderSettings settings;
};

// Rough balls from very near and far: whole, cut, outside the picture, mirrored, sheared, or far
// from their origin.
Case random_case(Random& random) {
  Case c;
  Material material;
  material.double_sided = random.integer(0, 7) == 0;
  const double roughness = random.integer(0, 1) == 0 ? 0.001 : random.between(0, 0.5);
  const int rings = int(random.integer(10, 24));
  c.scene = rough_ball(rings, roughness, random.bits(), material);
  const double offset = random.integer(0, 3) == 0 ? random.between(-1000, 1000) : 0;
  for (Point<Object>& p : c.scene.meshes[0].positions) p.x = float(double(p.x) + offset);

  const double size = random.scaled(0.5, 1, -6, 4);
  const auto stretch = [&] {
    const double factor = size * random.between(0.05, 1);
    return random.integer(0, 2) == 0 ? -factor : factor;
  };
  const double distance = -random.between(0, 12);
  const double x = random.between(-3, 3), y = random.between(-3, 3);
  const double wide = stretch(), high = stretch(), deep = stretch();
  auto placed = translate<World, World>({x, y, distance}) * scale<World, World>(wide, high, deep);
  placed.at(0, 1) += size * random.between(-0.5, 0.5);
  const auto centred = translate<World, Object>({-offset, 0, 0});
  const auto world_from_object = placed * centred;
  c.scene.nodes[0] = Node{"placed", kNone, world_from_object, world_from_object};

  const bool perspective = random.integer(0, 2) != 0;
  const Lens lens = perspective ? Lens(PerspectiveLens{random.between(0.05, 2.5), 0.1, 20.0})
                                : Lens(OrthographicLens{random.between(0.1, 6), 0.1, 20});
  c.settings.depth =
      random.integer(0, 3) == 0 ? DepthFormat::kFloat32Reversed : DepthFormat::kFloat32;
  const int width = int(random.integer(8, 200)), height = int(random.integer(8, 120));
  c.view = planned_view(lens, width, height,
                        c.settings.depth == DepthFormat::kFloat32Reversed ? DepthRange::kReversed
                                                                          : DepthRange::kStandard);
  const std::array<Cull, 4> culls{Cull::kMaterial, Cull::kBack, Cull::kFront, Cull::kNone};
  c.settings.cull = culls[std::size_t(random.integer(0, 3))];
  const std::array<int, 3> samples{1, 1, 4};
  c.settings.samples = samples[std::size_t(random.integer(0, 2))];
  c.settings.want_id = random.integer(0, 1) == 0 && c.settings.samples == 1;
  return c;
}

TEST_CASE("leaving clusters out changes no byte of random pictures of rough surfaces") {
  std::uint64_t outside = 0, away = 0, asked = 0;
  for (std::uint64_t seed = 0; seed < 1200 / kCaseDivisor; ++seed) {
    Random random(seed);
    const Case c = random_case(random);
    INFO("seed " << seed);
    const Rendering staged = render_staged(c.scene, c.view, c.settings);
    const Rendering tiled = render_tiled(c.scene, c.view, c.settings);
    const std::string difference =
        planes_differ(staged.buffers, tiled.buffers, c.settings.want_depth);
    if (!difference.empty()) FAIL_CHECK(difference);
    asked += tiled.statistics.clusters;
    outside += tiled.statistics.clusters_outside;
    away += tiled.statistics.clusters_turned_away;
  }
  WARN("of " << asked << " clusters " << outside << " outside, " << away << " turned away");
  CHECK(outside > 5000 / kCaseDivisor);
  CHECK(away > 1000 / kCaseDivisor);
}

TEST_CASE("both eyes of a pair leave out what they do not see, and carry over what either does") {
  const PairCase c = pair_case("sphere:256", 0.4, 320, 240);
  RenderSettings settings;
  settings.cull = Cull::kBack;
  Renderer tiled(c.scene, Transfer::kSrgb, EngineKind::kTile);
  Renderer staged(c.scene, Transfer::kSrgb, EngineKind::kStaged);
  const StereoRendering both = tiled.render_pair(c.centre, c.pair, {settings});
  const StereoRendering expected = staged.render_pair(c.centre, c.pair, {settings});
  CHECK(both.left.color == expected.left.color);
  CHECK(both.right.color == expected.right.color);
  const Statistics &left = both.left_statistics, &right = both.right_statistics;
  CHECK(left.clusters_turned_away > 0);
  CHECK(right.clusters_turned_away > 0);
  CHECK(left.clusters_turned_away != right.clusters_turned_away);
  CHECK(left.vertices == right.moved_in_x);
}

TEST_CASE("explain says which meshes are asked cluster by cluster") {
  const View view = planned_view();
  const Scene scene = rough_ball(20, 0.1, 11);
  CHECK_FALSE(decision(scene, view, "triangles out of sight").needed);
  RenderSettings wireframe;
  wireframe.wireframe = true;
  CHECK(decision(scene, view, "triangles out of sight", wireframe).needed);
  Material both_sides;
  both_sides.double_sided = true;
  Scene in_picture = rough_ball(20, 0.1, 11, both_sides);
  add_instance_at(in_picture, 0, {0, 0, -5});
  in_picture.instances.erase(in_picture.instances.begin());
  CHECK(decision(in_picture, view, "triangles out of sight").because ==
        "its box is inside the picture, and both sides of its faces are drawn");
  CHECK(check_planned(in_picture, view).clusters == 0);
  Scene with_line = scene;
  with_line.meshes[0].lines.push_back({Corner{0}, Corner{1}});
  CHECK(decision(with_line, view, "triangles out of sight").needed);
  check_planned(with_line, view);
}

}  // namespace
}  // namespace glassbox
