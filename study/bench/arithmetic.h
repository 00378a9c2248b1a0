// Measures how many float operations a processor does in a second.
#pragma once

#include <cstdint>

namespace glassbox::study {

// Does float multiplications and additions in the widest vectors of this processor; like the
// engine, it does not fuse the two into one instruction. Returns the number of operations done;
// `result` depends on all of them, so that the compiler cannot leave them out.
std::int64_t do_arithmetic(std::int64_t rounds, float& result);

}  // namespace glassbox::study
