// Inputs that differ from student to student, for cases.h. Runner and judge have the same inputs,
// since both make them from the same number.
#pragma once

#include <cstdint>
#include <utility>

#include <glassbox/base/random.h>

namespace glassbox::labs {

// The number from which the inputs of hidden checks are varied; 0 if only the lab's own inputs are
// used. A runner gets it from its command line, a judge from set_inputs_seed().
std::uint64_t inputs_seed();

// The given `seed` if inputs_seed() is 0, otherwise one that depends on inputs_seed() (which
// differs from submission to submission) and on `seed`.
inline std::uint64_t varied_seed(std::uint64_t seed) {
  return inputs_seed() == 0 ? seed : Random(inputs_seed()).bits() ^ Random(seed).bits();
}
inline Random varied(std::uint64_t seed) {
  return Random(varied_seed(seed));
}

// The lab's own inputs; unless inputs_seed() is 0, they are followed by `count` random inputs, each
// made by make(random).
template <class Inputs, class Make>
Inputs with_varied(Inputs inputs, std::uint64_t seed, int count, Make make) {
  if (inputs_seed() == 0) return inputs;
  Random random = varied(seed);
  for (int i = 0; i < count; ++i) inputs.push_back(make(random));
  return inputs;
}

// Called only by the judge's process.
void set_inputs_seed(std::uint64_t seed);

}  // namespace glassbox::labs
