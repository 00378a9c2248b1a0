// Where and with what the numbers came about.
#pragma once

#include <string>

namespace glassbox::study {

// "Intel(R) Xeon(R) Processor, 2 processors"
std::string machine_name();
int processor_count();
// "g++ 12.2.0"
std::string compiler_name();

}  // namespace glassbox::study
