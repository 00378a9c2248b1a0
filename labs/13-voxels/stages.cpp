// Calls your functions with the pictures of a ring of cameras.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_13 {
namespace {

using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

Place place(RecordReader& in) {
  const double x = in.number(), y = in.number();
  return {x, y, in.number()};
}

// Input: the low and the high corner of the box, then the positions of the cameras. Output: the
// Kind, then for each axis 1, -1 or 0 as in Order::away.
void order(RecordReader& in, Numbers& out) {
  const Place low = place(in);
  const Box box{low, place(in)};
  std::vector<Place> cameras;
  while (in.more()) cameras.push_back(place(in));
  const Order found = classify(cameras, box);
  out.push_back(double(found.kind));
  for (const int away : found.away) out.push_back(away);
}

// Input: the numbers of voxels along x, y and z, the layers' axis and direction, k1 and k2 of the
// threshold, then pictures: pixel_from_grid row by row, width, height, and pixels (65536 red + 256
// green + blue, or -1 for background). Output: position and mean colour of each coloured voxel.
void coloured(RecordReader& in, Numbers& out) {
  Grid grid;
  for (int& count : grid.count) count = in.integer();
  grid.axis = in.integer();
  grid.away = in.integer();
  const double k1 = in.number();
  const Threshold threshold{k1, in.number()};
  std::vector<Picture> pictures;
  while (in.more()) {
    Picture& picture = pictures.emplace_back();
    for (auto& row : picture.pixel_from_grid)
      for (double& entry : row) entry = in.number();
    picture.width = in.integer();
    picture.height = in.integer();
    for (int i = 0; i < picture.width * picture.height; ++i) {
      const int rgb = in.integer();
      const Colour colour{double(rgb >> 16 & 255), double(rgb >> 8 & 255), double(rgb & 255)};
      picture.pixels.push_back(rgb < 0 ? Pixel{{0, 0, 0}, true, false}
                                       : Pixel{colour, false, false});
    }
  }
  for (const Coloured& voxel : sweep(std::move(pictures), grid, threshold)) {
    for (const int coordinate : {voxel.at.x, voxel.at.y, voxel.at.z}) out.push_back(coordinate);
    out.insert(out.end(), voxel.mean.begin(), voxel.mean.end());
  }
}

}  // namespace
}  // namespace lab_13

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  using namespace lab_13;
  return {{"order", order}, {"sweep", coloured}};
}
