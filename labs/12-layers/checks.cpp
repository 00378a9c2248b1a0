// The expected answers of lab 12: matrices are computed in exact rational numbers, rows in double,
// pictures and lists of samples pixel by pixel.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>

#include "exact/matrix.h"
#include "exact/number.h"
#include "labs/12-layers/generators.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

using namespace lab_12;
using exact::Matrix4;
using exact::Rational;
using Screens = Transform<lab_12::Screen, lab_12::Screen>;

// ---- packing ----

// The samples of one pixel that are kept, from back to front, as indices.
std::vector<std::size_t> kept_samples(const PackCase& input, int x, int y) {
  std::vector<std::size_t> here, kept;
  for (std::size_t i = 0; i < input.samples.size(); ++i) {
    if (input.samples[i].x == x && input.samples[i].y == y) here.push_back(i);
  }
  const auto depth = [&](std::size_t i) { return double(input.samples[i].depth); };
  while (!here.empty()) {
    const std::size_t front = *std::ranges::max_element(
        here, [&](std::size_t a, std::size_t b) { return depth(a) < depth(b); });
    kept.push_back(front);
    std::erase_if(here, [&](std::size_t i) {
      return depth(front) - depth(i) <= input.epsilon * depth(front);
    });
  }
  std::ranges::reverse(kept);
  return kept;
}

std::vector<Expected> packed_fields(const PackCase& input, bool from_bottom) {
  std::vector<double> first{0}, depths, colours;
  for (int row = 0; row < input.height; ++row) {
    for (int x = 0; x < input.width; ++x) {
      for (const std::size_t i :
           kept_samples(input, x, from_bottom ? input.height - 1 - row : row)) {
        depths.push_back(double(input.samples[i].depth));
        colours.push_back(number_of_colour(input.samples[i].colour));
      }
      first.push_back(double(depths.size()));
    }
  }
  return {numbers("offsets", first), numbers("depths", depths), numbers("colours", colours),
          numbers("width and height", {double(input.width), double(input.height)})};
}

bool right_packed(const PackCase& input, const Answer& answer) {
  return has_fields(answer, packed_fields(input, true));
}

Case expect_packed(const PackCase& input) {
  std::string text = fmt::format("{} x {} px, {} samples, epsilon {}", input.width, input.height,
                                 input.samples.size(), input.epsilon);
  for (std::size_t i = 0; i < std::min<std::size_t>(input.samples.size(), 12); ++i) {
    const Sample& s = input.samples[i];
    text += fmt::format("\nsample {}: pixel ({}, {}), depth {}, colour {}", i, s.x, s.y, s.depth,
                        number_of_colour(s.colour));
  }
  return {.where = input.what,
          .restated = text + extreme_case_command(input.what),
          .expected = packed_fields(input, true),
          .slipped = {{"y-direction", packed_fields(input, false)}}};
}

// ---- matrices ----

using Sizes = Matrix4<double>;

Matrix4<Rational> inverse_of(Matrix4<Rational> m) {
  Matrix4<Rational> inverse = Matrix4<Rational>::identity();
  for (std::size_t i = 0; i < 4; ++i) {
    std::size_t pivot = i;
    while (m.at[pivot][i].sign() == 0) ++pivot;
    std::swap(m.at[i], m.at[pivot]);
    std::swap(inverse.at[i], inverse.at[pivot]);
    const Rational scale = Rational(1) / m.at[i][i];
    for (std::size_t k = 0; k < 4; ++k) m.at[i][k] *= scale, inverse.at[i][k] *= scale;
    for (std::size_t j = 0; j < 4; ++j) {
      const Rational factor = m.at[j][i];
      if (j == i || factor.sign() == 0) continue;
      for (std::size_t k = 0; k < 4; ++k) {
        m.at[j][k] -= factor * m.at[i][k];
        inverse.at[j][k] -= factor * inverse.at[i][k];
      }
    }
  }
  return inverse;
}

Sizes sizes_of(const Matrix4<Rational>& m) {
  Sizes sizes;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) sizes.at[i][j] = std::abs(double(m.at[i][j]));
  }
  return sizes;
}

constexpr std::array kRowNames{"row of x w", "row of y w", "row of z w", "row of w"};

std::vector<Expected> matrix_fields(const Matrix4<Rational>& m,
                                    const std::array<double, 4>& bounds) {
  std::vector<Expected> fields;
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<double> row;
    for (const Rational& each : m.at[i]) row.push_back(double(each));
    fields.push_back(matrix(kRowNames[i], 4, row, bounds[i]));
  }
  return fields;
}

