// Measures how long frames of a scene take, alone or in alternation with those of a peer.
#pragma once

#include <optional>
#include <string>

#include <glassbox/base/error.h>

#include "study/bench/glassbox_peer.h"
#include "study/bench/memory_time_limit.h"
#include "study/bench/peer_process.h"
#include "study/bench/statistics.h"
#include "study/scenes/picture_match.h"
#include "study/scenes/scenes.h"

namespace glassbox::study {

struct PeerComparison {
  std::string peer;
  Quartiles ms;
  // The peer's time divided by ours, frame by frame in the order of drawing. These quartiles show
  // how much the ratio varies; the ratio of the medians does not.
  Quartiles frame_ratio;
  PictureMatch match;
};

struct Measurement {
  std::string scene;
  int threads = 1;
  int samples = 1;  // per pixel
  int frames = 0;   // number of frames from which medians are taken
  Quartiles ms;
  Traffic least;  // bytes that have to be moved at least
  std::optional<PeerComparison> peer_comparison;
  std::optional<StereoCost> stereo;  // only for scenes with two eyes
  // the time with culling of whole objects, only for scenes that are otherwise drawn without it
  std::optional<double> rejected_ms;

  double ratio() const { return peer_comparison->ms.median / ms.median; }
};

struct MeasureOptions {
  EngineOptions engine;
  int frames = 9;
};

// The number of frames that are drawn before the measured ones, and the number of frames that
// Glassbox or the peer draws before it is the other's turn.
inline constexpr int kWarmUpFrames = 3, kTurnFrames = 3;

// `peer` has the same scene, or is null if there is no peer. Glassbox and the peer draw three
// frames each in turn, so that both run under the same conditions.
Result<Measurement> measure(const BenchScene& bench, const MeasureOptions& options,
                            PeerProcess* peer);

}  // namespace glassbox::study
