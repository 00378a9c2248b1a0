// As many float operations as a processor does in a second.
#pragma once

#include <cstdint>

namespace glassbox::study {

// Multiplications and additions, not fused, as the engine's are; in the widest vectors that this processor has. The number
// of operations done; `result` depends on all of them.
std::int64_t do_arithmetic(std::int64_t rounds, float& result);

}  // namespace glassbox::study
