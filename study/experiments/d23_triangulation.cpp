// Compares ways to triangulate, for parallel axes up to cameras that face each other (D-23).
#include <cmath>
#include <numbers>

#include "study/experiment/experiment.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/memoize.h"
#include "study/scenes/two_cameras.h"

namespace glassbox::study {
namespace d23 {

constexpr double kNoise = 1;  // in px
constexpr double kPi = std::numbers::pi;

struct Setup {
  views::StereoRig rig;
  views::Vector3d point;
};

// A point at distance 6 in front of the left camera. The right camera is `away` from the point, at
// this angle around it, and looks at it.
Setup converging(double degrees, double away) {
  const double half = degrees * kPi / 360, sine = std::sin(2 * half), cosine = std::cos(2 * half);
  const views::Vector3d point(0, 0, 6), centre(away * sine, 0, 6 - away * cosine);
  return {rig_at(centre, turned_by(0, std::tan(half), 0)), point};
}

// The mean and the root mean square of the errors of triangulated points, if the pixels have noise.
// The point is in the middle of both pictures.
struct Spread {
  views::Vector3d mean = views::Vector3d::Zero();
  double rms = 0;
};
Spread spread_of(const Setup& setup, views::Triangulator triangulator, int samples) {
  Random random(23);
  Spread spread;
  for (int i = 0; i < samples; ++i) {
    const views::Match pixels = project_match(setup.rig, setup.point, kNoise, random);
    const views::Vector3d off =
        views::triangulate(triangulator, pixels, setup.rig).point.head<3>() - setup.point;
    spread.mean += off / samples;
    spread.rms += off.squaredNorm() / samples;
  }
  spread.rms = std::sqrt(spread.rms);
  return spread;
}

double predicted_rms(const Setup& setup) {
  return std::sqrt(views::covariance_of(setup.point, setup.rig, kNoise).trace());
}

std::vector<Configuration> configurations(Effort effort) {
  const int samples = effort == Effort::kQuick ? 500 : 20'000;
  std::vector<Configuration> all;
  for (const views::Triangulator triangulator : views::kTriangulators) {
    for (const double away : {6.0, 1.0}) {
      for (const double degrees : {1.0, 5.0, 20.0, 60.0, 90.0, 120.0}) {
        const Setup setup = converging(degrees, away);
        Random random(24);
        std::vector<views::Match> pixels;
        for (int i = 0; i < 64; ++i)
          pixels.push_back(project_match(setup.rig, setup.point, kNoise, random));
        all.push_back(
            {.series = views::name_of(triangulator),
             .parameter = degrees,
             .scene = away == 6 ? "both cameras equally far away" : "one camera six times nearer",
             .error = [=] { return spread_of(setup, triangulator, samples).rms; },
             .predicted_error = predicted_rms(setup),
             .work = repeated_work(4, pixels,
                                   [=](const views::Match& match) {
                                     return views::triangulate(triangulator, match, setup.rig);
                                   }),
             .items = 256});
      }
    }
  }
  return all;
}

}  // namespace d23

Experiment d23_triangulation() {
  using namespace d23;
  return {.id = "D-23",
          .name = "Triangulation: where two lines of sight meet",
          .question = "Which way to triangulate is best, and where does it matter?",
          .axis = "angle between the lines of sight",
          .axis_unit = "degrees",
          .error = "RMS distance from the point, for a noise of 1 px",
          .error_unit = "world units",
          .reference =
              "the true point, 6 in front of a camera of 640 x 480 pixels and focal length 800",
          .theory =
              "The best estimate has the covariance (J^T J)^-1 sigma^2 to first order, where J has "
              "the derivatives of the four pixel coordinates with respect to the point (S2-13 in "
              "docs/references.md)",
          .item = "point",
          .configurations = configurations};
}

}  // namespace glassbox::study
