// Where and with what the numbers came about.
#pragma once

#include <string>

namespace glassbox::study {

// "Intel(R) Xeon(R) Processor, 2 processors"
std::string machine_name();
int processor_count();
// "48 KiB, 2 MiB and 260 MiB": of data, of one processor, from the first level on; empty where the system does not say.
std::string cache_sizes();
// The instruction set that vectors are drawn and measured with: "avx2".
std::string instruction_set();
// "g++ 12.2.0"
std::string compiler_name();

// What a machine is at while something is measured. NaN where the system does not say.
struct MachineState {
  double load =
      0;  // processes that ran or waited, the mean over the last minute: with nobody else about, this one
  double mhz = 0;  // of the fastest processor, as the system gives it
};
MachineState machine_state();

}  // namespace glassbox::study
