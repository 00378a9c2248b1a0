#include "study/commands/bench/matching.h"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "cli/process/process.h"
#include "views/matching/winner.h"

#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox::study {

namespace {

// The Python interpreter that Debian's package is made for; another one in PATH has other modules.
constexpr const char* kPython = "/usr/bin/python3";
constexpr int kMissing = 3;  // exit code of kScript if OpenCV is not installed
constexpr ProcessLimits kPeerLimits{.seconds = 600};

// The script prints "version V", then "CPU WALL" in milliseconds for each repetition. It writes the
// disparities to the file `out`, in 16ths of a pixel.
constexpr const char* kScript = R"py(
import sys, time
try:
    import cv2
except ImportError:
    sys.exit(3)
left, right, first, count, block, p1, p2, mode, threads, frames, out = sys.argv[1:]
cv2.setNumThreads(int(threads))
matcher = cv2.StereoSGBM_create(minDisparity=int(first), numDisparities=int(count), blockSize=int(block), P1=int(p1), P2=int(p2),
                                disp12MaxDiff=1, mode=int(mode))
a, b = cv2.imread(left), cv2.imread(right)
print("version", cv2.__version__)
for frame in range(int(frames) + 1):
    cpu, wall = time.process_time(), time.perf_counter()
    disparity = matcher.compute(a, b)
    if frame > 0:
        print((time.process_time() - cpu) * 1e3, (time.perf_counter() - wall) * 1e3)
disparity.astype("<i2").tofile(out)
)py";

Result<std::string> run_script(const std::vector<std::string>& words) {
  std::vector<std::string> argv{kPython, "-c", kScript};
  argv.insert(argv.end(), words.begin(), words.end());
  const ProcessOutcome outcome = run_process(argv, kPeerLimits);
  if (!outcome.started || (WIFEXITED(outcome.status) && WEXITSTATUS(outcome.status) == kMissing)) {
    return fail("OpenCV", kPeerIsMissing, "apt install python3-opencv, or leave --against out");
  }
  if (outcome.status != 0) {
    return fail("OpenCV",
                outcome.timed_out ? "it took longer than the time limit"
                                  : "it failed to match the pictures",
                "leave --against out");
  }
  return outcome.printed;
}

// Reads disparities in 16ths of a pixel. A value below `first`, the smallest disparity searched,
// means that there is no disparity.
Result<Image<float>> read_disparity(const std::filesystem::path& path, int width, int height,
                                    int first) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  Image<float> disparity(width, height);
  if (bytes.size() != 2 * disparity.pixels.size()) {
    return fail("OpenCV", "its disparity map has another size than the pictures",
                "leave --against out");
  }
  for (std::size_t i = 0; i < disparity.pixels.size(); ++i) {
    const auto low = std::uint8_t(bytes[2 * i]), high = std::uint8_t(bytes[2 * i + 1]);
    const float value = float(std::int16_t(low | high << 8)) / 16;
    disparity.pixels[i] = value < float(first) ? views::kNoDisparity : value;
  }
  return disparity;
}

void fill_from_smaller_side(Image<float>& disparity) {
  for (int y = 0; y < disparity.height; ++y) {
    for (int x = 0; x < disparity.width;) {
      if (std::isfinite(disparity.at(x, y))) {
        ++x;
        continue;
      }
      int end = x;
      while (end < disparity.width && !std::isfinite(disparity.at(end, y))) ++end;
      const float before = x > 0 ? disparity.at(x - 1, y) : views::kNoDisparity;
      const float behind = end < disparity.width ? disparity.at(end, y) : views::kNoDisparity;
      for (; x < end; ++x) disparity.at(x, y) = std::min(before, behind);
    }
  }
}

}  // namespace

Result<PeerMatch> match_with_opencv(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                    const views::DisparityRange& range, PeerPaths paths,
                                    int threads, int frames, const std::filesystem::path& scratch) {
  const std::string left_file = scratch / "left.ppm", right_file = scratch / "right.ppm",
                    out = scratch / "disparity";
  for (const auto& [file, image] : {std::pair{&left_file, &left}, std::pair{&right_file, &right}}) {
    if (const auto written = write_file(*file, encode_ppm(*image)); !written) {
      return tl::unexpected(written.error());
    }
  }
  // OpenCV needs a number of disparities that is a multiple of 16; its mode 1 uses 8 paths, mode 2
  // uses 3 paths.
  const auto said = run_script({left_file, right_file, std::to_string(range.first),
                                std::to_string((range.count() + 15) / 16 * 16),
                                std::to_string(kPeerBlock), std::to_string(kPeerP1),
                                std::to_string(kPeerP2), paths == PeerPaths::kThree ? "2" : "1",
                                std::to_string(threads), std::to_string(frames), out});
  if (!said) return tl::unexpected(said.error());
  PeerMatch match;
  std::istringstream lines(*said);
  std::string word;
  lines >> word >> match.version;
  for (double cpu = 0, wall = 0; lines >> cpu >> wall;) {
    match.cpu_ms.push_back(cpu);
    match.wall_ms.push_back(wall);
  }
  if (word != "version" || int(match.cpu_ms.size()) != frames) {
    return fail("OpenCV", "it did not report its times", "leave --against out");
  }
  auto disparity = read_disparity(out, left.width, left.height, range.first);
  if (!disparity) return tl::unexpected(disparity.error());
  match.disparity = std::move(*disparity);
  fill_from_smaller_side(match.disparity);
  return match;
}

}  // namespace glassbox::study
