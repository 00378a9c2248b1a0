// How many threads a run uses, which may be more than the machine has.
#pragma once

namespace glassbox {

// The number of hardware threads that the machine has for this program.
int default_threads();

// Must be called before an arena of this many threads is made. Otherwise oneTBB starts no more
// threads than the machine has, and warns.
void allow_threads(int threads);

}  // namespace glassbox
