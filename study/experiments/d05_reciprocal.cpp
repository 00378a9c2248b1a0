// D-5: how good an approximate reciprocal is, and what a Newton step adds.
#include <algorithm>
#include <cmath>

#include <glassbox/base/random.h>
#include <glassbox/base/rounding.h>

#include "study/experiment/experiment.h"
#include "study/experiments/consume.h"
#include "study/experiments/kernels/reciprocal_kernels.h"
#include "study/experiments/reciprocal_table.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {
namespace {

float approximation(Reciprocal method, float w) {
  switch (method) {
    case Reciprocal::kDivide:
      return 1.0f / w;
    case Reciprocal::kApproximate:
      return approximate_reciprocal(w);
    case Reciprocal::kNewton:
      return newton_reciprocal(w, approximate_reciprocal(w));
    case Reciprocal::kRootDivide:
      return 1.0f / std::sqrt(w);
    case Reciprocal::kRootApproximate:
      return approximate_reciprocal_root(w);
    case Reciprocal::kRootNewton:
      return newton_reciprocal_root(w, approximate_reciprocal_root(w));
    case Reciprocal::kMagic:
      return magic_reciprocal_root(w);
    case Reciprocal::kMagicNewton:
      return newton_reciprocal_root(w, magic_reciprocal_root(w));
  }
  return 0;
}

bool is_root(Reciprocal method) {
  return method >= Reciprocal::kRootDivide;
}

// Double's own error is 2^-29 of the least there is to see.
double relative_error(Reciprocal method, float w) {
  const double x = is_root(method) ? std::sqrt(double(w)) : double(w);
  return std::abs(double(approximation(method, w)) * x - 1);
}

// A decade of w, evenly on neither scale: bits decide.
std::vector<float> decade(double from, int count) {
  Random random(6);
  std::vector<float> w;
  for (int i = 0; i < count; ++i) w.push_back(float(random.between(from, 10 * from)));
  return w;
}

double largest_error(Reciprocal method, double from, int count) {
  double largest = 0;
  for (const float w : decade(from, count)) largest = std::max(largest, relative_error(method, w));
  return largest;
}

double predict(Reciprocal method) {
  const double u = unit_roundoff<float>;
  constexpr double kMagicError = 0.0343758;  // Lomont 2003, the line nearest to the logarithm
  switch (method) {
    case Reciprocal::kDivide:
      return u;
    case Reciprocal::kApproximate:
      return kReciprocalError;
    case Reciprocal::kNewton:  // w x and the last product are rounded; 2 - w x is exact
      return square(kReciprocalError) + 2 * u;
    case Reciprocal::
        kRootDivide:  // half of the root's, which is passed on whole, and the division's
      return 2 * u;
    case Reciprocal::kRootApproximate:
      return kReciprocalRootError;
    case Reciprocal::kRootNewton:  // two products of about 1/2, the difference and the last product
      return 1.5 * square(kReciprocalRootError) + 3 * u;
    case Reciprocal::kMagic:
      return kMagicError;
    case Reciprocal::kMagicNewton:
      return 1.5 * square(kMagicError) - 0.5 * kMagicError * square(kMagicError);
  }
  return 0;
}

struct Series {
  Reciprocal method;
  const char* name;
};
constexpr Series kSeries[] = {
    {Reciprocal::kDivide, "1/w: division"},
    {Reciprocal::kApproximate, "1/w: approximate"},
    {Reciprocal::kNewton, "1/w: approximate and a Newton step"},
    {Reciprocal::kRootDivide, "1/sqrt(w): root and division"},
    {Reciprocal::kRootApproximate, "1/sqrt(w): approximate"},
    {Reciprocal::kRootNewton, "1/sqrt(w): approximate and a Newton step"},
    {Reciprocal::kMagic, "1/sqrt(w): 0x5f3759df"},
    {Reciprocal::kMagicNewton, "1/sqrt(w): 0x5f3759df and a Newton step"},
};

std::vector<Configuration> configurations(Effort effort) {
  const int count = effort == Effort::kFull ? 1'000'000 : 100'000;
  constexpr int kTimed = 1 << 11, kRounds = 800;  // 16 KiB in and out stay in the first cache
  std::vector<Configuration> all;
  for (const Series& series : kSeries) {
    const Reciprocal method = series.method;
    for (const double from : {1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2}) {
      all.push_back(
          {.series = series.name,
           .parameter = from,
           .error = [=] { return largest_error(method, from, count); },
           .predicted_error = predict(method),
           .work =
               [method, w = decade(from, kTimed), out = std::vector<float>(kTimed)](int) mutable {
                 for (int i = 0; i < kRounds; ++i) {
                   reciprocals(method, w, out);
                   consume(out.back());
                 }
               },
           .items = double(kTimed) * kRounds});
    }
  }
  return all;
}

}  // namespace

Experiment d05_reciprocal() {
  return {.id = "D-5",
          .name = "Reciprocals: division, approximation, Newton's step",
          .question = "How many digits do approximate reciprocals have, over six decades of w?",
          .axis = "the decade of w starts at",
          .error =
              "largest relative error; times u in texels it is the error of a texture coordinate "
              "(a texture of 4096 texels: 2^-11.7 is 1.2 texels)",
          .reference = "double",
          .theory =
              "2^-12 + 2^-14 for 1/w from a table of 2^11 entries of 13 bits, 2^-12 + 2^-13.5 for "
              "1/sqrt(w) from one of 2 x 2^10; a Newton step squares it (3/2 of the square for the "
              "root) and adds roundings of u = 2^-24 each; 0.0344 for 0x5f3759df (Lomont 2003). "
              "Errors are the table's, the same everywhere; the instructions that are timed keep "
              "to 1.5 * 2^-12 on x86 and to bounds of their own elsewhere",
          .item = "reciprocal",
          .configurations = configurations};
}

}  // namespace glassbox::study
