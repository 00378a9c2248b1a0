// The memory of this process as Linux reports it in /proc; 0 if there is no /proc.
#pragma once

namespace glassbox::study {

// The largest number of bytes resident at once since the process started, or since the last call of
// reset_peak_bytes.
double peak_bytes();
void reset_peak_bytes();
// The memory that programs can still use without swapping, in bytes.
double available_bytes();

}  // namespace glassbox::study
