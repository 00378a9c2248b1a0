// Describes the machine and the compiler with which the numbers were measured.
#pragma once

#include <string>

namespace glassbox::study {

// For example "Intel(R) Xeon(R) Processor, 2 processors".
std::string machine_name();
int processor_count();
// The data caches of one processor from level 1 on, for example "48 KiB, 2 MiB and 260 MiB"; empty
// if the system does not report them.
std::string cache_sizes();
// The instruction set of the vector code, for drawing and for measuring, for example "avx2".
std::string instruction_set();
// For example "g++ 12.2.0".
std::string compiler_name();

// The state of the machine while something is measured. NaN if the system does not report a value.
struct MachineState {
  double load = 0;  // mean number of runnable processes in the last minute; 1 if only this one runs
  double mhz = 0;   // clock of the fastest processor, as the system reports it
};
MachineState machine_state();

}  // namespace glassbox::study
