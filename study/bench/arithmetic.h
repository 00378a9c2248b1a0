// Measures how many float operations a processor does in a second.
#pragma once

#include <cstdint>

namespace glassbox::study {

// Does multiplications and additions (not fused, like those of the engine) in the widest vectors of
// this processor. Returns the number of operations done; `result` depends on all of them, so that
// the compiler cannot leave them out.
std::int64_t do_arithmetic(std::int64_t rounds, float& result);

}  // namespace glassbox::study
