#include <map>

#include <glassbox/base/random.h>

#include "study/extremes/common/extreme_case.h"
#include "study/naive/polygons.h"

namespace glassbox::study {
namespace c97 {

using views::Corners3d;
using views::PolygonFootprint;
using views::PolygonId;
using views::Vector3d;

constexpr int kSide = 32, kEdits = 100000, kPolygons = 300;

const views::PinholeCamera& camera() {
  static const views::PinholeCamera made = [] {
    views::PinholeCamera c;
    c.intrinsic << kSide, 0, kSide / 2.0, 0, kSide, kSide / 2.0, 0, 0, 1;
    c.centre = {0, 0, -4};
    return c;
  }();
  return made;
}

// A small triangle that the camera sees; a third of all triangles are in the same plane.
Corners3d any_triangle(Random& random) {
  const double x = random.between(-1.5, 1.5), y = random.between(-1.5, 1.5);
  const double z = random.integer(0, 2) == 0 ? 0.5 : random.between(-1, 1);
  const double wide = random.between(0.1, 0.9);
  return {Vector3d(x, y, z), Vector3d(x, y + wide, z), Vector3d(x + wide, y, z)};
}

// Adds and removes polygons at random, and counts the pixels where `layers` then differs from a
// layered image that is built from the remaining polygons only.
template <typename Layers>
Outcome measure_error(Layers layers) {
  Random random(97);
  std::map<PolygonId, Corners3d> there;
  for (int edit = 0; edit < kEdits; ++edit) {
    const auto id = PolygonId(random.integer(0, kPolygons - 1));
    const auto found = there.find(id);
    if (found != there.end()) {
      layers.remove(id, PolygonFootprint(camera(), kSide, kSide, found->second));
      there.erase(found);
    } else {
      const Corners3d corners = any_triangle(random);
      layers.add(id, PolygonFootprint(camera(), kSide, kSide, corners));
      there.emplace(id, corners);
    }
  }
  views::IdLayers rebuilt(kSide, kSide);
  for (const auto& [id, corners] : there)
    rebuilt.add(id, PolygonFootprint(camera(), kSide, kSide, corners));
  int wrong = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) wrong += layers.samples({x, y}) != rebuilt.samples({x, y});
  }
  return wrong_count_outcome(wrong, kSide * kSide, "pixels are wrong",
                             fmt::format("; the image has {} samples of {} polygons",
                                         rebuilt.sample_count(), there.size()));
}

Outcome measure_naive_error(const naive::PixelList& rule) {
  return measure_error(naive::NaiveIdLayers(kSide, kSide, rule));
}

}  // namespace c97

ExtremeCase c97_polygons_come_and_go() {
  using namespace c97;
  return {
      .id = "C-97",
      .name = "Polygons that come and go",
      .construction =
          "100,000 times, one of 300 polygons is added to a layered image of 32 x 32 or removed "
          "from it; a third of them are in one plane",
      .stage = "polygons",
      .right_answer =
          "the result is bit for bit the layered image that is built from the remaining polygons "
          "(S1-39)",
      .unit = "pixels",
      .oracle = Oracle::kProperty,
      .ours = {"each pixel has a list of polygons, sorted by distance, then by number",
               [] { return measure_error(views::IdLayers(kSide, kSide)); }},
      .naive = {"each pixel has only its nearest polygon",
                [] { return measure_naive_error({.keeps_all = false}); }},
      .mutants = {{"hidden polygons are not removed",
                   [] { return measure_naive_error({.deletes_behind = false}); }},
                  {"of polygons at equal distance the last one is in front",
                   [] { return measure_naive_error({.breaks_ties_by_id = false}); }},
                  {"the list of a pixel is in the order of insertion",
                   [] { return measure_naive_error({.sorts = false}); }}},
      .not_drawn = "views/polygons draws the polygons; no engine of glassbox render takes part",
  };
}

}  // namespace glassbox::study