std::array<double, 4> row_bounds(const Sizes& sizes) {
  std::array<double, 4> bounds{};
  for (std::size_t i = 0; i < 4; ++i)
    bounds[i] = 256 * unit_roundoff<double> * *std::ranges::max_element(sizes.at[i]);
  return bounds;
}

// The bound. Elimination, and also cofactors divided by the determinant, give the exact inverse of
// a matrix whose entries differ from those of A by some roundings (Higham 2002, chapter 14). Such
// changes of A's entries, c times their sizes, change A^-1 by at most c |A^-1| |A| |A^-1|.
// Altogether there are a few dozen roundings of each entry, and those of the product with `second`,
// which is below the allowed 256 u (u = 2^-53 is the unit roundoff).
Case expect_matrix(const MatrixCase& input) {
  const auto first = exact::exactly<Rational>(input.first),
             second = exact::exactly<Rational>(input.second);
  const auto back = inverse_of(first), back_of_second = inverse_of(second);
  const auto bounds =
      row_bounds(sizes_of(second) * sizes_of(back) * sizes_of(first) * sizes_of(back));
  const auto other_order =
      row_bounds(sizes_of(back) * sizes_of(first) * sizes_of(back) * sizes_of(second));
  return {
      .where = input.what,
      .restated = fmt::format("the first eye's row of w is ({}, {}, {}, {}), the second's ({}, "
                              "{}, {}, {})",
                              input.first.at(3, 0), input.first.at(3, 1), input.first.at(3, 2),
                              input.first.at(3, 3), input.second.at(3, 0), input.second.at(3, 1),
                              input.second.at(3, 2), input.second.at(3, 3)) +
                  extreme_case_command(input.what),
      .expected = matrix_fields(second * back, bounds),
      .slipped = {{"multiplication-order", matrix_fields(back * second, other_order)}}};
}

// ---- rows ----

// The expected coordinates of a row. `middle` is where a pixel is sampled, as the distance in x and
// y from its corner; 0.5 is right.
std::vector<Expected> row_fields(const RowCase& input, const Screens& warp, double middle) {
  std::array<std::vector<double>, 4> all;
  std::array<double, 4> largest{};
  for (std::size_t x = 0; x < input.depths.size(); ++x) {
    for (std::size_t i = 0; i < 4; ++i) {
      const int row = int(i);
      const double start = warp.at(row, 0) * (double(x) + middle) +
                           warp.at(row, 1) * (input.y + middle) + warp.at(row, 3);
      largest[i] = std::max(largest[i], std::abs(start));
      for (const float z : input.depths[x]) {
        const double added = double(z) * warp.at(row, 2);
        all[i].push_back(start + added);
        largest[i] = std::max(largest[i], std::abs(start) + std::abs(added));
      }
    }
  }
  std::vector<Expected> fields;
  const char* names[] = {"x w", "y w", "z w", "w"};
  for (std::size_t i = 0; i < 4; ++i)
    fields.push_back(numbers(names[i], all[i], 72 * double(unit_roundoff<float>) * largest[i]));
  return fields;
}

Screens transposed(const Screens& m) {
  Screens t;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) t.at(i, j) = m.at(j, i);
  }
  return t;
}

// The bound: 72 u, where u = 2^-24 is the unit roundoff of float. The start of the row rounds once.
// Up to 63 additions round by u of a sum that is no larger than the largest start. The rounded step
// has an error of u of itself, and 63 steps are the difference of two starts, so that makes 2 u: 66
// u together. For a depth, the rounded column of the matrix, its product with the depth and the
// last sum add 3 u of the product.
Case expect_row(const RowCase& input) {
  std::size_t samples = 0;
  for (const auto& here : input.depths) samples += here.size();
  std::string text = fmt::format("row {}, {} pixels with {} samples; warp's rows", input.y,
                                 input.depths.size(), samples);
  for (int i = 0; i < 4; ++i)
    text += fmt::format(" ({:.8g}, {:.8g}, {:.8g}, {:.8g})", input.warp.at(i, 0),
                        input.warp.at(i, 1), input.warp.at(i, 2), input.warp.at(i, 3));
  return {.where = input.what,
          .restated = text + extreme_case_command(input.what),
          .expected = row_fields(input, input.warp, 0.5),
          .slipped = {{"half-pixel", row_fields(input, input.warp, 0)},
                      {"row-column-order", row_fields(input, transposed(input.warp), 0.5)}}};
}

