#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>

#include "study/extremes/common/extreme_case.h"
#include "views/voxels/traversal.h"

namespace glassbox::study {
namespace c90 {

using views::Vector3d;
using Cameras = std::vector<Vector3d>;
// Returns a direction of visiting in which voxels come before the voxels that they hide; nothing if
// there is none.
using OrderOf = std::optional<Vector3d> (*)(const Cameras& cameras);

const Vector3d kLow(-1, -1, -1), kHigh(1, 1, 1);

Cameras ring(double height) {
  Cameras cameras;
  for (int i = 0; i < 16; ++i) {
    const SinCos turn = sin_cos_degrees(22.5 * i);
    cameras.emplace_back(4 * turn.cos, height, 4 * turn.sin);
  }
  return cameras;
}

std::optional<Vector3d> by_classes(const Cameras& cameras) {
  return views::classify(cameras, kLow, kHigh).direction;
}
Vector3d away_from_mean(const Cameras& cameras) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& camera : cameras) mean += camera / double(cameras.size());
  return (kLow + kHigh) / 2 - mean;
}
// Returns the direction away from the mean of the cameras, even if they are all around the box.
std::optional<Vector3d> whatever(const Cameras& cameras) {
  return away_from_mean(cameras);
}
// Tests only whether the cameras are in front of the middle of the box; some corners of the box may
// be nearer.
std::optional<Vector3d> before_the_middle(const Cameras& cameras) {
  const Vector3d direction = away_from_mean(cameras);
  for (const Vector3d& camera : cameras) {
    if (!(direction.dot(-camera) > 0)) return std::nullopt;
  }
  return direction;
}
// Uses only the first camera, although the order must be right for all cameras.
std::optional<Vector3d> direction_of_first_camera(const Cameras& cameras) {
  return views::classify({cameras.front()}, kLow, kHigh).direction;
}

Outcome measure_error(OrderOf order_of) {
  Random random(90);
  std::int64_t counterexamples = 0, tried = 0;
  int missed = 0;
  const auto anywhere = [&](double far) {
    return Vector3d{random.between(-far, far), random.between(-far, far),
                    random.between(-far, far)};
  };
  std::vector<Cameras> all{ring(0), ring(0.5), ring(3), ring(-3)};
  // Six cameras beyond a plane at a random distance from the middle of the box; with most of these
  // planes, a corner of the box is on the cameras' side.
  for (int i = 0; i < 40; ++i) {
    const Vector3d beyond = anywhere(1).normalized();
    const double least = beyond.cwiseAbs().sum() * random.between(0.2, 1.4);
    Cameras& cameras = all.emplace_back();
    for (int k = 0; k < 6; ++k) {
      const Vector3d place = anywhere(5);
      cameras.push_back(place + (least + random.unit() - beyond.dot(place)) * beyond);
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Cameras& cameras = all[i];
    const auto order = order_of(cameras);
    // Among the four rings, only those above and below the box (2 and 3) have an order of visiting.
    missed += !order && (i == 2 || i == 3);
    if (!order) continue;
    for (int pair = 0; pair < 400; ++pair) {
      const Vector3d q = anywhere(1);
      const Vector3d& camera =
          cameras[std::size_t(random.integer(0, std::int64_t(cameras.size()) - 1))];
      const Vector3d p = camera + random.between(0.01, 0.99) * (q - camera);
      if (p.cwiseAbs().maxCoeff() > 1) continue;
      counterexamples += !(order->dot(p) < order->dot(q));
      ++tried;
    }
  }
  return must_be_zero(
      double(counterexamples + missed),
      fmt::format("{} of {} pairs are in the wrong order, and in {} scenes no order was found",
                  counterexamples, tried, missed));
}

}  // namespace c90

ExtremeCase c90_ordinal_violation() {
  using namespace c90;
  return {
      .id = "C-90",
      .name = "Cameras all around: no order",
      .construction =
          "rings of 16 cameras around, above and below a box, and 40 sets of 6 beyond a plane that "
          "may cut it; points P on the way from a camera to Q, both in the box",
      .stage = "voxels",
      .right_answer =
          "if the code gives an order, P comes before Q, because a plane separates all cameras "
          "from the box (S1-15); for a ring of cameras around the box there is no order",
      .unit = "pairs and orders",
      .oracle = Oracle::kProperty,
      .ours =
          {"a plane between cameras and box, checked for every camera and every corner of the box",
           [] { return measure_error(by_classes); }},
      .naive = {"layers away from the centre of the cameras, without a check",
                [] { return measure_error(whatever); }},
      .mutants = {{"only the centre of the box is checked, not its corners",
                   [] { return measure_error(before_the_middle); }},
                  {"only the first camera is checked",
                   [] { return measure_error(direction_of_first_camera); }}},
      .not_drawn = "the case reconstructs a shape from given pictures; no engine draws the result",
  };
}

}  // namespace glassbox::study
