// The expected answers of lab 13, from reference.h, which follows the definitions word for word.
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "labs/13-voxels/generators.h"
#include "labs/13-voxels/reference.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

using namespace lab_13;

Case expect_kind(const OrderCase& input) {
  std::string text =
      fmt::format("box ({}, {}, {}) to ({}, {}, {})", input.box.low.x, input.box.low.y,
                  input.box.low.z, input.box.high.x, input.box.high.y, input.box.high.z);
  for (const Place& c : input.cameras) text += fmt::format("\ncamera ({}, {}, {})", c.x, c.y, c.z);
  const Order right = voxels::classify(input.cameras, input.box);
  return {input.what,
          text + extreme_case_command(input.what),
          {numbers("kind", {double(right.kind)}),
           numbers("away", {double(right.away[0]), double(right.away[1]), double(right.away[2])})}};
}

Case expect_deviation(const ColoursCase& input) {
  std::string text = fmt::format("{} colours", input.colours.size());
  for (std::size_t i = 0; i < std::min<std::size_t>(input.colours.size(), 5); ++i)
    text += fmt::format("\ncolour {}: ({})", i, fmt::join(input.colours[i], ", "));
  const Statistics right = voxels::statistics(input.colours);
  return {input.what,
          text + extreme_case_command(input.what),
          {numbers("mean", {right.mean[0], right.mean[1], right.mean[2]},
                   voxels::mean_bound(input.colours), "levels"),
           numbers("deviation", {right.deviation},
                   voxels::deviation_bound(input.colours, right.deviation), "levels")}};
}

Case expect_verdict(const JudgeCase& input) {
  std::string text = fmt::format("T = {} M + {}", input.threshold.k1, input.threshold.k2);
  for (std::size_t i = 0; i < input.pictures.size(); ++i) {
    text += fmt::format("\npicture {}:", i);
    for (const Pixel& pixel : input.pictures[i])
      text += pixel.is_background ? std::string(" background")
                                  : fmt::format(" ({}){}", fmt::join(pixel.colour, ", "),
                                                pixel.is_hidden ? " hidden" : "");
  }
  return {input.what,
          text + extreme_case_command(input.what),
          {numbers("verdict", {double(voxels::judge(input.pictures, input.threshold))})}};
}

std::vector<double> columns_and_rows(const FootprintCase& input) {
  std::vector<double> all;
  for (const PixelAt& pixel :
       voxels::footprint(input.pixel_from_grid, input.voxel, input.width, input.height)) {
    all.push_back(pixel.column);
    all.push_back(pixel.row);
  }
  return all;
}

Case expect_pixels(const FootprintCase& input) {
  const std::vector<double> all = columns_and_rows(input);
  std::string text = fmt::format("voxel ({}, {}, {}), picture of {} x {}; P", input.voxel.x,
                                 input.voxel.y, input.voxel.z, input.width, input.height);
  for (const auto& row : input.pixel_from_grid) text += fmt::format(" ({})", fmt::join(row, ", "));
  return {
      input.what, text + extreme_case_command(input.what), {matrix("columns and rows", 2, all)}};
}

Case expect_coloured(const SweepCase& input) {
  std::vector<double> places, colours;
  for (const Coloured& voxel : voxels::sweep(input.pictures, input.grid, input.threshold)) {
    for (const int coordinate : {voxel.at.x, voxel.at.y, voxel.at.z}) places.push_back(coordinate);
    colours.insert(colours.end(), voxel.mean.begin(), voxel.mean.end());
  }
  const double bound = (double(input.pictures.size()) + 4) * voxels::kUnit * 255;
  return {
      input.what,
      fmt::format("{} pictures of {} x {}, {} x {} x {} voxels, layers along {}{}, T = {}",
                  input.pictures.size(), input.pictures[0].width, input.pictures[0].height,
                  input.grid.count[0], input.grid.count[1], input.grid.count[2],
                  input.grid.away > 0 ? "" : "-", char('x' + input.grid.axis), input.threshold.k2) +
          extreme_case_command(input.what),
      {matrix("voxels", 3, places), matrix("colours", 3, colours, bound, "levels")}};
}

// ---- generated inputs: what judging the case says, without texts ----

bool right_kind(const OrderCase& input, const Answer& answer) {
  const Order right = voxels::classify(input.cameras, input.box);
  return has_numbers(answer, "kind", {double(right.kind)}) &&
         has_numbers(answer, "away",
                     {double(right.away[0]), double(right.away[1]), double(right.away[2])});
}

bool right_deviation(const ColoursCase& input, const Answer& answer) {
  const Statistics right = voxels::statistics(input.colours);
  return has_numbers(answer, "mean", {right.mean[0], right.mean[1], right.mean[2]},
                     voxels::mean_bound(input.colours)) &&
         has_numbers(answer, "deviation", {right.deviation},
                     voxels::deviation_bound(input.colours, right.deviation));
}

bool right_verdict(const JudgeCase& input, const Answer& answer) {
  return has_numbers(answer, "verdict", {double(voxels::judge(input.pictures, input.threshold))});
}

bool right_pixels(const FootprintCase& input, const Answer& answer) {
  return has_numbers(answer, "columns and rows", columns_and_rows(input));
}

}  // namespace

Lab lab_13() {
  return {
      13,
      "13-voxels",
      "Voxel colouring: order, statistics, verdicts, sweep",
      {{"13.1", "Who comes first", 20},
       {"13.2", "Are these one colour?", 15},
       {"13.3", "The verdict", 25},
       {"13.4", "The pixels of a voxel", 15},
       {"13.5", "Layer after layer", 25}},
      {check("how cameras stand to the box", "13.1", "world", orders, expect_kind),
       generated_check("cameras anywhere", "13.1", "world", generated_orders, expect_kind,
                       right_kind),
       hidden_check("how other cameras stand", "13.1", "world", hidden_orders, expect_kind),
       check("mean and deviation of colours", "13.2", "shading", colours, expect_deviation),
       generated_check("any colours", "13.2", "shading", generated_colours, expect_deviation,
                       right_deviation),
       hidden_check("mean and deviation of other colours", "13.2", "shading", hidden_colours,
                    expect_deviation),
       check("what becomes of a voxel", "13.3", "shading", judged, expect_verdict),
       generated_check("any voxel", "13.3", "shading", generated_judged, expect_verdict,
                       right_verdict),
       hidden_check("what becomes of other voxels", "13.3", "shading", hidden_judged,
                    expect_verdict),
       check("the pixels of a voxel", "13.4", "coverage", footprints, expect_pixels),
       generated_check("the pixels of any voxel", "13.4", "coverage", generated_footprints,
                       expect_pixels, right_pixels),
       hidden_check("the pixels of other voxels", "13.4", "coverage", hidden_footprints,
                    expect_pixels),
       check("voxels are coloured layer after layer", "13.5", "depth", sweeps, expect_coloured),
       generated_check("any grid and pictures", "13.5", "depth", generated_sweeps, expect_coloured),
       hidden_check("other voxels are coloured", "13.5", "depth", hidden_sweeps, expect_coloured)}};
}

}  // namespace glassbox::labs
