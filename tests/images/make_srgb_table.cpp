// Prints images/srgb_table.h. The test of the table shares none of this code: it checks every entry
// on both sides.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdio>
#include <limits>

namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

// The linear light of an encoded value in [0, 1], by IEC 61966-2-1.
Real light_of(const Real& encoded) {
  if (encoded <= Real("0.04045")) return encoded / Real("12.92");
  return pow((encoded + Real("0.055")) / Real("1.055"), Real("2.4"));
}

float smallest_float_not_below(const Real& value) {
  float candidate = float(value);
  while (Real(candidate) < value) {
    candidate = std::nextafter(candidate, std::numeric_limits<float>::infinity());
  }
  return candidate;
}

template <class Entry>
void print_table(const char* comment, const char* name, Entry entry) {
  std::printf("// %s\ninline constexpr std::array<float, 256> %s = {", comment, name);
  for (int k = 0; k < 256; ++k)
    std::printf("%s%af,", k % 4 == 0 ? "\n    " : " ", double(entry(k)));
  std::printf("\n};\n\n");
}

}  // namespace

int main() {
  std::printf(
      "// Made by tests/images/make_srgb_table.cpp; tests/images/srgb_test.cpp proves every "
      "entry.\n"
      "// clang-format off\n#pragma once\n\n#include <array>\n\nnamespace glassbox {\n\n");
  print_table("The light of each sRGB byte, correctly rounded.", "kLinearOfSrgb",
              [](int k) { return float(light_of(Real(k) / 255)); });
  print_table(
      "The smallest float that encodes to at least this byte.", "kSrgbThreshold", [](int k) {
        return k == 0 ? 0.0f : smallest_float_not_below(light_of((Real(k) - Real("0.5")) / 255));
      });
  std::printf("}  // namespace glassbox\n");
}
