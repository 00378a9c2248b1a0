// Calls your functions with the cases of lab 12.
#include "labs/framework/runner.h"
#include "generators.h"
#include "student.h"

namespace lab_12 {
namespace {

using glassbox::labs::Answer;
using glassbox::labs::entries;

void packed(const PackCase& input, Answer& answer) {
  const Layers layers = pack(input.width, input.height, input.samples, input.epsilon);
  answer.emit("offsets", {layers.first.begin(), layers.first.end()});
  answer.emit("depths", {layers.depth.begin(), layers.depth.end()});
  std::vector<double> colours;
  for (const Rgba8& colour : layers.colour) colours.push_back(number_of_colour(colour));
  answer.emit("colours", colours);
  answer.emit("width and height", {double(layers.width), double(layers.height)});
}

void matrix(const MatrixCase& input, Answer& answer) {
  const auto all = entries(warp_matrix(input.first, input.second));
  const char* names[] = {"row of x w", "row of y w", "row of z w", "row of w"};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto row = all.begin() + std::ptrdiff_t(4 * i);
    answer.emit(names[i], {row, row + 4});
  }
}

void row(const RowCase& input, Answer& answer) {
  std::vector<double> x, y, z, w;
  for (const Warped& at : warp_row(input.warp, input.y, input.depths)) {
    x.push_back(double(at.x));
    y.push_back(double(at.y));
    z.push_back(double(at.z));
    w.push_back(double(at.w));
  }
  answer.emit("x w", x);
  answer.emit("y w", y);
  answer.emit("z w", z);
  answer.emit("w", w);
}

// Emits 1 for a cut sample, else 0.
void size(const SizeCase& input, Answer& answer) {
  const Splat splat =
      splat_size(input.focal_ratio, input.w, input.cosine_first, input.cosine_second);
  answer.emit("side", {splat.side});
  answer.emit("is cut", {splat.is_cut ? 1.0 : 0.0});
}

void order(const OrderCase& input, Answer& answer) {
  const std::vector<int> visited = visiting_order(input.epipole, input.w, input.count);
  answer.emit("order", {visited.begin(), visited.end()});
}

void picture(const DrawCase& input, Answer& answer) {
  std::vector<double> colours;
  const Image<Rgba8> drawn = draw(input.canvas);
  for (const Rgba8& pixel : drawn.pixels) colours.push_back(number_of_colour(pixel));
  answer.emit("samples shown", colours);
  answer.emit("width and height", {double(drawn.width), double(drawn.height)});
}

}  // namespace
}  // namespace lab_12

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_12;
  return {
      check("samples are packed", packs(), packed),
      check("the matrix from picture to picture", matrices(), matrix),
      check("rows are warped step by step", rows(), row),
      check("how large a sample is", sizes(), size), check("the order of visits", orders(), order),
      check("samples in a picture", pictures(), picture),
      generated_check("any samples are packed", generated_packs(), packed),
      generated_check("the matrix of any two eyes", generated_matrices(), matrix),
      generated_check("any row", generated_rows(), row),
      generated_check("any size", generated_sizes(), size),
      generated_check("any order", generated_orders(), order),
      generated_check("any picture", generated_pictures(), picture),
      // BEGIN HIDDEN
      check("other samples are packed", hidden_packs(), packed),
      check("the matrix of other eyes", hidden_matrices(), matrix),
      check("rows of other samples", hidden_rows(), row),
      check("other sizes", hidden_sizes(), size), check("other orders", hidden_orders(), order),
      check("other pictures", hidden_pictures(), picture),
      // END HIDDEN
  };
}
