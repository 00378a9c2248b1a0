#include <Eigen/LU>

#include <glassbox/base/random.h>
#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/look_at.h>

#include "study/extremes/common/extreme_case.h"
#include "views/layers/layer_camera.h"

namespace glassbox::study {
namespace c37 {

constexpr double kNear = 0.01, kFar = 1000;  // far/near is 1e5
constexpr int kWidth = 640, kHeight = 480;

View view_from(const Point<World, double>& eye) {
  Camera camera;
  camera.lens = PerspectiveLens{1, kNear, kFar};
  camera.world_from_eye = camera_pose(eye, Point<World, double>(0, 0, -600), {0, 1, 0}).value();
  return make_view(camera, kWidth, kHeight).value();
}

// A position in a picture and a depth in float, as a layered depth image stores them.
struct Stored {
  double x, y;  // px
  float depth;
};

// How points are stored, and how a point of the first picture is warped to the second.
struct StoreAndWarp {
  Stored (*store)(const Eigen::Vector4d& in_first);
  Eigen::Vector4d (*warp)(const Eigen::Matrix4d& to, const Eigen::Matrix4d& from,
                          const Stored& sample);
};

Outcome measure_error(auto store_by, auto warp_by) {
  const StoreAndWarp method{store_by, warp_by};
  const Eigen::Matrix4d from = views::layer_camera(view_from({0, 0, 0})).screen_from_world;
  const Eigen::Matrix4d to = views::layer_camera(view_from({120, 40, -60})).screen_from_world;
  const Eigen::Matrix4d warp = to * from.inverse();
  const double condition = from.norm() * from.inverse().norm();
  WorstError worst;
  Random random(37);
  for (int i = 0; i < 400; ++i) {
    // Distances along the gaze from 100 to 900 units, evenly spaced in the logarithm.
    const double z = 100 * std::pow(9, i / 399.0);
    const Eigen::Vector4d world{random.between(-0.4, 0.4) * z, random.between(-0.3, 0.3) * z, -z,
                                1};
    const Eigen::Vector4d first = from * world, second = to * world;
    if (!(second.w() > 40)) continue;
    const Stored sample = method.store(first);
    const Eigen::Vector4d there = method.warp(to, from, sample);
    const double error = std::max(std::abs(there.x() / there.w() - second.x() / second.w()),
                                  std::abs(there.y() / there.w() - second.y() / second.w()));
    // The warp maps a stored depth z to the position x2 = (a + b z)/(c + d z) in the second
    // picture. A relative error of 2^-24 of z moves x2 by 2^-24 |z dx2/dz|, with z dx2/dz = z (b -
    // x2 d)/(c + d z).
    const double depth = first.z() / first.w(), w = second.w() / first.w();
    const double moved =
        std::max(std::abs(depth * (warp(0, 2) - second.x() / second.w() * warp(3, 2)) / w),
                 std::abs(depth * (warp(1, 2) - second.y() / second.w() * warp(3, 2)) / w));
    // The inverse and three products in double have 32 rounding errors of 2^-53, multiplied by the
    // condition number of the first camera's matrix.
    const double bound = unit_roundoff<float> * moved + 0x1p-48 * condition * kWidth;
    worst.add(error, bound, fmt::format("distance {:.4g}", z), condition);
  }
  return worst.outcome();
}

Stored near_over_distance(const Eigen::Vector4d& in_first) {
  return {in_first.x() / in_first.w(), in_first.y() / in_first.w(),
          float(in_first.z() / in_first.w())};
}
// Computes the standard depth f/(f - n) (1 - n/d) for the distance d and planes at n and f, from
// the stored n/d.
Stored standard_depth(const Eigen::Vector4d& in_first) {
  const Stored ours = near_over_distance(in_first);
  return {ours.x, ours.y, float(kFar / (kFar - kNear) * (1 - in_first.z() / in_first.w()))};
}
Eigen::Matrix4d with_standard_depth(Eigen::Matrix4d camera) {
  camera.row(2) = kFar / (kFar - kNear) * (camera.row(3) - camera.row(2)).eval();
  return camera;
}

Eigen::Vector4d in_double(const Eigen::Matrix4d& to, const Eigen::Matrix4d& from, const Stored& s) {
  const views::LayerCamera first{from, kWidth, kHeight}, second{to, kWidth, kHeight};
  return views::warp_matrix(second, first) * Eigen::Vector4d(s.x, s.y, double(s.depth), 1);
}
Eigen::Vector4d standard_in_double(const Eigen::Matrix4d& to, const Eigen::Matrix4d& from,
                                   const Stored& s) {
  return in_double(with_standard_depth(to), with_standard_depth(from), s);
}
Eigen::Vector4d inverse_in_float(const Eigen::Matrix4d& to, const Eigen::Matrix4d& from,
                                 const Stored& s) {
  const Eigen::Matrix4f inverse = from.cast<float>().inverse();
  const Eigen::Matrix4f warp = to.cast<float>() * inverse;
  const Eigen::Vector4f there = warp * Eigen::Vector4f(float(s.x), float(s.y), s.depth, 1);
  return there.cast<double>();
}
Eigen::Vector4d all_in_float(const Eigen::Matrix4d& to, const Eigen::Matrix4d& from,
                             const Stored& s) {
  return inverse_in_float(with_standard_depth(to), with_standard_depth(from), s);
}

}  // namespace c37

ExtremeCase c37_layers_inverse() {
  using namespace c37;
  return {
      .id = "C-37",
      .name = "A layered image's inverse camera",
      .construction =
          "near plane 0.01, far plane 1000, 640 x 480 px; 400 points 100 .. 900 units away are "
          "stored as pixel and float depth, and warped to an eye 140 units away",
      .stage = "layers",
      .right_answer =
          "the error is at most 2^-24 of the distance by which the depth moves the point, for the "
          "rounding of the depth, plus 2^-48 times the condition number of C1, for an inverse in "
          "double; depth is near/distance",
      .unit = "px",
      .oracle = Oracle::kAnalytic,
      .ours = {"depth is near/distance, and the inverse C1^-1 is computed in double",
               [] { return measure_error(near_over_distance, in_double); }},
      .naive = {"depth is 0..1, and all is computed in float",
                [] { return measure_error(standard_depth, all_in_float); }},
      .mutants = {{"depth is 0..1, and the inverse C1^-1 is computed in double",
                   [] { return measure_error(standard_depth, standard_in_double); }},
                  {"depth is near/distance, and the inverse C1^-1 is computed in float",
                   [] { return measure_error(near_over_distance, inverse_in_float); }}},
      .not_drawn = "views/layers warps the samples; no engine of glassbox render takes part",
  };
}

}  // namespace glassbox::study
