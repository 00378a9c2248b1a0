// Calls your functions with the samples of two eyes.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_12 {
namespace {

using glassbox::labs::append_matrix;
using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

double number_of(const Rgba8& c) {
  return 65536.0 * c.r + 256.0 * c.g + c.b;
}
Rgba8 colour(RecordReader& in) {
  const auto rgb = std::uint32_t(in.number());
  return {std::uint8_t(rgb >> 16), std::uint8_t(rgb >> 8), std::uint8_t(rgb), 255};
}

// Input: width, height, epsilon, then samples: x, y, depth, colour (65536 red + 256 green + blue).
// Output: the offsets, then depth and colour of each sample.
void packed(RecordReader& in, Numbers& out) {
  const int width = in.integer(), height = in.integer();
  const double epsilon = in.number();
  std::vector<Sample> samples;
  while (in.more()) {
    const int x = in.integer(), y = in.integer();
    const float depth = in.real();
    samples.push_back({x, y, depth, colour(in)});
  }
  const Layers layers = pack(width, height, samples, epsilon);
  out.insert(out.end(), layers.first.begin(), layers.first.end());
  for (std::size_t i = 0; i < layers.depth.size() && i < layers.colour.size(); ++i) {
    out.push_back(double(layers.depth[i]));
    out.push_back(number_of(layers.colour[i]));
  }
}

// Input: the matrices from the world to the first picture and to the second one. Output: the matrix
// from the first picture to the second.
void matrix(RecordReader& in, Numbers& out) {
  const auto first = in.matrix<Transform<Screen, World>>();
  append_matrix(out, warp_matrix(first, in.matrix<Transform<Screen, World>>()));
}

// Input: the matrix, y, then for each pixel the number of its depths, and the depths. Output: x w,
// y w, z w, w of each sample.
void row(RecordReader& in, Numbers& out) {
  const auto warp = in.matrix<Transform<Screen, Screen>>();
  const int y = in.integer();
  std::vector<std::vector<float>> depths;
  while (in.more()) {
    depths.emplace_back();
    for (int i = in.integer(); i > 0; --i) depths.back().push_back(in.real());
  }
  for (const Warped& at : warp_row(warp, y, depths))
    out.insert(out.end(), {double(at.x), double(at.y), double(at.z), double(at.w)});
}

// Input: the ratio F2/F1 of the focal lengths, then w of samples that face both eyes. Output: for
// each sample the side of its square, then 1 if it is cut or 0 if not.
void size(RecordReader& in, Numbers& out) {
  const double focal_ratio = in.number();
  while (in.more()) {
    const Splat splat = splat_size(focal_ratio, in.number(), 1, 1);
    out.push_back(splat.side);
    out.push_back(splat.is_cut ? 1 : 0);
  }
}

// Input: the epipole's coordinate multiplied by w, w, the number of columns. Output: the columns in
// the order in which they are visited.
void order(RecordReader& in, Numbers& out) {
  const double epipole = in.number(), w = in.number();
  const std::vector<int> visited = visiting_order(epipole, w, in.integer());
  out.insert(out.end(), visited.begin(), visited.end());
}

// Input: width, height, background, then samples in their order: x w, y w, z w, w, side, colour.
// Output: the picture row by row, where the last sample of a pixel stays.
void picture(RecordReader& in, Numbers& out) {
  Canvas canvas;
  canvas.width = in.integer();
  canvas.height = in.integer();
  canvas.background = colour(in);
  canvas.hiding = Hiding::kLast;
  while (in.more()) {
    Placed sample;
    sample.at.x = in.real();
    sample.at.y = in.real();
    sample.at.z = in.real();
    sample.at.w = in.real();
    sample.side = in.number();
    sample.colour = colour(in);
    canvas.samples.push_back(sample);
  }
  for (const Rgba8& pixel : draw(canvas).pixels) out.push_back(number_of(pixel));
}

}  // namespace
}  // namespace lab_12

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  using namespace lab_12;
  return {{"pack", packed}, {"matrix", matrix}, {"row", row},
          {"size", size},   {"order", order},   {"draw", picture}};
}
