#include "labs/framework/varied_inputs.h"

#include <atomic>

namespace glassbox::labs {

namespace {

std::atomic<std::uint64_t> the_seed{0};

}  // namespace

std::uint64_t inputs_seed() {
  return the_seed;
}

void set_inputs_seed(std::uint64_t seed) {
  the_seed = seed;
}

}  // namespace glassbox::labs
