// Calls your functions with the cases of lab 13.
#include "labs/framework/runner.h"
#include "generators.h"
#include "student.h"

namespace lab_13 {
namespace {

using glassbox::labs::Answer;

void order(const OrderCase& input, Answer& answer) {
  const Order found = classify(input.cameras, input.box);
  answer.emit("kind", {double(found.kind)});
  answer.emit("away", {double(found.away[0]), double(found.away[1]), double(found.away[2])});
}

void deviation(const ColoursCase& input, Answer& answer) {
  const Statistics found = statistics(input.colours);
  answer.emit("mean", {found.mean[0], found.mean[1], found.mean[2]});
  answer.emit("deviation", {found.deviation});
}

void verdict(const JudgeCase& input, Answer& answer) {
  answer.emit("verdict", {double(judge(input.pictures, input.threshold))});
}

void pixels(const FootprintCase& input, Answer& answer) {
  std::vector<double> all;
  for (const PixelAt& pixel :
       footprint(input.pixel_from_grid, input.voxel, input.width, input.height)) {
    all.push_back(pixel.column);
    all.push_back(pixel.row);
  }
  answer.emit("columns and rows", all);
}

void coloured(const SweepCase& input, Answer& answer) {
  std::vector<double> places, colours;
  for (const Coloured& voxel : sweep(input.pictures, input.grid, input.threshold)) {
    for (const int coordinate : {voxel.at.x, voxel.at.y, voxel.at.z}) places.push_back(coordinate);
    colours.insert(colours.end(), voxel.mean.begin(), voxel.mean.end());
  }
  answer.emit("voxels", places);
  answer.emit("colours", colours);
}

}  // namespace
}  // namespace lab_13

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_13;
  return {
      check("how cameras stand to the box", orders(), order),
      check("mean and deviation of colours", colours(), deviation),
      check("what becomes of a voxel", judged(), verdict),
      check("the pixels of a voxel", footprints(), pixels),
      check("voxels are coloured layer after layer", sweeps(), coloured),
      generated_check("cameras anywhere", generated_orders(), order),
      generated_check("any colours", generated_colours(), deviation),
      generated_check("any voxel", generated_judged(), verdict),
      generated_check("the pixels of any voxel", generated_footprints(), pixels),
      generated_check("any grid and pictures", generated_sweeps(), coloured),
      // BEGIN HIDDEN
      check("how other cameras stand", hidden_orders(), order),
      check("mean and deviation of other colours", hidden_colours(), deviation),
      check("what becomes of other voxels", hidden_judged(), verdict),
      check("the pixels of other voxels", hidden_footprints(), pixels),
      check("other voxels are coloured", hidden_sweeps(), coloured),
      // END HIDDEN
  };
}
