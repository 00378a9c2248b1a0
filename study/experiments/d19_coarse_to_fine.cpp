// Measures what coarse-to-fine voxel colouring saves and what it loses (D-19).
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "study/experiment/experiment.h"
#include "study/experiments/d18_ball.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/memoize.h"

namespace glassbox::study {
namespace d19 {

using namespace d18;

constexpr int kSide = 192, kPictures = 10, kAcross = 64;

std::set<std::uint64_t> keys_of(const views::Coloring& coloring) {
  std::set<std::uint64_t> keys;
  for (const views::ColoredVoxel& voxel : coloring.voxels) keys.insert(views::key_of(voxel.at));
  return keys;
}

struct Lost {
  double share = 0;   // fraction of the voxels that a complete sweep colours
  double judged = 0;  // voxels of the finest level that are looked at, as a fraction of all
};

Lost lost_by(const BallPictures& shown, views::ColoringRequest request) {
  const views::Coloring fine = views::color_voxels(shown.set, request).value();
  request.levels = 0;
  const views::Coloring whole = views::color_voxels(shown.set, request).value();
  const auto found = keys_of(fine), all = keys_of(whole);
  const auto kept =
      std::ranges::count_if(all, [&](std::uint64_t key) { return found.contains(key); });
  return {1 - double(kept) / double(all.size()), double(fine.examined) / double(whole.examined)};
}

// Predicts the fraction of voxels that are looked at. The level before the finest has cells of two
// voxels. The cells of the ball's surface and the cells around each of them form a shell three
// cells thick, of which the cameras above see about two thirds.
double predicted_judged() {
  constexpr double kCell = 2, kDeep = 3, kSeen = 2.0 / 3;
  const double area = kPi * kAcross * kAcross;
  return kSeen * kDeep * kCell * area / std::pow(kAcross, 3.0);
}

std::vector<Configuration> configurations(Effort) {
  std::vector<Configuration> all;
  for (const bool has_rods : {false, true}) {
    const auto shown = std::make_shared<BallPictures>(pictures_of(kPictures, kSide, has_rods));
    const std::string scene = has_rods ? "ball and rods two voxels thick" : "ball";
    for (const double slack : {1.0, 2.0, 4.0}) {
      for (const int levels : {0, 1, 2, 3}) {
        views::ColoringRequest request = request_for(*shown, kAcross);
        request.levels = levels;
        request.slack = slack;
        const auto lost = memoize([=] { return lost_by(*shown, request); });
        const std::string series = "coarse thresholds times " + std::to_string(int(slack));
        Configuration share{
            .series = series,
            .parameter = double(levels),
            .scene = scene,
            .error = [=] { return lost().share; },
            .work = [=](int) { do_not_optimize(views::color_voxels(shown->set, request)); },
            .items = std::pow(kAcross, 3.0)};
        Configuration judged{.series = series,
                             .parameter = double(levels),
                             .scene = scene,
                             .measure = "judged",
                             .error = [=] { return lost().judged; }};
        if (levels == 0) share.predicted_error = 0;
        if (levels == 0) judged.predicted_error = 1;
        if (levels > 0 && !has_rods) judged.predicted_error = predicted_judged();
        all.push_back(std::move(share));
        all.push_back(std::move(judged));
      }
    }
  }
  return all;
}

}  // namespace d19

Experiment d19_coarse_to_fine() {
  using namespace d19;
  return {
      .id = "D-19",
      .name = "Voxels from coarse to fine",
      .question =
          "Large voxels first, and small ones only where they were coloured: what is saved, and "
          "what is lost?",
      .axis = "coarser levels",
      .logarithmic_axis = false,
      .error = "fraction of the coloured voxels that are lost",
      .reference = "a sweep through all voxels",
      .theory =
          "The examined voxels are the ones in a shell around the ball's surface that is three "
          "cells of two voxels thick; the cameras see about two thirds of it. This is O(N^2) of "
          "all N^3 voxels if there are N along each axis. No formula predicts the loss: thin parts "
          "are lost, and corners that coarse pixels blur",
      .item = "voxel",
      .axis_is_chosen = true,
      .measures = {{.name = "judged",
                    .error = "fraction of all voxels that are examined at the finest level",
                    .error_unit = ""}},
      .configurations = d19::configurations};
}

}  // namespace glassbox::study
