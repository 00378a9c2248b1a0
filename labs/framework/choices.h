// The choices from which a generated input is made (cases.h). The same choices make the same input,
// and smaller choices make a simpler one. So the first input with a wrong answer is made simpler
// without a rule for each type of input: the program tries smaller choices while the answer stays
// wrong (shrink.h). The idea is that of Hypothesis (MacIver and Donaldson, "Test-case reduction via
// test-case generation", ECOOP 2020).
//
// A generator, Input make(Choices&), computes only with + - * /, std::sqrt, std::ldexp,
// std::nextafter and other functions whose results are rounded as IEEE 754 says, and draws one
// choice in a statement, because the order of a call's arguments is the compiler's. So runner and
// judge make the same numbers on every machine. Neither of them is compiled with contraction of
// a * b + c into one rounding.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

#include <glassbox/base/random.h>

namespace glassbox::labs {

class Choices {
public:
  // Chooses at random. The same seed gives the same choices.
  explicit Choices(std::uint64_t seed) : random_(seed) {}
  // Repeats choices that were made before. A choice that the generator does not offer becomes the
  // last one that it offers, and a choice that is missing becomes the simplest one.
  explicit Choices(std::vector<std::uint64_t> given)
      : random_(0), made_(std::move(given)), repeats_(true) {}

  // A number in [0, n); 0 is the simplest. n > 0.
  std::uint64_t below(std::uint64_t n) {
    if (repeats_) {
      const std::uint64_t given = next_ < made_.size() ? made_[next_] : 0;
      ++next_;
      return std::min(given, n - 1);
    }
    made_.push_back(random_.bits() % n);
    return made_.back();
  }
  bool flag() { return below(2) == 1; }

  // A whole number in [low, high], each equally likely. The one nearest to 0 is the simplest.
  // high - low < 2^63.
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    const std::int64_t simplest = std::clamp<std::int64_t>(0, low, high);
    const auto chosen = std::int64_t(below(std::uint64_t(high - low) + 1));
    // The order is 0, 1, -1, 2, -2, ... until one side has no more numbers.
    const std::int64_t both = std::min(high - simplest, simplest - low);
    if (chosen > 2 * both)
      return high - simplest > both ? simplest + (chosen - both) : simplest - (chosen - both);
    return chosen % 2 == 1 ? simplest + (chosen + 1) / 2 : simplest - chosen / 2;
  }

  // A whole number in [-2^bits, 2^bits] of any size: each number of binary digits is equally
  // likely. bits < 62.
  std::int64_t sized(int bits) {
    const auto digits = std::uint64_t(below(std::uint64_t(bits) + 1));
    return integer(-(std::int64_t(1) << digits), std::int64_t(1) << digits);
  }

  // One of a few values; the first is the simplest.
  template <class T>
  T one_of(std::initializer_list<T> values) {
    return values.begin()[below(values.size())];
  }

  // A finite double, not 0, with a magnitude in [2^lowest, 2^(highest + 1)): each power of two is
  // equally likely. The significand is 1, a number of few binary digits, the largest one below 2,
  // or any.
  double real(int lowest, int highest) {
    double significand = 1;
    switch (below(4)) {
      case 0:
        break;
      case 1:
        significand = 1 + double(below(16)) / 16;
        break;
      case 2:
        significand = 1 + double(below(std::uint64_t(1) << 52)) * 0x1p-52;
        break;
      default:
        significand = 2 - 0x1p-52;
    }
    const double magnitude = std::ldexp(significand, int(integer(lowest, highest)));
    return flag() ? -magnitude : magnitude;
  }

  // The magnitude of such a number.
  double positive(int lowest, int highest) { return std::abs(real(lowest, highest)); }

  // A multiple of 1/`steps` in [low, high].
  double multiple(std::int64_t low, std::int64_t high, std::int64_t steps) {
    return double(integer(low * steps, high * steps)) / double(steps);
  }

  // The number itself or one of its two neighbours, one ulp away.
  template <class Float>
  Float near(Float value) {
    const std::uint64_t which = below(3);
    if (which == 0) return value;
    return std::nextafter(value, Float(which == 1 ? HUGE_VAL : -HUGE_VAL));
  }

  // The choices made so far, or the given ones.
  const std::vector<std::uint64_t>& made() const { return made_; }

private:
  Random random_;
  std::vector<std::uint64_t> made_;
  bool repeats_ = false;
  std::size_t next_ = 0;
};

// Inputs of one kind, which a generator makes: "triangles with a corner on a pixel's centre".
template <class Input>
struct InputClass {
  const char* what;  // distinct within the check
  int count;         // how many inputs
  Input (*make)(Choices& choices);
};

// The seed of input number `index` of the class `what`. It depends on the student's seed, too.
inline std::uint64_t input_seed(std::uint64_t students_seed, const char* what, int index) {
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  for (const char* c = what; *c != '\0'; ++c)
    hash = (hash ^ static_cast<unsigned char>(*c)) * 0x100000001b3u;
  return Random(students_seed ^ Random(hash).bits()).bits() +
         std::uint64_t(index) * 0x632be59bd9b4e019u;
}

}  // namespace glassbox::labs
