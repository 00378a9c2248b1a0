// Measures the accuracy of approximate reciprocals, and what a Newton step improves (D-5).
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include <glassbox/base/random.h>
#include <glassbox/base/rounding.h>
#include <glassbox/raster/lanes/target.h>

#include "study/experiment/experiment.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/kernels/reciprocal_kernels.h"
#include "study/experiments/reciprocal_table.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {
namespace d05 {

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

// Random values of w in one decade, uniformly distributed between `from` and 10 times `from`.
std::vector<float> decade(double from, int count) {
  Random random(6);
  std::vector<float> w;
  for (int i = 0; i < count; ++i) w.push_back(float(random.between(from, 10 * from)));
  return w;
}

// Where the approximation before a Newton step comes from.
enum class ApproximationSource { kTable, kProcessor };

// Computed in double, whose rounding errors are only 2^-29 of the smallest error that is measured.
double relative_error(Reciprocal method, float w, float found) {
  const double x = is_root(method) ? std::sqrt(double(w)) : double(w);
  return std::abs(double(found) * x - 1);
}

double largest_error(Reciprocal method, ApproximationSource source, double from, int count) {
  const std::vector<float> all = decade(from, count);
  std::vector<float> found(all.size());
  if (source == ApproximationSource::kProcessor) {
    reciprocals(method, all, found);
  } else {
    std::ranges::transform(all, found.begin(), [&](float w) { return approximation(method, w); });
  }
  double largest = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    largest = std::max(largest, relative_error(method, all[i], found[i]));
  return largest;
}

// The bound for the relative error of an approximation. Processors guarantee 2^-14 with AVX-512,
// 1.5 * 2^-12 on earlier x86 (Intel's manual, RCP14PS and RCPPS), and 2^-8 with NEON, whose first
// estimate has 8 bits.
double error_of_approximation(ApproximationSource source, bool root) {
  if (source == ApproximationSource::kTable) return root ? kReciprocalRootError : kReciprocalError;
  switch (best_target()) {
    case Target::kAvx512:
      return 0x1p-14;
    case Target::kNeon:
      return 0x1p-8;
    case Target::kScalar:
      return unit_roundoff<float>;  // the scalar code divides
    default:
      return 1.5 * 0x1p-12;
  }
}

double predict(Reciprocal method, ApproximationSource source) {
  const double u = unit_roundoff<float>;
  constexpr double kMagicError = 0.0343758;  // largest relative error, Lomont 2003
  const double first = error_of_approximation(source, is_root(method));
  switch (method) {
    case Reciprocal::kDivide:
      return u;
    case Reciprocal::kApproximate:
    case Reciprocal::kRootApproximate:
      return first;
    case Reciprocal::kNewton:  // rounds w x and the last product; 2 - w x is exact
      return square(first) + 2 * u;
    case Reciprocal::
        // the rounding error of the root, which the division passes on in full, and its own
        kRootDivide:
      return 2 * u;
    case Reciprocal::kRootNewton:  // rounds two products of about 1/2, a difference, a product
      return 1.5 * square(first) + 3 * u;
    case Reciprocal::kMagic:
      return kMagicError;
    case Reciprocal::kMagicNewton:
      return 1.5 * square(kMagicError) - 0.5 * kMagicError * square(kMagicError);
  }
  return 0;
}

struct Series {
  Reciprocal method;
  ApproximationSource source;
  const char* name;
};
// A method with a table has the same values on every machine; its time is measured with the
// processor's own instruction.
constexpr Series kSeries[] = {
    {Reciprocal::kDivide, ApproximationSource::kProcessor, "division"},
    {Reciprocal::kApproximate, ApproximationSource::kProcessor, "approximate"},
    {Reciprocal::kNewton, ApproximationSource::kProcessor, "approximation and a Newton step"},
    {Reciprocal::kApproximate, ApproximationSource::kTable, "from a table"},
    {Reciprocal::kNewton, ApproximationSource::kTable, "table and a Newton step"},
    {Reciprocal::kRootDivide, ApproximationSource::kProcessor, "root and division"},
    {Reciprocal::kRootApproximate, ApproximationSource::kProcessor, "approximate"},
    {Reciprocal::kRootNewton, ApproximationSource::kProcessor, "approximation and a Newton step"},
    {Reciprocal::kRootApproximate, ApproximationSource::kTable, "from a table"},
    {Reciprocal::kRootNewton, ApproximationSource::kTable, "table and a Newton step"},
    {Reciprocal::kMagic, ApproximationSource::kProcessor, "0x5f3759df"},
    {Reciprocal::kMagicNewton, ApproximationSource::kProcessor,
     "constant 0x5f3759df and a Newton step"},
};

// A processor may be more accurate than its guarantee, by up to four bits. With a larger
// difference, another instruction than the approximation must have been measured.
std::optional<Finding> better_than_promised(ApproximationSource source) {
  if (source == ApproximationSource::kTable) return std::nullopt;
  return Finding{"the processor's instruction is more accurate than its maker promises", 1.0 / 16,
                 0.5};
}

constexpr int kTimed = 1 << 11;

// The input and output of 16 KiB fit into the first-level cache. A load waits for an earlier store
// whose address ends in the same 12 bits, so times would depend on the place in memory. Here the
// two arrays begin half of 4096 bytes apart, so no load has to wait.
struct TimedMemory {
  explicit TimedMemory(double from) { std::ranges::copy(decade(from, kTimed), w.begin()); }

