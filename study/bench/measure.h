// How long frames of a scene take, alone or in alternation with a peer's.
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

struct Against {
  std::string peer;
  Quartiles ms;
  // The peer's time over ours, frame by frame in the order in which they were drawn: the spread of the ratio of medians.
  Quartiles frame_ratio;
  PictureMatch match;
};

struct Measurement {
  std::string scene;
  int threads = 1;
  int samples = 1;  // of a pixel
  int frames = 0;   // that the medians are of
  Quartiles ms;
  Traffic least;  // bytes that have to move
  std::optional<Against> against;
  std::optional<StereoCost> stereo;   // where the scene has two eyes
  std::optional<double> rejected_ms;  // where whole objects are not rejected: with rejection

  double ratio() const { return against->ms.median / ms.median; }
};

struct MeasureOptions {
  EngineOptions engine;
  int frames = 9;
};

// Frames before the measured ones, and in a turn of each side.
inline constexpr int kWarmUpFrames = 3, kTurnFrames = 3;

// `peer` (null: none) has the same scene. The two take turns of three frames, so that both see the same machine.
Result<Measurement> measure(const BenchScene& bench, const MeasureOptions& options,
                            PeerProcess* peer);

}  // namespace glassbox::study
