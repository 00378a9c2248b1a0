// OpenCV's semi-global matcher, which Debian's python3-opencv has: started at run time, in a process of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "views/matching/settings.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::app {

struct PeerMatch {
  std::string version;                  // "4.6.0"
  std::vector<double> cpu_ms, wall_ms;  // of each time
  Image<float> disparity;               // px; holes filled from the smaller side of their row
};

enum class PeerPaths { kThree, kEight };
inline const char* name_of(PeerPaths paths) {
  return paths == PeerPaths::kThree ? "OpenCV, 3 paths" : "OpenCV, 8 paths";
}

// What StereoSGBM is told: the side of its blocks, px, and its penalties.
inline constexpr int kPeerBlock = 3, kPeerP1 = 216, kPeerP2 = 864;
// The cause of the error where there is no OpenCV.
inline constexpr const char* kPeerIsMissing = "it is not installed for /usr/bin/python3";

// StereoSGBM with its left-right check: `frames` times after one that is not measured. `scratch` is a
// directory for the files that go to and fro. An error where there is no OpenCV.
Result<PeerMatch> match_with_opencv(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                    const views::DisparityRange& range, PeerPaths paths,
                                    int threads, int frames, const std::filesystem::path& scratch);

}  // namespace glassbox::app
