#include <glassbox/pipeline/affine.h>

#include "exact/matrix.h"
#include "exact/number.h"
#include "study/extremes/kit/extreme_case.h"
#include "study/extremes/kit/world.h"
#include "study/naive/transform.h"

namespace glassbox::study {
namespace c19 {

using exact::Rational;
// Turns about the object's own origin, then moves.
using Place = glm::dmat4 (*)(const WorldMap& turn, const WorldMap& move);

Outcome judge(Place place) {
  Worst worst;
  for (const double degrees : {90.0, 180.0, 270.0}) {  // exact entries
    const WorldMap turn = rotate_degrees<World>(WorldVector(0, 0, 1), degrees).value();
    const WorldVector offset{3, -5, 8};
    const glm::dmat4 m = place(turn, translate<World>(offset));
    for (const WorldPoint& p : {WorldPoint(0, 0, 0), WorldPoint(1, 2, 3), WorldPoint(-4, 0, 7)}) {
      const auto turned = exact::exactly<Rational>(turn) * exact::exactly<Rational>(p);
      const Rational exact[] = {turned[0] + Rational(3), turned[1] - Rational(5),
                                turned[2] + Rational(8)};
      const WorldPoint placed = WorldMap(m) * p;
      const double found[] = {placed.x, placed.y, placed.z};
      for (std::size_t k = 0; k < 3; ++k) {
        worst.see(exact::error_of(found[k], exact[k]), 0, fmt::format("{} degrees", degrees));
      }
    }
  }
  return worst.outcome();
}

glm::dmat4 translation_last(const WorldMap& turn, const WorldMap& move) {
  return (move * turn).columns;
}
glm::dmat4 in_reading_order(const WorldMap& turn, const WorldMap& move) {
  return (turn * move).columns;
}
glm::dmat4 premultiplied(const WorldMap& turn, const WorldMap& move) {
  return naive::premultiplied(move.columns, turn.columns);
}
glm::dmat4 transposed_storage(const WorldMap& turn, const WorldMap& move) {
  return (move * WorldMap(glm::transpose(turn.columns))).columns;
}

}  // namespace c19

ExtremeCase c19_order_of_composition() {
  using namespace c19;
  return {
      .id = "C-19",
      .name = "The order of composition",
      .construction = "turns by 90, 180 and 270 degrees and a move by (3, -5, 8)",
      .stage = "to world space",
      .right = "T R, exactly; R T is off by (R - I) a",
      .unit = "world unit",
      .oracle = Oracle::kRational,
      .ours = {"translate * rotate", [] { return judge(translation_last); }},
      .naive = {"in reading order: rotate * translate", [] { return judge(in_reading_order); }},
      .mutants = {{"the product premultiplied", [] { return judge(premultiplied); }},
                  {"the rotation stored row by row", [] { return judge(transposed_storage); }}},
  };
}

}  // namespace glassbox::study
