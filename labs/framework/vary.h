// Inputs that differ from student to student, for cases.h: the same on both sides, since both make them of one number.
#pragma once

#include <cstdint>
#include <utility>

#include <glassbox/base/random.h>

namespace glassbox::labs {

// What the inputs of hidden checks are varied by; 0 where they are the lab's own. In a runner it comes from its command line, in a
// judge from set_inputs_seed().
std::uint64_t inputs_seed();

// The lab's own `seed`; where inputs vary, another, that belongs to the submission and to this one.
inline std::uint64_t varied_seed(std::uint64_t seed) {
  return inputs_seed() == 0 ? seed : Random(inputs_seed()).bits() ^ Random(seed).bits();
}
inline Random varied(std::uint64_t seed) {
  return Random(varied_seed(seed));
}

// The lab's own inputs, and behind them, where inputs vary, `count` that `make(random)` makes.
template <class Inputs, class Make>
Inputs with_varied(Inputs inputs, std::uint64_t seed, int count, Make make) {
  if (inputs_seed() == 0) return inputs;
  Random random = varied(seed);
  for (int i = 0; i < count; ++i) inputs.push_back(make(random));
  return inputs;
}

// For the judge's process alone.
void set_inputs_seed(std::uint64_t seed);

}  // namespace glassbox::labs
