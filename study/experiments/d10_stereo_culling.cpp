// D-10: by which frustum a pair of eyes culls, and what is lost.
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/forest.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>
#include <glassbox/pipeline/stereo/culling.h>
#include <glassbox/render/draw_list.h>
#include <glassbox/render/tile/tile_engine.h>
#include <glassbox/render/vertex_stage.h>

#include "study/experiments/experiments.h"

namespace glassbox::study {

namespace {

constexpr int kWidth = 320, kHeight = 200;

struct Eyes {
  Scene scene;
  PreparedScene prepared;
  View centre, left, right;
  StereoPair pair;
  DrawList list;  // of the centre
  std::vector<Draw> left_draws, right_draws;
  // By draw: what the vertex stage makes of its positions.
  std::vector<ClipTable> centre_clip, left_clip, right_clip;
};

std::shared_ptr<const Eyes> make_eyes(Scene scene, const View& centre, const StereoPair& pair) {
  auto eyes = std::make_shared<Eyes>();
  eyes->scene = std::move(scene);
  eyes->prepared = prepare(eyes->scene, Transfer::kNone);
  eyes->centre = centre, eyes->pair = pair;
  eyes->left = eye_view(centre, pair, Side::kLeft),
  eyes->right = eye_view(centre, pair, Side::kRight);
  eyes->list = make_draw_list(eyes->scene, eyes->prepared, centre);
  eyes->left_draws = draws_of_other_eye(eyes->list.draws, eyes->scene, eyes->left);
  eyes->right_draws = draws_of_other_eye(eyes->list.draws, eyes->scene, eyes->right);
  for (std::size_t i = 0; i < eyes->list.draws.size(); ++i) {
    eyes->centre_clip.push_back(project_vertices(eyes->list.draws[i], centre));
    eyes->left_clip.push_back(project_vertices(eyes->left_draws[i], eyes->left));
    eyes->right_clip.push_back(project_vertices(eyes->right_draws[i], eyes->right));
  }
  return eyes;
}

// ---- the ways to cull: which triangles of a draw are submitted, to the left eye and to the right one ----

using Kept = std::vector<std::uint8_t>;
struct KeptOfDraw {
  Kept left, right;
};

template <class OutcodeOf, class Unseen>
void keep_by_outcodes(const Draw& draw, const OutcodeOf& outcode_of, const Unseen& unseen,
                      Kept& kept) {
  std::vector<Outcode> outcodes(draw.mesh->positions.size());
  for (std::size_t i = 0; i < outcodes.size(); ++i) outcodes[i] = outcode_of(i);
  for (const Triangle& triangle : draw.triangulation->triangles) {
    std::array<Outcode, 3> codes;
    for (std::size_t k = 0; k < 3; ++k)
      codes[k] = outcodes[draw.mesh->corners[triangle.corners[k]].position];
    kept.push_back(!unseen(codes));
  }
}

void cull_each_eye(const Eyes& eyes, std::size_t draw, KeptOfDraw& kept) {
  const auto planes = frustum_planes(eyes.centre.depth_range);
  const auto by = [&](const ClipTable& clip, Kept& eye) {
    keep_by_outcodes(
        eyes.list.draws[draw], [&](std::size_t i) { return outcode(clip.positions[i], planes); },
        [](const auto& codes) { return trivial_verdict(codes) == ClipVerdict::kReject; }, eye);
  };
  by(eyes.left_clip[draw], kept.left);
  by(eyes.right_clip[draw], kept.right);
}

void cull_by_centre(const Eyes& eyes, std::size_t draw, KeptOfDraw& kept) {
  const ClipTable& clip = eyes.centre_clip[draw];
  keep_by_outcodes(
      eyes.list.draws[draw],
      [&](std::size_t i) {
        return stereo_outcode(centre_clip_point(clip.positions[i]), eyes.centre);
      },
      [](const auto& codes) { return unseen_by_both(codes); }, kept.left);
}

void cull_by_union(const Eyes& eyes, std::size_t draw, KeptOfDraw& kept) {
  const ClipTable &left = eyes.left_clip[draw], &right = eyes.right_clip[draw];
  keep_by_outcodes(
      eyes.list.draws[draw],
      [&](std::size_t i) {
        return stereo_outcode(stereo_clip_point(left.positions[i], right.positions[i]),
                              eyes.centre);
      },
      [](const auto& codes) { return unseen_by_both(codes); }, kept.left);
}

// How far a ball's centre lies from a clip plane, in object space, less its radius: negative if all of it is outside.
double ball_distance(const ClipPlane& plane, const Transform<Clip, Object, float>& clip_from_object,
                     const Vector<Object, double>& centre, double radius) {
  std::array<double, 4> p;
  for (int column = 0; column < 4; ++column) {
    const auto m = [&](int row) { return double(clip_from_object.at(row, column)); };
    p[std::size_t(column)] = plane.a * m(0) + plane.b * m(1) + plane.c * m(2) + plane.d * m(3);
  }
  p[3] += plane.e;
  const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  return p[0] * centre.x + p[1] * centre.y + p[2] * centre.z + p[3] + radius * length;
}

// A ball about the box of the object, for all of its triangles at once; the rounding of the vertices is taken as 2^-16 of it.
void cull_by_ball(const Eyes& eyes, std::size_t draw, KeptOfDraw& kept) {
  const Draw& d = eyes.list.draws[draw];
  const Box<Object>& box = d.prepared->bounds;
  const auto half = [](double low, double high) { return (high - low) / 2; };
  const Vector<Object, double> size(half(box.low.x, box.high.x), half(box.low.y, box.high.y),
                                    half(box.low.z, box.high.z));
  const Vector<Object, double> centre(box.low.x + size.x - d.anchor.x,
                                      box.low.y + size.y - d.anchor.y,
                                      box.low.z + size.z - d.anchor.z);
  const double radius = std::sqrt(dot(size, size)) * (1 + 0x1p-16);
  const StereoPlanes planes = stereo_planes(eyes.centre);
  const auto outside = [&](const ClipPlane& plane, const Draw& eye) {
    return ball_distance(plane, eye.clip_from_anchored, centre, radius) < 0;
  };
  bool unseen = false;
  for (const ClipPlane& plane : planes.shared)
    unseen = unseen || outside(plane, eyes.left_draws[draw]);
  bool left = false, right = false;
  for (const ClipPlane& plane : planes.sides) {
    left = left || outside(plane, eyes.left_draws[draw]);
    right = right || outside(plane, eyes.right_draws[draw]);
  }
  kept.left.assign(d.triangulation->triangles.size(), !(unseen || (left && right)));
}

struct Way {
  const char* name;
  void (*cull)(const Eyes&, std::size_t, KeptOfDraw&);
};
constexpr Way kWays[] = {{"each eye by itself", cull_each_eye},
                         {"centre camera", cull_by_centre},
                         {"union, eight planes", cull_by_union},
                         {"union, ball of the object", cull_by_ball}};

std::vector<KeptOfDraw> cull(const Eyes& eyes, const Way& way) {
  std::vector<KeptOfDraw> kept(eyes.list.draws.size());
  for (std::size_t i = 0; i < kept.size(); ++i) way.cull(eyes, i, kept[i]);
  return kept;
}

// ---- what is lost ----

// The scene of those triangles that are kept, each draw with a mesh of its own.
Scene subset(const Eyes& eyes, const std::vector<KeptOfDraw>& kept, bool left) {
  Scene scene = eyes.scene;
  scene.meshes.clear();
  scene.instances.clear();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Draw& draw = eyes.list.draws[i];
    const Kept& mine = left || kept[i].right.empty() ? kept[i].left : kept[i].right;
    Mesh mesh = *draw.mesh;
    mesh.faces.clear();
    mesh.corners.clear();
    for (std::size_t t = 0; t < mine.size(); ++t) {
      if (!mine[t]) continue;
      mesh.faces.push_back({std::uint32_t(mesh.corners.size()), 3});
      for (const std::uint32_t corner : draw.triangulation->triangles[t].corners)
        mesh.corners.push_back(draw.mesh->corners[corner]);
    }
    if (mesh.faces.empty()) continue;
    scene.instances.push_back(
        {std::uint32_t(scene.meshes.size()), eyes.scene.instances[draw.instance].node});
    scene.meshes.push_back(std::move(mesh));
  }
  return scene;
}

RenderSettings distances_only() {
  RenderSettings settings;
  settings.mask = {false, false, false, false};
  settings.want_distance = settings.want_id = true;
  return settings;
}

Framebuffer draw(const Scene& scene, const View& view) {
  return render_tiled(scene, view, distances_only(), {.threads = 1}).buffers;
}

// Per row and eye.
double lost_columns(const Eyes& eyes, const Way& way) {
  const std::vector<KeptOfDraw> kept = cull(eyes, way);
  double lost = 0;
  for (const bool left : {true, false}) {
    const View& view = left ? eyes.left : eyes.right;
    const Image<float> all = draw(eyes.scene, view).distance,
                       drawn = draw(subset(eyes, kept, left), view).distance;
    for (std::size_t i = 0; i < all.pixels.size(); ++i) lost += all.pixels[i] != drawn.pixels[i];
  }
  return lost / (2 * kHeight);
}

// One rectangle each: ground and sky, which are never wholly outside.
bool is_backdrop(const Eyes& eyes, std::uint32_t id) {
  for (const Draw& draw : eyes.list.draws) {
    const std::uint32_t number = id - 1, count = draw.triangulation->numbered;
    if (number >= draw.first_number && number < draw.first_number + count) return count <= 2;
  }
  return false;
}

// Pixels whose point the centre camera has beside its picture, by the parallax of their distance, backdrops left out; per row
// and eye.
double strip_columns(const Eyes& eyes) {
  double beside = 0;
  for (const bool left : {true, false}) {
    const Framebuffer all = draw(eyes.scene, left ? eyes.left : eyes.right);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const double z = double(all.distance.at(x, y));
        if (!std::isfinite(z)) continue;
        const double half = parallax_at(eyes.centre, eyes.pair, z).px / 2;
        const double centre_x = x + 0.5 + (left ? half : -half);
        beside += (centre_x < 0 || centre_x > kWidth) && !is_backdrop(eyes, all.id.at(x, y));
      }
    }
  }
  return beside / (2 * kHeight);
}

