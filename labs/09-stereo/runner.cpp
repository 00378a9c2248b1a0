// Calls your functions with the cases of lab 9.
#include "labs/framework/runner.h"
#include "generators.h"
#include "student.h"

namespace lab_09 {
namespace {

using glassbox::labs::Answer;
using glassbox::labs::entries;

void projection(const ProjectionCase& input, Answer& answer) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto rows = entries(eye_projection(input.centre, input.pair, side));
    const std::string eye = side == Side::kLeft ? "left eye" : "right eye";
    answer.emit(eye + ", row of x", {rows.begin(), rows.begin() + 4});
    answer.emit(eye + ", rows of y, z, w", {rows.begin() + 4, rows.end()});
  }
}

// Emits the x position, in pixels, at which the picture of each of your eyes shows each point.
void crop(const CropCase& input, Answer& answer) {
  const Transform<Clip, Eye> centre = perspective_matrix(input.scale, 0, -1.25, -1.25);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto m = eye_projection(centre, input.pair, side);
    std::vector<double> columns;
    for (const Point<Eye, double>& point : input.points) {
      const Point<Clip, double> p = m * point;
      columns.push_back((p.x / p.w + 1) * input.width / 2);
    }
    answer.emit(side == Side::kLeft ? "x, left eye" : "x, right eye", columns);
  }
}

void parallax(const ParallaxCase& input, Answer& answer) {
  const Parallax found = parallax_at(input.pair, input.picture, input.distance);
  answer.emit("px", {found.px});
  answer.emit("percent", {found.percent});
}

// Emits 1 for a triangle that is drawn, 2 for one that is culled.
void culled(const CullCase& input, Answer& answer) {
  std::vector<double> verdicts;
  for (const auto& triangle : input.triangles) verdicts.push_back(int(cull(triangle)));
  answer.emit("verdicts", verdicts);
}

void anaglyph(const AnaglyphCase& input, Answer& answer) {
  const Image<Rgba8> shown = draw_anaglyph(input.anaglyph);
  answer.emit("width, height", {double(shown.width), double(shown.height)});
  std::vector<double> red, green, blue;
  for (const Rgba8& pixel : shown.pixels) {
    red.push_back(pixel.r);
    green.push_back(pixel.g);
    blue.push_back(pixel.b);
  }
  answer.emit("red", red);
  answer.emit("green", green);
  answer.emit("blue", blue);
}

void colour(const ColourCase& input, Answer& answer) {
  const Colour c = anaglyph_colour(input.matrix, input.recolour, input.left, input.right);
  answer.emit("red, green, blue", {c[0], c[1], c[2]});
}

void comfort(const ComfortCase& input, Answer& answer) {
  answer.emit("half separations", comfortable_separations(input.picture, input.budget, input.frames,
                                                          input.release_frames));
}

}  // namespace
}  // namespace lab_09

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_09;
  return {
      check("the projections of both eyes", projections(), projection),
      check("align and crop gives the same pictures", crops(), crop),
      check("the parallax of a distance", distances(), parallax),
      check("what neither eye sees is culled", triangles(), culled),
      check("two pictures in one buffer", anaglyphs(), anaglyph),
      check("colours for coloured glasses", colours(), colour),
      check("separations within the budget", sequences(), comfort),
      generated_check("any projection", generated_projections(), projection),
      generated_check("any distance", generated_distances(), parallax),
      generated_check("any triangle", generated_triangles(), culled),
      generated_check("any two pictures", generated_anaglyphs(), anaglyph),
      generated_check("any colours", generated_colours(), colour),
      generated_check("any sequence", generated_sequences(), comfort),
      // BEGIN HIDDEN
      check("other projections", hidden_projections(), projection),
      check("align and crop, other pictures", hidden_crops(), crop),
      check("other distances", hidden_distances(), parallax),
      check("other triangles", hidden_triangles(), culled),
      check("other pictures in one buffer", hidden_anaglyphs(), anaglyph),
      check("other colours", hidden_colours(), colour),
      check("other sequences", hidden_sequences(), comfort),
      // END HIDDEN
  };
}
