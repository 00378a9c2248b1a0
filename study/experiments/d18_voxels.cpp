// Measures voxel colouring for different voxel sizes and numbers of pictures (D-18).
#include <cmath>
#include <memory>

#include "study/experiment/experiment.h"
#include "study/experiments/d18_ball.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/memoize.h"

namespace glassbox::study {
namespace d18 {

using views::ColoringSettings;

constexpr int kSide = 96, kPictures = 12;

struct Method {
  const char* name;
  void (*choose)(ColoringSettings&);
};
const Method kMethods[] = {
    {"centre", [](ColoringSettings&) {}},
    {"box", [](ColoringSettings& s) { s.sampled = views::Footprint::kBox; }},
    {"hull", [](ColoringSettings& s) { s.sampled = s.hidden = views::Footprint::kHull; }},
    {"centre, adaptive",
     [](ColoringSettings& s) {
       s.consistency = views::Consistency::kAdaptive;
       s.k1 = 1;
       s.k2 = 12;
     }},
    {"centre, CIELab", [](ColoringSettings& s) {
       s.space = views::ColorSpace::kLab;
       s.threshold = 12;
     }}};

struct Found {
  double surface = 0;   // mean distance of the voxels from the surface, in ball radii
  double left_out = 0;  // RMS error of the picture that is left out, in levels
  double looks = 0;     // number of examined voxels times number of pictures
};

// The picture that is left out of the reconstruction, to be compared with it, is that of a camera
// between two others.
Found found_by(const Method& method, int across, int pictures) {
  BallPictures shown = pictures_of(pictures, kSide, false);
  const views::CalibratedPicture left_out = shown.set.pictures.back();
  shown.set.pictures.pop_back();
  shown.distances.pop_back();
  views::ColoringRequest request = request_for(shown, across);
  method.choose(request.settings);
  const auto coloring = views::color_voxels(shown.set, request);
  if (!coloring) return {INFINITY, INFINITY, INFINITY};
  const views::VisibleSurface seen =
      views::visible_surface(shown.set, shown.distances, coloring->grid);
  const views::SurfaceErrors errors = views::surface_errors(coloring->voxels, seen);
  const auto drawn = views::draw_voxels(coloring->grid, coloring->voxels, left_out.camera, kSide,
                                        kSide, {0, 0, 0, 255});
  return {errors.from_truth_mean * request.voxel_size,
          views::voxel_picture_errors(drawn, left_out).rms,
          double(coloring->examined) * double(shown.set.pictures.size())};
}

// The mean distance of a random point in a cube from its centre is 0.480 of an edge (Robbins 1978):
// this error remains if the voxel of every point is coloured. A pixel has the colour of its centre,
// and the mean distance of its points from the centre is (sqrt 2 + ln(1 + sqrt 2))/6 = 0.383 px:
// even the smallest voxels have this error. The two errors are independent.
constexpr double kInCube = 0.4803, kInPixel = 0.3826;

double predicted_distance(int across) {
  const double pixel = 6 / (kSide * 2.6);  // in radii, at the ball's middle
  return std::hypot(kInCube * 2.0 / across, kInPixel * pixel);
}

// The predicted memory: for each pixel that was read a colour and a matte, and a word for the
// sweep; a byte for each tile of 4 x 4 pixels, and two words of bits for up to 64 such tiles of a
// row; a coloured voxel for each of the N^2 voxels of the cube's six faces (N: `across`); and the
// data of each voxel of the layer that is being examined.
double predicted_bytes(int across, int pictures, int side) {
  const double pixels = double(side) * side * pictures, face = double(across) * across;
  const double tiles = side / 4.0, words = std::ceil(tiles / 64);
  return pixels * (sizeof(Rgba8) + 1 + 4) + pictures * tiles * (tiles + 16 * words) +
         face * 6 * sizeof(views::ColoredVoxel) +
         face * (sizeof(views::Verdict) + sizeof(views::VoxelObservation) +
                 sizeof(views::VoxelPosition));
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<int> sizes{12, 16, 24, 32, 48};
  if (effort == Effort::kFull) sizes.insert(sizes.end(), {64, 96, 128});
  std::vector<Configuration> all;
  for (const int across : sizes) {
    for (const Method& method : kMethods) {
      const auto found = memoize([=] { return found_by(method, across, kPictures); });
      const auto shown = std::make_shared<BallPictures>(pictures_of(kPictures, kSide, false));
      shown->set.pictures.pop_back();
      views::ColoringRequest request = request_for(*shown, across);
      method.choose(request.settings);
      const double voxels = std::pow(across, 3.0);
      all.push_back(
          {.series = method.name,
           .parameter = double(across),
           .error = [=] { return found().surface; },
           .predicted_error = predicted_distance(across),
           .work = [=](int) { do_not_optimize(views::color_voxels(shown->set, request)); },
           .items = voxels * (kPictures - 1)});
      all.push_back(
          {.series = method.name, .parameter = double(across), .measure = "left out", .error = [=] {
             return found().left_out;
           }});
      all.push_back({.series = method.name,
                     .parameter = double(across),
                     .measure = "looks",
                     .error = [=] { return found().looks; },
                     .predicted_error = voxels * (kPictures - 1)});
    }
  }
  // The pictures have twice as many pixels across as the ball has voxels.
  for (const int across : {16, 32, 64, 128}) {
    const int side = 2 * across;
    all.push_back({.series = "centre",
                   .parameter = double(across),
                   .measure = "memory",
                   .error =
                       [=] {
                         const BallPictures shown = pictures_of(4, side, false);
                         return double(
                             views::plan_coloring(shown.set, request_for(shown, across))->bytes);
                       },
                   .predicted_error = predicted_bytes(across, 4, side)});
  }
  std::vector<int> counts{4, 6, 8, 12, 18};
  if (effort == Effort::kFull) counts.insert(counts.end(), {24, 36});
  for (const int count : counts) {
    const auto found = memoize([=] { return found_by(kMethods[0], 32, count + 1); });
    const auto shown = std::make_shared<BallPictures>(pictures_of(count, kSide, false));
    all.push_back({.series = "centre",
                   .parameter = double(count),
                   .measure = "pictures",
                   .error = [=] { return found().left_out; },
                   .work =
                       [=](int) {
                         do_not_optimize(views::color_voxels(shown->set, request_for(*shown, 32)));
                       },
                   .items = std::pow(32, 3.0)});
  }
  return all;
}

}  // namespace d18

Experiment d18_voxels() {
  using namespace d18;
  return {
      .id = "D-18",
      .name = "Voxels: how small, how many pictures",
      .question =
          "What do smaller voxels, more pictures, larger footprints and better thresholds improve, "
          "and what do they cost?",
      .axis = "voxels across the ball",
      .error = "mean distance from points that two pictures see to the nearest coloured voxel",
      .error_unit = "ball radii",
      .reference = "the ball's formula",
      .theory =
          "The error is sqrt(a^2 + b^2), where a is 0.480 of a voxel's edge (the mean distance "
          "from a point of a cube to its centre) and b is 0.383 of a pixel (the same for a "
          "square). With N voxels along each axis and m pictures there are N^3 m look-ups. The "
          "memory grows like N^2 m (S1-22 in docs/references.md): 9 bytes per pixel and the data "
          "of the voxels of six faces and a layer",
      .item = "voxel and picture",
      .measures = {{.name = "left out",
                    .error = "RMS error of a picture that was left out, where voxels cover it",
                    .error_unit = "levels"},
                   {.name = "looks", .error = "examined voxels times pictures", .error_unit = ""},
                   {.name = "memory", .error = "bytes asked for", .error_unit = "byte"},
                   {.name = "pictures",
                    .error = "RMS error of a picture that was left out, where voxels cover it",
                    .error_unit = "levels",
                    .axis = "pictures"}},
      .configurations = configurations};
}

}  // namespace glassbox::study