  alignas(4096) std::array<float, kTimed> w;
  std::array<float, 512> apart;
  std::array<float, kTimed> out;
};

std::vector<Configuration> configurations(Effort effort) {
  const int count = effort == Effort::kFull ? 1'000'000 : 100'032;  // whole numbers of vectors
  constexpr int kRounds = 800;
  std::vector<Configuration> all;
  for (const Series& series : kSeries) {
    const Reciprocal method = series.method;
    const ApproximationSource source = series.source;
    for (const double from : {1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2}) {
      Configuration each{.series = series.name,
                         .parameter = from,
                         .scene = is_root(method) ? "1/sqrt(w)" : "1/w",
                         .error = [=] { return largest_error(method, source, from, count); },
                         .predicted_error = predict(method, source),
                         .finding = better_than_promised(source)};
      if (source == ApproximationSource::kProcessor) {
        each.work = [=, memory = std::make_shared<TimedMemory>(from)](int) {
          for (int i = 0; i < kRounds; ++i) {
            reciprocals(method, memory->w, memory->out);
            do_not_optimize(memory->out.back());
          }
        };
        each.items = double(kTimed) * kRounds;
      }
      all.push_back(std::move(each));
    }
  }
  return all;
}

}  // namespace d05

Experiment d05_reciprocal() {
  using namespace d05;
  return {.id = "D-5",
          .name = "Reciprocals: division, approximation, Newton step",
          .question = "How many digits do approximate reciprocals have, over six decades of w?",
          .axis = "w at the start of the decade",
          .error =
              "largest relative error; multiplied by u in texels, it is the error of a texture "
              "coordinate (in a texture of 4096 texels, 2^-11.7 is 1.2 texels)",
          .reference = "double",
          .theory =
              "The error is at most 2^-12 + 2^-14 for 1/w from a table of 2^11 entries of 13 bits, "
              "and 2^-12 + 2^-13.5 for 1/sqrt(w) from one of 2 x 2^10 entries. For the processor's "
              "own instruction, which is timed, it is the bound that its maker promises (2^-14 "
              "with AVX-512, 1.5 * 2^-12 on older x86). A Newton step squares the error (3/2 of "
              "the square for the root) and adds rounding errors of u = 2^-24 each. The constant "
              "0x5f3759df has the error 0.0344 (Lomont 2003)",
          .item = "reciprocal",
          .configurations = configurations};
}

}  // namespace glassbox::study
