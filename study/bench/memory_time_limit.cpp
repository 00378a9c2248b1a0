#include "study/bench/memory_time_limit.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <functional>
#include <latch>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include "study/bench/arithmetic.h"

namespace glassbox::study {

namespace {

constexpr std::size_t kWords = std::size_t(1) << 24;  // 8-byte words per thread: 128 MiB
constexpr int kRuns = 7;

using Clock = std::chrono::steady_clock;

// When a thread began and finished its work. The thread itself reads the clock, because the thread
// that waits for it may notice the end late.
struct Span {
  Clock::time_point begin, end;
};

// Returns the seconds that `work` takes if it runs on this many threads at once; `work` gets the
// number of its thread. This is the least time of several runs; a run lasts from the begin of its
// first thread to the end of its last one.
double least_seconds(int threads, const std::function<void(int)>& work) {
  double least = 0;
  for (int run = 0; run < kRuns; ++run) {
    std::latch ready(threads);
    std::vector<Span> spans(static_cast<std::size_t>(threads));
    std::vector<std::jthread> all;
    for (int i = 0; i < threads; ++i) {
      all.emplace_back([&, i] {
        Span& span = spans[std::size_t(i)];
        ready.arrive_and_wait();
        span.begin = Clock::now();
        work(i);
        span.end = Clock::now();
      });
    }
    all.clear();  // joins all threads
    const auto begin = std::ranges::min(spans, {}, &Span::begin).begin;
    const auto end = std::ranges::max(spans, {}, &Span::end).end;
    const double seconds = std::chrono::duration<double>(end - begin).count();
    least = run == 0 ? seconds : std::min(least, seconds);
  }
  return least;
}

double table_bytes(const Mesh& mesh) {
  constexpr double kIndexBytes = 4;
  return double(mesh.positions.size() * sizeof(Point<Object>) +
                mesh.normals.size() * sizeof(Normal<Object>) +
                mesh.texcoords.size() * sizeof(TexCoord) + mesh.colors.size() * sizeof(Rgba)) +
         kIndexBytes * double(mesh.corners.size());
}

}  // namespace

Floor measure_floor(int threads) {
  constexpr std::int64_t kRounds = 4'000'000;
  std::vector<std::vector<std::uint64_t>> memory(std::size_t(threads),
                                                 std::vector<std::uint64_t>(kWords, 1));
  std::vector<std::uint64_t> sums(std::size_t(threads), 0);
  std::vector<float> results(std::size_t(threads), 0);
  std::vector<std::int64_t> operations(std::size_t(threads), 0);
  const auto block = [&](int i) -> std::vector<std::uint64_t>& { return memory[std::size_t(i)]; };

  const double reading = least_seconds(threads, [&](int i) {
    sums[std::size_t(i)] = std::accumulate(block(i).begin(), block(i).end(), std::uint64_t(0));
  });
  const double writing = least_seconds(threads, [&](int i) {
    std::memset(block(i).data(), int(sums[std::size_t(i)] & 1u), kWords * sizeof(std::uint64_t));
  });
  const double calculating = least_seconds(threads, [&](int i) {
    operations[std::size_t(i)] = do_arithmetic(kRounds, results[std::size_t(i)]);
  });
  const double bytes = double(threads) * double(kWords * sizeof(std::uint64_t));
  return {threads, bytes / reading, bytes / writing,
          double(std::reduce(operations.begin(), operations.end())) / calculating};
}

Traffic least_traffic(const BenchScene& bench) {
  double read = 0;
  std::set<std::uint32_t> meshes;
  for (const Instance& instance : bench.scene.instances) meshes.insert(instance.mesh);
  for (const std::uint32_t mesh : meshes) read += table_bytes(bench.scene.meshes[mesh]);
  for (const Image<Rgba8>& image : bench.scene.images) {
    read += double(image.pixels.size() * sizeof(Rgba8));
  }
  const double pixels = double(bench.width()) * double(bench.height());
  const double passes = double(bench.passes.size());
  return {passes * read, pixels * (sizeof(Rgba8) + passes * sizeof(std::uint32_t))};
}

}  // namespace glassbox::study
