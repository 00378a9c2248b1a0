#include "study/bench/machine.h"

#include <algorithm>
#include <fstream>
#include <thread>

#include <fmt/format.h>

#include <glassbox/base/counted.h>

namespace glassbox::study {

namespace {

std::string processor_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unnamed processor";
}

}  // namespace

int processor_count() {
  return std::max(1, int(std::thread::hardware_concurrency()));
}

std::string machine_name() {
  return processor_name() + ", " + counted(processor_count(), "processor");
}

std::string compiler_name() {
#if defined(__clang__)
  return fmt::format("clang++ {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
  return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
  return "another compiler";
#endif
}

}  // namespace glassbox::study
