// Checks that this build rounds where the source code says so. A compiler can break that (see
// cmake/options.cmake), and then no picture is what it should be.
#include "tests/support/catch.h"

namespace {

// Hides a function from the optimizer: it cannot inline a call through the returned pointer, so the
// function is compiled as it would be for any caller.
template <class Function>
Function* opaque(Function* function) {
  Function* volatile hidden = function;
  return hidden;
}

// Code of the shape that the straight-line vectorizer of g++ 12.2 gets wrong at -O2: it multiplies
// the doubles before they are rounded to float.
void round_and_scale(const double* in, float* rounded, double* scaled) {
  const float x = float(in[0]), y = float(in[1]);
  rounded[0] = x;
  rounded[1] = y;
  scaled[0] = double(x) * 3;
  scaled[1] = double(y) * 3;
}

// With a * b + c rounded only once, as a fused operation does, the test below would get 2^-60, not
// 0.
double product_and_sum(double a, double b, double c) {
  return a * b + c;
}

}  // namespace

TEST_CASE("a number that was rounded to float stays rounded") {
  const double in[2] = {0.1, 0.2};
  float rounded[2];
  double scaled[2];
  opaque(round_and_scale)(in, rounded, scaled);
  // A product of 24 bits and 3 is exact in a double.
  CHECK(scaled[0] == double(rounded[0]) * 3);
  CHECK(scaled[1] == double(rounded[1]) * 3);
  CHECK(scaled[0] != in[0] * 3);
}

TEST_CASE("products are rounded before they are added to") {
  const double a = 1 + 0x1p-30;
  CHECK(opaque(product_and_sum)(a, a, -(1 + 0x1p-29)) == 0);
}
