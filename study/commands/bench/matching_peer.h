// OpenCV's semi-global matcher from Debian's python3-opencv, run as a separate process.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "views/matching/settings.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::study {

struct PeerMatch {
  std::string version;                  // "4.6.0"
  std::vector<double> cpu_ms, wall_ms;  // of each repetition
  // px; each hole gets the smaller of its two neighbours in the row
  Image<float> disparity;
};

enum class PeerPaths { kThree, kEight };
inline const char* name_of(PeerPaths paths) {
  return paths == PeerPaths::kThree ? "OpenCV, 3 paths" : "OpenCV, 8 paths";
}

// Parameters of StereoSGBM: the side of its blocks in px, and its two smoothness penalties.
inline constexpr int kPeerBlock = 3, kPeerP1 = 216, kPeerP2 = 864;
// The cause of the error if OpenCV is not installed.
inline constexpr const char* kPeerIsMissing = "it is not installed for /usr/bin/python3";

// Runs StereoSGBM with its left-right check: `frames` measured repetitions, after one that is not
// measured. `scratch` is a directory for the files exchanged with the process. An error if OpenCV
// is not installed.
Result<PeerMatch> match_with_opencv(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                    const views::DisparityRange& range, PeerPaths paths,
                                    int threads, int frames, const std::filesystem::path& scratch);

}  // namespace glassbox::study
