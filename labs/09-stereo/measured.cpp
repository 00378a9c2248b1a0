// Lab 9 in the chart of the experiment on culling a stereo pair (D-10): how many pixels are missing
// in both eyes' pictures if the student's function culls the triangles.
#include <memory>

#include "labs/measuring/measuring.h"
#include "study/experiments/d10_lost_pixels.h"

#include <glassbox/mesh/builtin/forest.h>

namespace glassbox::labs {

namespace lab_09_measured {

using namespace study::d10;

constexpr double kCull = 2;  // the value of lab_09::Verdict::kCull

// The corners of all triangles, draw after draw, for the student's program.
Numbers question(const Eyes& eyes) {
  Numbers numbers;
  for (std::size_t draw = 0; draw < eyes.list.draws.size(); ++draw) {
    const Draw& d = eyes.list.draws[draw];
    for (const Triangle& triangle : d.triangulation->triangles) {
      for (const std::uint32_t corner : triangle.corners) {
        const std::uint32_t position = d.mesh->corners[corner].position;
        const Point<Clip>&left = eyes.left_clip[draw].positions[position],
              &right = eyes.right_clip[draw].positions[position];
        numbers.insert(numbers.end(), {double(left.x), double(right.x), double(left.y),
                                       double(left.z), double(left.w)});
      }
    }
  }
  return numbers;
}

// The number of triangles that the experiment's own method culls, because no eye sees them.
double count_invisible_triangles(const Eyes& eyes) {
  double culled = 0;
  for (std::size_t draw = 0; draw < eyes.list.draws.size(); ++draw) {
    DrawKeepFlags kept;
    cull_by_union(eyes, draw, kept);
    for (const std::uint8_t is_kept : kept.left) culled += is_kept == 0;
  }
  return culled;
}

// The number of lost pixels for each row and eye. It is NaN if the answer is too short, or if it
// culls less than half of the triangles that no eye sees: a function that culls nothing would lose
// nothing and take no time.
Result<double> measure_lost_columns(const Ask& ask, const Eyes& eyes) {
  const auto answers = ask({question(eyes)});
  if (!answers) return tl::unexpected(answers.error());
  std::vector<DrawKeepFlags> kept(eyes.list.draws.size());
  std::size_t at = 0;
  double culled = 0;
  for (std::size_t draw = 0; draw < kept.size(); ++draw) {
    for (std::size_t i = 0; i < eyes.list.draws[draw].triangulation->triangles.size(); ++i) {
      const double verdict = number_of(answers->front(), at++);
      if (verdict != verdict) return verdict;
      culled += verdict == kCull;
      kept[draw].left.push_back(verdict != kCull);
    }
  }
  if (culled < count_invisible_triangles(eyes) / 2) return number_of({}, 0);
  return lost_columns(eyes, kept);
}

std::vector<MeasuredPoint> measured_points() {
  std::vector<MeasuredPoint> all;
  const auto add = [&](const char* scene, std::shared_ptr<const Eyes> eyes, double share) {
    const Numbers timed = question(*eyes);
    all.push_back({"yours", 100 * share, scene, "",
                   [eyes](const Ask& ask) { return measure_lost_columns(ask, *eyes); }, timed,
                   double(timed.size() / 15)});
  };
  const View view = centre_view();
  for (const double share : {0.01, 0.03, 0.1}) {
    const StereoPair pair{share * kWindow, kWindow};
    add("strips in front of the window", make_eyes(strips(6), view, pair), share);
    add("strips behind the window", make_eyes(strips(60), view, pair), share);
    Scene forest = make_forest();
    const View standing = make_view(forest.cameras.front(), kWidth, kHeight).value();
    add("forest", make_eyes(std::move(forest), standing, pair), share);
  }
  return all;
}

}  // namespace lab_09_measured

LabMeasure measured_09() {
  using namespace lab_09_measured;
  return {"D-10", "cull", measured_points};
}

}  // namespace glassbox::labs
