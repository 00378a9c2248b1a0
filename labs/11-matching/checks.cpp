// The expected answers of lab 11, from reference.h, which follows the definitions word for word.
// Answers are whole numbers, except for fractions of a pixel and depths.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "labs/11-matching/generators.h"
#include "labs/11-matching/reference.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

using namespace lab_11;

std::vector<double> doubles(const std::vector<int>& values) {
  return {values.begin(), values.end()};
}

// The first 24 numbers of a list, as text for a report.
template <class T>
std::string text_of(const std::vector<T>& values) {
  constexpr std::size_t kMost = 24;
  std::string text;
  for (std::size_t i = 0; i < std::min(values.size(), kMost); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", values[i]);
  return text + (values.size() > kMost ? ", ..." : "");
}

std::string text_of(const std::vector<Place>& places) {
  std::string text;
  for (const Place& p : places) {
    if (text.size() > 200) return text + ", ...";
    text += fmt::format("{}({}, {}) d {}", text.empty() ? "" : ", ", p.x, p.y, p.d);
  }
  return text;
}

Case expect_square(const SadCase& input) {
  const auto expected = [&](const matching::Sides& sides) {
    std::vector<double> sums;
    for (const Place& p : input.places)
      sums.push_back(matching::sad(sides, p.x, p.y, p.d, input.radius));
    return std::vector{numbers("sums", sums)};
  };
  return {.where = input.what,
          .restated = fmt::format("pictures of {} x {} (left) and {} x {}, radius {}, at {}",
                                  input.left.width, input.left.height, input.right.width,
                                  input.right.height, input.radius, text_of(input.places)),
          .expected = expected({&input.left, &input.right, -1}),
          .slipped = {{"left-right", expected({&input.right, &input.left, -1})},
                      {"disparity-sign", expected({&input.left, &input.right, 1})}}};
}

Case expect_word(const CensusCase& input) {
  std::vector<double> words;
  for (const Place& p : input.places) words.push_back(matching::census(input.picture, p.x, p.y));
  std::string text = fmt::format("a picture of {} x {}", input.picture.width, input.picture.height);
  const Place& first = input.places.front();
  text += fmt::format("; around ({}, {}), row by row:", first.x, first.y);
  for (int j = -2; j <= 2; ++j) {
    text += "\n ";
    for (int i = -2; i <= 2; ++i)
      text += fmt::format(" {:3}", input.picture.at(first.x + i, first.y + j));
  }
  return {input.what, text, {numbers("words", words)}};
}

Case expect_bits(const HammingCase& input) {
  return {input.what,
          fmt::format("{:#026b} and {:#026b}", input.a, input.b),
          {numbers("bits", {double(matching::hamming(input.a, input.b))})}};
}

Case expect_path(const PathCase& input) {
  const auto sums = matching::along_path(input.costs, input.disparities, input.p1, input.p2);
  return {input.what,
          fmt::format("{} disparities, P1 {}, P2 {}; costs {}", input.disparities, input.p1,
                      input.p2, text_of(input.costs)),
          {matrix("sums", input.disparities, doubles(sums))}};
}

// The bound: the fraction of a pixel is a quotient of whole numbers and at most 1/2. The division
// and its addition to d round, in the student's answer and in ours: four roundings.
Case expect_best(const WinnerCase& input) {
  const double d = matching::winner(input.costs);
  return {input.what,
          "costs " + text_of(input.costs) + extreme_case_command(input.what),
          {numbers("disparity", {d}, std::isinf(d) ? 0 : matching::kWinnerBound * (1 + d), "px")}};
}

Case expect_row(const RowCase& input) {
  const auto expected = [&](int step) {
    return std::vector{numbers(
        "disparities", matching::right_winners(input.costs, input.width, input.disparities, step))};
  };
  return {.where = input.what,
          .restated = fmt::format("{} pixels, {} disparities; costs {}", input.width,
                                  input.disparities, text_of(input.costs)),
          .expected = expected(-1),
          .slipped = {{"disparity-sign", expected(1)}}};
}

Case expect_confirmed(const CheckCase& input) {
  const auto expected = [&](int step) {
    return std::vector{numbers(
        "disparities", matching::left_right_check(input.left, input.right, input.tolerance, step))};
  };
  return {.where = input.what,
          .restated = fmt::format("left {}; right {}; tolerance {}", text_of(input.left),
                                  text_of(input.right), input.tolerance) +
                      extreme_case_command(input.what),
          .expected = expected(-1),
          .slipped = {{"disparity-sign", expected(1)}}};
}

// The bound: in f B / (d + offset) a sum, a product and a quotient round, 3 u of Z (u = 2^-53 is
// the unit roundoff), below the allowed 4 u. The expected depth is rounded by another u, once.
Case expect_depth(const DepthCase& input) {
  const double z = matching::depth(input.disparity, input.calibration);
  return {input.what,
          fmt::format("d = {}, f = {}, B = {}, offset {}", input.disparity, input.calibration.focal,
                      input.calibration.baseline, input.calibration.offset) +
              extreme_case_command(input.what),
          {numbers("depth", {z}, std::isinf(z) ? 0 : matching::kDepthBound * z, "world units")}};
}

// ---- generated inputs ----

bool right_square(const SadCase& input, const Answer& answer) {
  const Place& p = input.places[0];
  const double sum = matching::sad({&input.left, &input.right, -1}, p.x, p.y, p.d, input.radius);
  return has_numbers(answer, "sums", {sum});
}

bool right_word(const CensusCase& input, const Answer& answer) {
  const Place& p = input.places[0];
  return has_numbers(answer, "words", {double(matching::census(input.picture, p.x, p.y))});
}

bool right_bits(const HammingCase& input, const Answer& answer) {
  return has_numbers(answer, "bits", {double(matching::hamming(input.a, input.b))});
}

bool right_path(const PathCase& input, const Answer& answer) {
  return has_numbers(
      answer, "sums",
      doubles(matching::along_path(input.costs, input.disparities, input.p1, input.p2)));
}

bool right_best(const WinnerCase& input, const Answer& answer) {
  const double d = matching::winner(input.costs);
  return has_numbers(answer, "disparity", {d},
                     std::isinf(d) ? 0 : matching::kWinnerBound * (1 + d));
}

bool right_row(const RowCase& input, const Answer& answer) {
  return has_numbers(answer, "disparities",
                     matching::right_winners(input.costs, input.width, input.disparities));
}

bool right_confirmed(const CheckCase& input, const Answer& answer) {
  return has_numbers(answer, "disparities",
                     matching::left_right_check(input.left, input.right, input.tolerance));
}

bool right_depth(const DepthCase& input, const Answer& answer) {
  const double z = matching::depth(input.disparity, input.calibration);
  return has_numbers(answer, "depth", {z}, std::isinf(z) ? 0 : matching::kDepthBound * z);
}

}  // namespace

