// A picture of the tile engine, from the draw list to the framebuffer: the data that the picture's
// rounds (parts of its draws) share.
#pragma once

#include <vector>

#include <glassbox/render/engine/prepared_scene.h>
#include <glassbox/render/tile/tile_engine.h>
#include <glassbox/render/tile/tile_pass.h>

namespace glassbox {

// One eye's picture while the tile engine draws it.
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

  // Called before the first round (a part of the draws). `one_round`: it is also the last one.
  void prepare_framebuffer(bool one_round);

  // Returns what the tiles need to draw a round (a part of the draws). The pass refers to the
  // picture and the round.
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
  bool overwrite_untouched_ = false;  // keep_picture_ is not needed in tiles that read nothing back
  bool store_depth_ = false;
  // The data of the round that is being drawn, for its pass.
  std::vector<ShadeDraw> shades_;  // one for each slot
  std::vector<std::uint32_t> by_reference_;
};

}  // namespace glassbox
