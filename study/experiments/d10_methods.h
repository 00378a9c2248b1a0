// The methods to cull a stereo pair (D-10): which triangles of a draw each one submits to the left
// and to the right eye.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <glassbox/pipeline/stereo/culling.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox::study::d10 {

inline constexpr int kWidth = 320, kHeight = 200;

struct Eyes {
  Scene scene;
  PreparedScene prepared;
  View centre, left, right;
  StereoPair pair;
  DrawList list;  // the draws of the centre camera
  std::vector<Draw> left_draws, right_draws;
  // One entry per draw: the positions after the vertex stage.
  std::vector<ClipTable> centre_clip, left_clip, right_clip;
};

inline std::shared_ptr<const Eyes> make_eyes(Scene scene, const View& centre,
                                             const StereoPair& pair) {
  auto eyes = std::make_shared<Eyes>();
  eyes->scene = std::move(scene);
  eyes->prepared = prepare_scene(eyes->scene, Transfer::kNone);
  eyes->centre = centre, eyes->pair = pair;
  eyes->left = eye_view(centre, pair, Side::kLeft),
  eyes->right = eye_view(centre, pair, Side::kRight);
  eyes->list = make_draw_list(eyes->scene, eyes->prepared, centre);
  eyes->left_draws = draws_of_other_eye(eyes->list.draws, eyes->left);
  eyes->right_draws = draws_of_other_eye(eyes->list.draws, eyes->right);
  for (std::size_t i = 0; i < eyes->list.draws.size(); ++i) {
    eyes->centre_clip.push_back(project_vertices(eyes->list.draws[i], centre));
    eyes->left_clip.push_back(project_vertices(eyes->left_draws[i], eyes->left));
    eyes->right_clip.push_back(project_vertices(eyes->right_draws[i], eyes->right));
  }
  return eyes;
}

// ---- the methods to cull: the triangles of a draw that each eye gets ----

using KeepFlags = std::vector<std::uint8_t>;
struct DrawKeepFlags {
  KeepFlags left, right;
};

template <class OutcodeOf, class Unseen>
void keep_by_outcodes(const Draw& draw, const OutcodeOf& outcode_of, const Unseen& unseen,
                      KeepFlags& kept) {
  std::vector<Outcode> outcodes(draw.mesh->positions.size());
  for (std::size_t i = 0; i < outcodes.size(); ++i) outcodes[i] = outcode_of(i);
  for (const Triangle& triangle : draw.triangulation->triangles) {
    std::array<Outcode, 3> codes;
    for (std::size_t k = 0; k < 3; ++k)
      codes[k] = outcodes[draw.mesh->corners[triangle.corners[k]].position];
    kept.push_back(!unseen(codes));
  }
}

inline void cull_each_eye(const Eyes& eyes, std::size_t draw, DrawKeepFlags& kept) {
  const auto planes = frustum_planes(eyes.centre.depth_range);
  const auto by = [&](const ClipTable& clip, KeepFlags& eye) {
    keep_by_outcodes(
        eyes.list.draws[draw], [&](std::size_t i) { return outcode(clip.positions[i], planes); },
        [](const auto& codes) { return trivial_verdict(codes) == ClipVerdict::kReject; }, eye);
  };
  by(eyes.left_clip[draw], kept.left);
  by(eyes.right_clip[draw], kept.right);
}

inline void cull_by_centre(const Eyes& eyes, std::size_t draw, DrawKeepFlags& kept) {
  const ClipTable& clip = eyes.centre_clip[draw];
  keep_by_outcodes(
      eyes.list.draws[draw],
      [&](std::size_t i) {
        return stereo_outcode(centre_clip_point(clip.positions[i]), eyes.centre);
      },
      [](const auto& codes) { return is_outside_both_views(codes); }, kept.left);
}

inline void cull_by_union(const Eyes& eyes, std::size_t draw, DrawKeepFlags& kept) {
  const ClipTable &left = eyes.left_clip[draw], &right = eyes.right_clip[draw];
  keep_by_outcodes(
      eyes.list.draws[draw],
      [&](std::size_t i) {
        return stereo_outcode(stereo_clip_point(left.positions[i], right.positions[i]),
                              eyes.centre);
      },
      [](const auto& codes) { return is_outside_both_views(codes); }, kept.left);
}

// The distance of a ball's innermost point from a clip plane, up to a factor: the distance of the
// centre plus the radius. It is negative if the whole ball is outside.
inline double ball_distance(const ClipPlane& plane,
                            const Transform<Clip, Object, float>& clip_from_object,
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

// Tests a ball around the object's bounding box, for all of its triangles at once. The radius is
// increased by 2^-16 of it for the rounding errors of the vertices.
inline void cull_by_ball(const Eyes& eyes, std::size_t draw, DrawKeepFlags& kept) {
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

struct Method {
  const char* name;
  void (*cull)(const Eyes&, std::size_t, DrawKeepFlags&);
};
inline constexpr Method kMethods[] = {{"each eye by itself", cull_each_eye},
                                      {"centre camera", cull_by_centre},
                                      {"union, eight planes", cull_by_union},
                                      {"union, bounding sphere of the object", cull_by_ball}};

inline std::vector<DrawKeepFlags> cull(const Eyes& eyes, const Method& method) {
  std::vector<DrawKeepFlags> kept(eyes.list.draws.size());
  for (std::size_t i = 0; i < kept.size(); ++i) method.cull(eyes, i, kept[i]);
  return kept;
}

}  // namespace glassbox::study::d10
