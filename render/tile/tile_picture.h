// A picture of the tile engine, from the draw list to the planes of the framebuffer: the data that
// its rounds share.
#pragma once

#include <vector>

#include <glassbox/render/engine/prepared_scene.h>
#include <glassbox/render/tile/tile_engine.h>
#include <glassbox/render/tile/tile_pass.h>

namespace glassbox {

// One eye's part in a run.
class TilePicture {
public:
  // The list and the plan must outlive it.
  TilePicture(const EyePicture& eye, const DrawList& list, const Plan& plan, int tile_side);
  TilePicture(const TilePicture&) = delete;  // passes refer to it
  TilePicture& operator=(const TilePicture&) = delete;

  const TileRun& run() const { return run_; }
  Statistics& statistics() const { return eye_.statistics; }
  const Plan& plan() const { return plan_; }

  void count_input() const;

  // Called before the first round. `one_round`: it is also the last one.
  void prepare_framebuffer(bool one_round);

  // Returns what the tiles of a round need to be drawn. The pass refers to the picture and the
  // round.
  TilePass pass(const Kernels& kernels, const DrawRound& round, bool first_round);

  // Called after the last round.
  void finish() const;

private:
  bool draws_into_framebuffer() const;

  const EyePicture& eye_;
  const DrawList& list_;
  const Plan& plan_;
  const TileRun run_;
  bool keep_picture_ = false;         // pixels where nothing is seen already have their values
  bool overwrite_untouched_ = false;  // except in tiles that read nothing back
  bool store_depth_ = false;
  // The data of the current round, for its pass.
  std::vector<ShadeDraw> shades_;  // by slot
  std::vector<std::uint32_t> by_reference_;
};

}  // namespace glassbox
