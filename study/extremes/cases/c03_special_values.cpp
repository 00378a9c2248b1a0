#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/projection.h>

#include <bit>
#include <cfenv>

#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/camera.h"
#include "study/naive/projection.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace glassbox::study {
namespace c03 {

// Reads the control register for floating-point arithmetic, if the processor has one of this kind.
unsigned float_control() {
#if defined(__SSE2__)
  return _mm_getcsr();
#else
  return 0;
#endif
}
void set_float_control([[maybe_unused]] unsigned word) {
#if defined(__SSE2__)
  _mm_setcsr(word);
#endif
}

// While an object of this class exists, subnormal numbers are treated as zero, if the processor can
// do that.
class FlushToZero {
public:
  FlushToZero() : before_(float_control()) { set_float_control(before_ | 0x8040u); }
  ~FlushToZero() { set_float_control(before_); }
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

private:
  unsigned before_;
};

struct Cameras {
  LookAt look_at;
  Result<Transform<Clip, Eye>> (*lens)(double fovy_degrees, double near, double far);
  Result<WorldMap> (*inverse)(const WorldMap&);
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kSubnormal = 0x1p-1060;

std::vector<glm::dmat4> answers(const Cameras& cameras, bool bad) {
  std::vector<glm::dmat4> all;
  const auto add = [&](const auto& result) {
    if (result) all.push_back(result->columns);
  };
  const WorldPoint eye{1, 2, 3}, target{0, 0, 0};
  if (bad) {
    for (const WorldVector& up : {WorldVector(0, 0, 0), WorldVector(0, kNaN, 0),
                                  WorldVector(0, kInfinity, 0), WorldVector(0, kSubnormal, 0)}) {
      add(cameras.look_at(eye, target, up));
    }
    for (const double x : {kNaN, kInfinity}) add(cameras.look_at({x, 2, 3}, target, {0, 1, 0}));
    for (const double fovy : {kNaN, kInfinity, 0.0}) add(cameras.lens(fovy, 0.1, 100));
    for (const double near : {kNaN, -kInfinity, 0.0}) add(cameras.lens(60, near, 100));
    WorldMap not_finite;
    not_finite.at(1, 1) = kNaN;
    add(cameras.inverse(not_finite));
  } else {
    add(cameras.look_at(eye, target, {0x1p-1020, 1, 0x1p-1040}));
    add(cameras.look_at({0x1p-1050, 0, 3}, target, {0, 1, 0}));
    add(cameras.lens(60, 0x1p-100, 1e30));
    add(cameras.inverse(shear<World>(Axis::kX, Axis::kY, 0x1p-1060) *
                        scale<World>(0x1p-100, 1, 0x1p100)));
  }
  return all;
}

bool same_bytes(const std::vector<glm::dmat4>& a, const std::vector<glm::dmat4>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int k = 0; k < 16; ++k) {
      const double x = a[i][k / 4][k % 4], y = b[i][k / 4][k % 4];
      // Matrices are rounded to float before they are applied, so values may differ if both become
      // zero in float.
      if (std::bit_cast<std::uint64_t>(x) != std::bit_cast<std::uint64_t>(y) &&
          std::max(std::abs(x), std::abs(y)) >= 0x1p-150) {
        return false;
      }
    }
  }
  return true;
}

Outcome measure_error(auto look_at_by, auto lens_by, auto inverse_by) {
  const Cameras cameras{look_at_by, lens_by, inverse_by};
  const int accepted = int(answers(cameras, true).size());
  const auto good = answers(cameras, false);
  const auto flushed = [&] {
    const FlushToZero flush;
    return answers(cameras, false);
  }();
  const int refused = 4 - int(good.size()), different = same_bytes(good, flushed) ? 0 : 1;
  return wrong_count_outcome(accepted + refused + different, 13 + 4 + 1, "answers are wrong",
                             fmt::format("; {} of 13 impossible inputs were accepted", accepted));
}

Result<Transform<Clip, Eye>> checked_lens(double fovy, double near, double far) {
  return perspective_degrees(fovy, 1, {near, far});
}
Result<WorldMap> checked_inverse(const WorldMap& m) {
  return inverse_affine(m);
}
Result<Transform<Clip, Eye>> unchecked_lens(double fovy, double near, double far) {
  return naive::unchecked_perspective(float(fovy), 1, float(near), float(far));
}
Result<WorldMap> unchecked_inverse(const WorldMap& m) {
  return WorldMap(glm::inverse(m.columns));
}

// The right code, but with "<= 0" instead of "not > 0": every comparison with NaN is false.
Result<Transform<Clip, Eye>> lens_that_lets_nan_through(double fovy, double near, double far) {
  if (fovy <= 0 || fovy >= 180 || near <= 0 || far <= near) {
    return fail("lens", "out of range", "choose other planes");
  }
  return unchecked_lens(fovy, near, far);
}

}  // namespace c03

ExtremeCase c03_special_values() {
  using namespace c03;
  return {
      .id = "C-03",
      .name = "Zero, NaN, infinity and subnormals as input",
      .construction =
          "13 ups, eyes, angles, planes and matrices with 0, NaN, infinity or 2^-1060; 4 valid "
          "ones with subnormal parts, with and without flush to zero",
      .stage = "look-at",
      .right_answer =
          "all 13 are refused; all 4 are accepted and give the same bytes, with and without flush "
          "to zero",
      .unit = "answers",
      .oracle = Oracle::kProperty,
      .ours = {"look_at, perspective, inverse_affine",
               [] { return measure_error(look_at, checked_lens, checked_inverse); }},
      .naive = {"no input is checked",
                [] {
                  return measure_error(naive::unchecked_look_at, unchecked_lens, unchecked_inverse);
                }},
      .mutants =
          {{"the checks of the lens ask for \"<= 0\" in place of \"not > 0\", which accepts NaN",
            [] { return measure_error(look_at, lens_that_lets_nan_through, checked_inverse); }}},
      .not_drawn = "files and cameras with such numbers are refused before anything is drawn",
      .exceptions_of_ours = FE_INVALID,  // because NaN is compared
  };
}

}  // namespace glassbox::study
