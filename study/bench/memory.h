// What this process has of memory, by Linux's /proc; 0 where there is none.
#pragma once

namespace glassbox::study {

// The most bytes that were resident at once since the process, or the last reset_peak_bytes, began.
double peak_bytes();
void reset_peak_bytes();
// What programs may still have without swapping.
double available_bytes();

}  // namespace glassbox::study
