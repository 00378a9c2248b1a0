#include "study/bench/memory.h"

#include <fstream>
#include <sstream>
#include <string>

namespace glassbox::study {

namespace {

// "VmHWM:   123456 kB" in bytes.
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

// proc(5): writing 5 resets the peak to what is resident.
void reset_peak_bytes() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

double available_bytes() {
  return field("/proc/meminfo", "MemAvailable");
}

}  // namespace glassbox::study
