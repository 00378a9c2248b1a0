// Threads beyond those that the machine has.
#pragma once

namespace glassbox {

// As many as the machine has for this program.
int default_threads();

// To be called before an arena of that many threads is made, so that oneTBB lets them work, which by itself starts no more
// than the machine has, and warns.
void allow_threads(int threads);

}  // namespace glassbox