// ---- scenes ----

constexpr double kWindow = 12;

View centre_view() {
  Camera camera;
  camera.lens = PerspectiveLens{0.785398163397448309616, 0.5, 200.0};
  return make_view(camera, kWidth, kHeight).value();
}

// Thin upright strips, a quarter of a pixel wide, across more than the picture, `distance` away.
Scene strips(double distance) {
  Scene scene;
  add_material(scene, "flat", {1, 1, 1, 1});
  scene.materials.front().unlit = true;
  const double height = distance * tan_half_degrees(45), pixel = 2 * height / kHeight;
  Mesh mesh;
  for (int i = -4 * 220; i < 4 * 220; ++i)
    add_rectangle(mesh, {i * pixel / 4, -2 * height, -distance}, {pixel / 4, 0, 0},
                  {0, 4 * height, 0});
  add_object(scene, std::move(mesh));
  return scene;
}

void add_scene(const std::string& name, const std::shared_ptr<const Eyes>& eyes, double share,
               double predicted, const char* finding, std::vector<Configuration>& all) {
  double triangles = 0;
  for (const Draw& draw : eyes->list.draws)
    triangles += double(draw.triangulation->triangles.size());
  for (const Way& way : kWays) {
    const bool loses = way.cull == cull_by_centre;
    all.push_back({.series = way.name,
                   .parameter = 100 * share,
                   .scene = name,
                   .error = [=] { return lost_columns(*eyes, way); },
                   .predicted_error = loses ? predicted : 0,
                   .finding = loses ? finding : "",
                   .work = [=](int) { cull(*eyes, way); },
                   .items = triangles});
  }
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<double> shares{0.01, 0.03, 0.1};
  if (effort == Effort::kFull) shares = {0.01, 0.015, 0.02, 0.03, 0.05, 0.07, 0.1};
  std::vector<Configuration> all;
  const View view = centre_view();
  for (const double share : shares) {
    const StereoPair pair{share * kWindow, kWindow};
    for (const auto& [name, distance] :
         {std::pair{"strips in front of the window", 6.0}, {"strips behind the window", 60.0}})
      add_scene(name, make_eyes(strips(distance), view, pair), share,
                missing_strip_px(view, pair, distance), "", all);
    Scene forest = make_forest();
    const View standing = make_view(forest.cameras.front(), kWidth, kHeight).value();
    const auto eyes = make_eyes(std::move(forest), standing, pair);
    add_scene("forest", eyes, share, strip_columns(*eyes),
              "a triangle that reaches into the centre's picture is drawn whole, and those of near "
              "trees are wider than the strip",
              all);
  }
  return all;
}

}  // namespace

Experiment d10_stereo_culling() {
  return {
      .id = "D-10",
      .name = "Stereo culling: by whose frustum",
      .question =
          "What do the eyes miss when one frustum culls for both, and what does it cost to miss "
          "nothing?",
      .axis = "half the separation of the eyes over the distance of the window",
      .axis_unit = "%",
      .error = "columns of the picture that show something else, per row and eye",
      .error_unit = "px",
      .reference = "both eyes' pictures with nothing culled",
      .theory =
          "The centre's frustum ends half the parallax short of each eye's at one side: (W/2)(d/h) "
          "s |1/z - 1/f| columns (S0-04); in the forest the pixels of trees for which that holds "
          "at their own distance. The others are "
          "conservative: 0.",
      .item = "triangle",
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
