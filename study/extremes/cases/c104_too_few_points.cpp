#include <limits>
#include <set>

#include "study/extremes/common/extreme_case.h"
#include "study/naive/two_view.h"
#include "study/scenes/two_cameras.h"

namespace glassbox::study {
namespace c104 {

// Whether the fundamental matrix of these matches can be trusted.
using AcceptTest = bool (*)(const views::Matches& pixels);

bool has_rank_eight(const views::Matches& pixels) {
  const auto fit = views::fit_fundamental(pixels, views::Conditioning::kNormalised);
  return fit && fit->system.rank() == 8;
}
bool eight_are_there(const views::Matches& pixels) {
  return pixels.size() >= 8;
}
bool is_solved(const views::Matches& pixels) {
  return views::fit_fundamental(pixels, views::Conditioning::kNormalised).has_value();
}
bool left_points_differ(const views::Matches& pixels) {
  std::set<double> columns;
  for (const views::Match& m : pixels) columns.insert(m.left.x());
  return is_solved(pixels) && columns.size() >= 8;
}

Outcome measure_error(AcceptTest accepts) {
  Random random(104);
  int wrong = 0, tried = 0;
  const auto ask = [&](const views::Matches& pixels, bool right) {
    wrong += accepts(pixels) != right;
    ++tried;
  };
  for (int i = 0; i < 10; ++i) {
    const views::StereoRig rig = random_rig(random);
    const views::Matches good = matches_of(random, rig, 8, 0);
    ask(good, true);
    ask(views::Matches(good.begin(), good.begin() + 7), false);
    ask(views::Matches(8, good[0]), false);
    views::Matches twice = good;
    twice[7] = twice[2];
    ask(twice, false);
    // All points except the first are almost on one line of sight of the left camera.
    views::Matches behind = good;
    for (std::size_t k = 1; k < behind.size(); ++k) {
      const double far = 2.5 + double(k);
      behind[k] = project_match(
          rig, far * views::ray_through(rig.left_intrinsic, {100 + double(k) * 1e-3, 200}));
    }
    ask(behind, false);
    views::Matches infinite = good;
    infinite[3].right.x() = std::numeric_limits<double>::infinity();
    ask(infinite, false);
  }
  return wrong_count_outcome(wrong, tried, "lists of matches get a wrong answer");
}

}  // namespace c104

ExtremeCase c104_too_few_points() {
  using namespace c104;
  return {
      .id = "C-104",
      .name = "Fewer than eight different matches",
      .construction =
          "eight good matches; seven; one match eight times; eight with two equal ones; seven of "
          "eight almost on one line of sight; an infinite pixel; 10 pairs of cameras",
      .stage = "two views",
      .right_answer = "only the good ones are accepted: the system must have rank 8",
      .unit = "lists",
      .oracle = Oracle::kProperty,
      .ours = {"at least eight finite matches whose system has rank 8",
               [] { return measure_error(has_rank_eight); }},
      .naive = {"any eight matches are accepted", [] { return measure_error(eight_are_there); }},
      .mutants = {{"the rank is not checked", [] { return measure_error(is_solved); }},
                  {"only the left points of the matches have to differ",
                   [] { return measure_error(left_points_differ); }}},
      .not_drawn = "the result is computed from matches of points; no engine draws it",
  };
}

}  // namespace glassbox::study