Lab lab_11() {
  return {
      11,
      "11-matching",
      "Two pictures: dense matching",
      {{"11.1", "How unlike two squares are", 15},
       {"11.2", "What a change of brightness leaves alone", 15},
       {"11.3", "Smoothness along a path", 25},
       {"11.4", "The disparity that costs least", 15},
       {"11.5", "What both pictures agree on", 15},
       {"11.6", "How far away it is", 15}},
      {check("how unlike two squares are", "11.1", "screen", squares, expect_square),
       generated_check("any square", "11.1", "screen", generated_squares, expect_square,
                       right_square),
       hidden_check("other squares", "11.1", "screen", hidden_squares, expect_square),
       check("census words", "11.2", "screen", words, expect_word),
       generated_check("any pixel", "11.2", "screen", generated_words, expect_word, right_word),
       check("bits that differ", "11.2", "screen", pairs_of_words, expect_bits),
       generated_check("any two words", "11.2", "screen", generated_pairs_of_words, expect_bits,
                       right_bits),
       hidden_check("other census words", "11.2", "screen", hidden_words, expect_word),
       hidden_check("bits of other words", "11.2", "screen", hidden_pairs_of_words, expect_bits),
       check("costs along a path", "11.3", "screen", paths, expect_path),
       generated_check("any path", "11.3", "screen", generated_paths, expect_path, right_path),
       hidden_check("other paths", "11.3", "screen", hidden_paths, expect_path),
       check("the disparity that costs least", "11.4", "screen", winners, expect_best),
       generated_check("any costs", "11.4", "screen", generated_winners, expect_best, right_best),
       hidden_check("other costs", "11.4", "screen", hidden_winners, expect_best),
       check("what the right pixels win", "11.5", "screen", rows, expect_row),
       generated_check("any row", "11.5", "screen", generated_rows, expect_row, right_row),
       check("what both pictures agree on", "11.5", "screen", pairs_of_rows, expect_confirmed),
       generated_check("any two rows", "11.5", "screen", generated_pairs_of_rows, expect_confirmed,
                       right_confirmed),
       hidden_check("other right pixels", "11.5", "screen", hidden_rows, expect_row),
       hidden_check("rows of another pair", "11.5", "screen", hidden_pairs_of_rows,
                    expect_confirmed),
       check("how far away it is", "11.6", "eye", depths, expect_depth),
       generated_check("any depth", "11.6", "eye", generated_depths, expect_depth, right_depth),
       hidden_check("other disparities", "11.6", "eye", hidden_depths, expect_depth)}};
}

}  // namespace glassbox::labs
