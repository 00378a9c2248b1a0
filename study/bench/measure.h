// Measures how long frames of a scene take, alone or in alternation with those of a peer.
#pragma once

#include <optional>
#include <string>

#include <glassbox/base/error.h>

#include "study/bench/floor.h"
#include "study/bench/glassbox_peer.h"
#include "study/bench/peer_process.h"
#include "study/bench/statistics.h"
#include "study/scenes/picture_match.h"
#include "study/scenes/scenes.h"

namespace glassbox::study {

struct PeerComparison {
  std::string peer;
  Quartiles ms;
  // The peer's time divided by ours, frame by frame in the order of drawing: shows the spread
  // behind the ratio of the medians.
  Quartiles frame_ratio;
  PictureMatch match;
};

struct Measurement {
  std::string scene;
  int threads = 1;
  int samples = 1;  // per pixel
  int frames = 0;   // number of frames behind the medians
  Quartiles ms;
  Traffic least;  // bytes that have to be moved at least
  std::optional<PeerComparison> peer_comparison;
  std::optional<StereoCost> stereo;  // only for scenes with two eyes
  // for scenes drawn without culling of whole objects: the time with it
  std::optional<double> rejected_ms;

  double ratio() const { return peer_comparison->ms.median / ms.median; }
};

struct MeasureOptions {
  EngineOptions engine;
  int frames = 9;
};

// The number of frames before the measured ones, and of those that each side draws in its turn.
inline constexpr int kWarmUpFrames = 3, kTurnFrames = 3;

// `peer` (null: there is none) has the same scene. The two take turns of three frames, so that both
// run under the same conditions.
Result<Measurement> measure(const BenchScene& bench, const MeasureOptions& options,
                            PeerProcess* peer);

}  // namespace glassbox::study