bool right_row(const RowCase& input, const Answer& answer) {
  return has_fields(answer, row_fields(input, input.warp, 0.5));
}

// ---- sizes ----

struct ExactSize {
  long double side = 0;     // before the limits; infinite if the first eye sees the surface edge-on
  bool may_be_cut = false;  // whether is_cut may be true
  bool may_be_uncut = false;
};
ExactSize exact_size(const SizeCase& input) {
  using Long = long double;
  if (input.cosine_first == 0) return {HUGE_VALL, true, false};
  const Long side = Long(input.focal_ratio) / Long(input.w) *
                    std::sqrt(Long(input.cosine_second) / Long(input.cosine_first));
  // Exactly 64 px is not cut. A size that rounding may bring to 64 px may be either.
  const bool is_near = std::abs(side - 64) <= 8 * Long(unit_roundoff<double>) * 64 && side != 64;
  return {side, side > 64 || is_near, side <= 64 || is_near};
}
double drawn_side(const ExactSize& exact) {
  return double(std::clamp<long double>(exact.side, 1, 64));
}

bool right_size(const SizeCase& input, const Answer& answer) {
  const ExactSize exact = exact_size(input);
  const double drawn = drawn_side(exact);
  const auto* cut = find_field(answer, "is cut");
  return has_fields(answer, {numbers("side", {drawn}, 8 * unit_roundoff<double> * drawn)}) &&
         cut != nullptr && cut->size() == 1 &&
         (((*cut)[0] == 1 && exact.may_be_cut) || ((*cut)[0] == 0 && exact.may_be_uncut));
}

// The bound 8 u: two quotients, a root and a product round in the student's answer, 4 times. Ours
// is computed in long double and rounds once.
Case expect_size(const SizeCase& input) {
  const auto& [what, ratio, w, first, second] = input;
  const ExactSize exact = exact_size(input);
  const double drawn = drawn_side(exact);
  std::vector<Expected> expected{numbers("side", {drawn}, 8 * unit_roundoff<double> * drawn, "px")};
  // Where rounding decides whether the sample is cut, this is not judged.
  if (!exact.may_be_cut || !exact.may_be_uncut)
    expected.push_back(numbers("is cut", {exact.may_be_cut ? 1.0 : 0.0}));
  return {.where = what,
          .restated = fmt::format("F2/F1 = {}, d2/d1 = {}, cosines {} and {}; l = {:.9g} px", ratio,
                                  w, first, second, double(exact.side)) +
                      extreme_case_command(what),
          .expected = expected};
}

// ---- orders ----

Case expect_order(const OrderCase& input) {
  const auto& [what, epipole, w, count] = input;
  // Column numbers grow on the way towards an epipole in front of the camera, or away from one
  // behind it. w (i + 1/2) and `epipole` are compared without rounding.
  const auto grows = [epipole = epipole, w = w](int i) {
    const Rational from_here = Rational(epipole) - Rational(2 * i + 1) / Rational(2) * Rational(w);
    return from_here.sign() > 0;
  };
  std::vector<double> order;
  for (int i = 0; i < count; ++i) {
    if (grows(i)) order.push_back(i);
  }
  for (int i = count; i-- > 0;) {
    if (!grows(i)) order.push_back(i);
  }
  return {.where = what,
          .restated = fmt::format("epipole {}, w {}: {}; {} columns", epipole, w,
                                  w == 0 ? std::string("infinitely far")
                                         : fmt::format("at column {}, {} the first eye",
                                                       epipole / w, w > 0 ? "before" : "behind"),
                                  count) +
                      extreme_case_command(what),
          .expected = {numbers("order", order)}};
}

// The contract's limits on epipole and w keep the fused multiplication and addition from overflow
// and underflow, so the sign of its result is exact.
bool right_order(const OrderCase& input, const Answer& answer) {
  const auto* order = find_field(answer, "order");
  if (order == nullptr || order->size() != std::size_t(input.count)) return false;
  std::size_t at = 0;
  const auto grows = [&](int i) { return std::fma(-(i + 0.5), input.w, input.epipole) > 0; };
  for (int i = 0; i < input.count; ++i)
    if (grows(i) && (*order)[at++] != i) return false;
  for (int i = input.count; i-- > 0;)
    if (!grows(i) && (*order)[at++] != i) return false;
  return true;
}

// ---- pictures ----

struct Rule {
  bool last_of_equals = false;
  double middle = 0.5;  // where a pixel is sampled: the distance from its corner
  bool from_bottom = false;
};

