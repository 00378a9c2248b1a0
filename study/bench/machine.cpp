#include "study/bench/machine.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string_view>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <glassbox/base/counted.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox::study {

namespace {

// The values that /proc/cpuinfo lists under this key, one for each processor.
std::vector<std::string> processors_say(std::string_view what) {
  std::ifstream in("/proc/cpuinfo");
  std::vector<std::string> said;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(what)) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) said.push_back(line.substr(colon + 2));
  }
  return said;
}

std::string processor_name() {
  const std::vector<std::string> names = processors_say("model name");
  return names.empty() ? "unnamed processor" : names.front();
}

// The first line of a file; empty if the file does not exist.
std::string line_of(const std::string& path) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  return line;
}

// Takes a size as Linux writes it ("2048K") and returns it with a unit ("2 MiB").
std::string with_unit(const std::string& kibibytes) {
  const int size = std::atoi(kibibytes.c_str());
  return size < 1024 ? fmt::format("{} KiB", size) : fmt::format("{:g} MiB", size / 1024.0);
}

}  // namespace

int processor_count() {
  return std::max(1, int(std::thread::hardware_concurrency()));
}

std::string machine_name() {
  return processor_name() + ", " + counted(processor_count(), "processor");
}

std::string cache_sizes() {
  std::vector<std::string> sizes;
  for (int index = 0;; ++index) {
    const std::string cache = fmt::format("/sys/devices/system/cpu/cpu0/cache/index{}/", index);
    const std::string type = line_of(cache + "type");
    if (type.empty()) break;
    if (type != "Instruction") sizes.push_back(with_unit(line_of(cache + "size")));
  }
  if (sizes.size() < 2) return fmt::format("{}", fmt::join(sizes, ""));
  const std::string last = sizes.back();
  sizes.pop_back();
  return fmt::format("{} and {}", fmt::join(sizes, ", "), last);
}

std::string instruction_set() {
  return std::string(name_of(best_target()));
}

MachineState machine_state() {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  MachineState state{kUnknown, kUnknown};
  if (double load = 0; getloadavg(&load, 1) == 1) state.load = load;
  for (const std::string& mhz : processors_say("cpu MHz"))
    state.mhz = std::fmax(state.mhz, std::atof(mhz.c_str()));
  return state;
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
