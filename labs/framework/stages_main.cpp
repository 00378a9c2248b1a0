// The program around a lab's stages: passes a batch of records to one of them and writes the
// results.
//
//   stages --stage NAME [--rounds N] --out-fd N
//
// Standard input is a file in memory that consists of doubles: [0] how many records have been
// begun; this program writes it, so that the program that started it can tell during which record
// it ended; [1] how many records there are; then each record as its length and its numbers. The
// answers have the same form, without the first two numbers. With --rounds the work of each record
// is done N times, and the answers are the times of each round in nanoseconds, processor time and
// wall time in turn. Uses only the standard library.
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>

#include "labs/framework/stages.h"

namespace {

using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;
using glassbox::labs::StageFunction;

constexpr std::size_t kBlock = 32768;  // as soon as so many numbers are there, they are written

bool write_all(int to, const Numbers& block) {
  const char* at = reinterpret_cast<const char*>(block.data());
  for (std::size_t left = block.size() * sizeof(double); left > 0;) {
    const ssize_t written = ::write(to, at, left);
    if (written <= 0) return false;
    at += written;
    left -= std::size_t(written);
  }
  return true;
}

double nanoseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e9 * double(now.tv_sec) + double(now.tv_nsec);
}

struct CallTime {
  double processor = 0, wall = 0;  // ns per call
};

// Uses the clock of the thread, because the clock of a process whose processor time is limited
// advances only with the system's ticks, which are milliseconds apart.
CallTime measure_call_time(const std::function<void()>& work, int calls) {
  const double wall = nanoseconds(CLOCK_MONOTONIC);
  const double processor = nanoseconds(CLOCK_THREAD_CPUTIME_ID);
  for (int i = 0; i < calls; ++i) work();
  const double used = nanoseconds(CLOCK_THREAD_CPUTIME_ID) - processor;
  return {used / calls, (nanoseconds(CLOCK_MONOTONIC) - wall) / calls};
}

// Measures the time of each round. A first call, which is not measured, fills the caches and maps
// the memory. Short work is called several times in a round.
void time_rounds(const std::function<void()>& work, int rounds, Numbers& out) {
  constexpr double kMinRound = 2e5;  // ns per round; reading a clock takes some 50 ns
  work();
  const double once = std::max(measure_call_time(work, 1).wall, 1.0);
  const int calls = int(std::clamp(std::ceil(kMinRound / once), 1.0, 1e5));
  for (int round = 0; round < rounds; ++round) {
    const CallTime taken = measure_call_time(work, calls);
    out.insert(out.end(), {taken.processor, taken.wall});
  }
}

int run(const StageFunction& stage, int rounds, volatile double* begun, const double* at,
        const double* end, int to) {
  const auto records = std::size_t(*at++);
  Numbers block;
  for (std::size_t i = 0; i < records && at < end; ++i) {
    *begun = double(i + 1);
    const auto count = std::size_t(*at++);
    RecordReader in(at, count);
    at += count;
    const std::size_t head = block.size();
    block.push_back(0);
    if (rounds > 0 && stage.prepare) {
      time_rounds(stage.prepare(in), rounds, block);
    } else {
      stage.run(in, block);
    }
    block[head] = double(block.size() - head - 1);
    if (block.size() >= kBlock) {
      if (!write_all(to, block)) return 1;
      block.clear();
    }
  }
  return write_all(to, block) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const char* name = "";
  int to = 1, rounds = 0;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--stage") == 0) name = argv[i + 1];
    if (std::strcmp(argv[i], "--rounds") == 0) rounds = std::atoi(argv[i + 1]);
    if (std::strcmp(argv[i], "--out-fd") == 0) to = std::atoi(argv[i + 1]);
  }
  struct stat file = {};
  if (::fstat(0, &file) != 0 || file.st_size < off_t(2 * sizeof(double))) return 2;
  const auto bytes = std::size_t(file.st_size);
  void* const input = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, 0, 0);
  if (input == MAP_FAILED) return 2;
  auto* const numbers = static_cast<double*>(input);
  for (const StageFunction& stage : glassbox::labs::stage_functions()) {
    if (stage.name != name) continue;
    try {
      return run(stage, rounds, numbers, numbers + 1, numbers + bytes / sizeof(double), to);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "threw \"%.500s\"\n", error.what());
    } catch (...) {
      std::fprintf(stderr, "threw something that is not a std::exception\n");
    }
    return 3;
  }
  return 2;
}