std::vector<Expected> picture_fields(const Canvas& canvas, const Rule& rule) {
  std::vector<double> shown;
  for (int row = 0; row < canvas.height; ++row) {
    const int j = rule.from_bottom ? canvas.height - 1 - row : row;
    for (int i = 0; i < canvas.width; ++i) {
      const Placed* seen = nullptr;
      double depth = 0;
      for (const Placed& sample : canvas.samples) {
        const double w = double(sample.at.w), z = double(sample.at.z) / w;
        if (!(w > 0) || z > 1) continue;
        const auto covers = [&](double place, int pixel) {
          const double middle = pixel + rule.middle, half = sample.side / 2;
          return place - half < middle && middle <= place + half;
        };
        if (!covers(double(sample.at.x) / w, i) || !covers(double(sample.at.y) / w, j)) continue;
        const bool in_front = seen == nullptr || z > depth || (rule.last_of_equals && z == depth);
        if (canvas.hiding == Hiding::kNearest && !in_front) continue;
        seen = &sample;
        depth = z;
      }
      shown.push_back(number_of_colour(seen != nullptr ? seen->colour : canvas.background));
    }
  }
  return {matrix("samples shown", canvas.width, shown),
          numbers("width and height", {double(canvas.width), double(canvas.height)})};
}

bool right_picture(const DrawCase& input, const Answer& answer) {
  return has_fields(answer, picture_fields(input.canvas, {}));
}

Case expect_picture(const DrawCase& input) {
  const Canvas& canvas = input.canvas;
  std::string text =
      fmt::format("{} x {} px, {} samples; {}", canvas.width, canvas.height, canvas.samples.size(),
                  canvas.hiding == Hiding::kNearest ? "the nearest stays" : "the last stays");
  for (std::size_t i = 0; i < std::min<std::size_t>(canvas.samples.size(), 8); ++i) {
    const Placed& s = canvas.samples[i];
    text += fmt::format("\nsample {}: x w {}, y w {}, z w {}, w {}, side {}, shown as {}", i,
                        s.at.x, s.at.y, s.at.z, s.at.w, s.side, number_of_colour(s.colour));
  }
  return {.where = input.what,
          .restated = text + extreme_case_command(input.what),
          .expected = picture_fields(canvas, {}),
          .slipped = {{"depth-or-equal", picture_fields(canvas, {true, 0.5})},
                      {"half-pixel", picture_fields(canvas, {false, 0})},
                      {"y-direction", picture_fields(canvas, {false, 0.5, true})}}};
}

}  // namespace

Lab lab_12() {
  return {
      12,
      "12-layers",
      "Layered depth images: packed, warped, splatted",
      {{"12.1", "Lists of samples, packed", 20},
       {"12.2", "From one picture to the other", 15},
       {"12.3", "A row, step by step", 20},
       {"12.4", "How large a sample is", 10},
       {"12.5", "Who is visited later is nearer", 15},
       {"12.6", "Samples in a picture", 20}},
      {check("samples are packed", "12.1", "eye", packs, expect_packed),
       generated_check("any samples are packed", "12.1", "eye", generated_packs, expect_packed,
                       right_packed),
       hidden_check("other samples are packed", "12.1", "eye", hidden_packs, expect_packed),
       check("the matrix from picture to picture", "12.2", "clip", matrices, expect_matrix),
       generated_check("the matrix of any two eyes", "12.2", "clip", generated_matrices,
                       expect_matrix),
       hidden_check("the matrix of other eyes", "12.2", "clip", hidden_matrices, expect_matrix),
       check("rows are warped step by step", "12.3", "screen", rows, expect_row),
       generated_check("any row", "12.3", "screen", generated_rows, expect_row, right_row),
       hidden_check("rows of other samples", "12.3", "screen", hidden_rows, expect_row),
       check("how large a sample is", "12.4", "coverage", sizes, expect_size),
       generated_check("any size", "12.4", "coverage", generated_sizes, expect_size, right_size),
       hidden_check("other sizes", "12.4", "coverage", hidden_sizes, expect_size),
       check("the order of visits", "12.5", "depth", orders, expect_order),
       generated_check("any order", "12.5", "depth", generated_orders, expect_order, right_order),
       hidden_check("other orders", "12.5", "depth", hidden_orders, expect_order),
       check("samples in a picture", "12.6", "shading", pictures, expect_picture),
       generated_check("any picture", "12.6", "shading", generated_pictures, expect_picture,
                       right_picture),
       hidden_check("other pictures", "12.6", "shading", hidden_pictures, expect_picture)}};
}

}  // namespace glassbox::labs
