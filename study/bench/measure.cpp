#include "study/bench/measure.h"

#include <algorithm>
#include <vector>

namespace glassbox::study {

namespace {

std::vector<double> draw(GlassboxPeer& glassbox, int frames) {
  std::vector<double> times;
  for (int i = 0; i < frames; ++i) times.push_back(glassbox.frame_ms());
  return times;
}

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

Quartiles ratios(const std::vector<double>& over, const std::vector<double>& under) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < over.size(); ++i) ratios.push_back(over[i] / under[i]);
  return quartiles(std::move(ratios));
}

double rejected_ms(BenchScene bench, const MeasureOptions& options) {
  bench.reject_objects = true;
  GlassboxPeer glassbox(bench, options.engine);
  draw(glassbox, kWarmUpFrames);
  return median(draw(glassbox, options.frames));
}

}  // namespace

Result<Measurement> measure(const BenchScene& bench, const MeasureOptions& options,
                            PeerProcess* peer) {
  Measurement found;
  found.scene = bench.name;
  found.threads = options.engine.tile.threads;
  found.samples = bench.settings.samples;
  found.frames = options.frames;
  found.least = least_traffic(bench);

  GlassboxPeer glassbox(bench, options.engine);
  draw(glassbox, kWarmUpFrames);
  if (peer != nullptr) {
    if (const auto warm = peer->frames(kWarmUpFrames); !warm) return tl::unexpected(warm.error());
  }
  std::vector<double> ours, theirs;
  for (int left = options.frames; left > 0; left -= kTurnFrames) {
    const int turn = std::min(left, kTurnFrames);
    append(ours, draw(glassbox, turn));
    if (peer == nullptr) continue;
    const auto times = peer->frames(turn);
    if (!times) return tl::unexpected(times.error());
    append(theirs, *times);
  }
  found.ms = quartiles(ours);
  if (peer != nullptr) {
    const auto picture = peer->picture(bench.width(), bench.height());
    if (!picture) return tl::unexpected(picture.error());
    found.peer_comparison =
        PeerComparison{peer->description(), quartiles(theirs), ratios(theirs, ours),
                       match(glassbox.picture(), *picture)};
  }
  if (bench.stereo) found.stereo = stereo_cost(bench, options.engine, options.frames);
  if (!bench.reject_objects) found.rejected_ms = rejected_ms(bench, options);
  return found;
}

}  // namespace glassbox::study
