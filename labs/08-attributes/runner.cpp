// Calls your functions with the cases of lab 8.
#include "labs/framework/runner.h"
#include "generators.h"
#include "generators_surface.h"
#include "student.h"

namespace lab_08 {
namespace {

using glassbox::labs::Answer;

void put_pixel(const PixelCase& input, Answer& answer) {
  const auto [u, v] = texcoord_at(input.at);
  answer.emit("u", {u});
  answer.emit("v", {v});
}

void put_span(const SpanCase& input, Answer& answer) {
  answer.emit("u at each pixel", span_coordinates(input.line, input.every));
}

void put_choice(const ChoiceCase& input, Answer& answer) {
  const SpanChoice choice = longest_span(input.line, input.tolerance);
  answer.emit("pixels between two divisions", {double(choice.every)});
  answer.emit("error", {choice.error});
}

void put_footprint(const FootprintCase& input, Answer& answer) {
  const Footprint f = footprint_at(input.triangle, input.x, input.y, input.width, input.height);
  answer.emit("du/dx, du/dy", {f.du_dx, f.du_dy});
  answer.emit("dv/dx, dv/dy", {f.dv_dx, f.dv_dy});
  answer.emit("level", {f.level});
}

void add(const Point<Object, double>& p, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), {p.x, p.y, p.z});
}

void put_patch(const PatchCase& input, Answer& answer) {
  const Tessellation t = tessellate(input.patch, input.level);
  std::vector<double> positions, triangles;
  for (const auto& p : t.positions) add(p, positions);
  for (const auto& [a, b, c] : t.triangles)
    triangles.insert(triangles.end(), {double(a), double(b), double(c)});
  answer.emit("positions", positions);
  answer.emit("triangles", triangles);
}

// Emits the positions along the common border of two patches: first as the first patch has them,
// then as the second one has them.
void put_seam(const SeamCase& input, Answer& answer) {
  const int n = input.level;
  const Tessellation a = tessellate(input.a, n), b = tessellate(input.b, n);
  std::vector<double> of_a, of_b;
  for (int t = 0; t <= n; ++t) {
    const int in_a = n * (n + 1) + t, back = n - t;
    const int in_b = input.border == Border::kFirstRow      ? back
                     : input.border == Border::kFirstColumn ? back * (n + 1)
                                                            : back * (n + 1) + n;
    if (a.positions.size() > std::size_t(in_a)) add(a.positions[std::size_t(in_a)], of_a);
    if (b.positions.size() > std::size_t(in_b)) add(b.positions[std::size_t(in_b)], of_b);
  }
  answer.emit("border of the first patch", of_a);
  answer.emit("border of the second patch", of_b);
}

void put_level(const LevelCase& input, Answer& answer) {
  answer.emit("level", {double(patch_level(input.patch, input.px_per_unit, input.tolerance_px))});
}

}  // namespace
}  // namespace lab_08

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_08;
  return {
      check("texture coordinates at a pixel", pixels(), put_pixel),
      check("coordinates along a row by spans", spans(), put_span),
      check("the longest span within a tolerance", choices(), put_choice),
      check("footprint and mip level", footprints(), put_footprint),
      check("a patch in cells", patches(), put_patch), check("patches meet", seams(), put_seam),
      check("the level of a patch", levels(), put_level),
      generated_check("any pixel", generated_pixels(), put_pixel),
      generated_check("any row", generated_rows(), put_span),
      generated_check("any row and tolerance", generated_choices(), put_choice),
      generated_check("any footprint", generated_footprints(), put_footprint),
      generated_check("any patch", generated_patches(), put_patch),
      generated_check("any two patches that meet", generated_seams(), put_seam),
      generated_check("the level of any patch", generated_levels(), put_level),
      // BEGIN HIDDEN
      check("texture coordinates at other pixels", hidden_pixels(), put_pixel),
      check("coordinates along other rows", hidden_spans(), put_span),
      check("the longest span of other rows", hidden_choices(), put_choice),
      check("other footprints", hidden_footprints(), put_footprint),
      check("other patches in cells", hidden_patches(), put_patch),
      check("other patches meet", hidden_seams(), put_seam),
      check("the level of other patches", hidden_levels(), put_level),
      // END HIDDEN
  };
}
