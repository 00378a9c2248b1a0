#include "study/bench/memory.h"

#include <fstream>
#include <sstream>
#include <string>

namespace glassbox::study {

namespace {

// Returns the value of a line such as "VmHWM:   123456 kB", in bytes.
double field(const char* file, const std::string& name) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(name + ":")) continue;
    std::istringstream words(line.substr(name.size() + 1));
    double kilobytes = 0;
    words >> kilobytes;
    return 1024 * kilobytes;
  }
  return 0;
}

}  // namespace

double peak_bytes() {
  return field("/proc/self/status", "VmHWM");
}

// Writing 5 resets the peak to the memory that is resident now, see proc(5).
void reset_peak_bytes() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

double available_bytes() {
  return field("/proc/meminfo", "MemAvailable");
}

}  // namespace glassbox::study
