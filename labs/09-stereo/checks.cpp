// The expected answers of lab 9, from exact numbers and from the pipeline's own functions for
// culling and cropping. pictures.h has those of the anaglyphs.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/stereo/align_and_crop.h>
#include <glassbox/pipeline/stereo/culling.h>

#include "exact/matrix.h"
#include "exact/number.h"
#include "labs/09-stereo/generators.h"
#include "labs/09-stereo/pictures.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

using namespace lab_09;
using exact::Decimal;
using exact::inverse_of;
using exact::Matrix4;
using exact::Rational;

constexpr double u = unit_roundoff<double>;
constexpr lab_09::Side kEyes[] = {lab_09::Side::kLeft, lab_09::Side::kRight};

std::string name_of_eye(lab_09::Side side) {
  return side == lab_09::Side::kLeft ? "left eye" : "right eye";
}

// The camera between the eyes: its projection has picture.scale as entry (0, 0), and its picture is
// picture.width pixels wide.
View centre_view(const Picture& picture) {
  View view;
  view.clip_from_eye = perspective_matrix(picture.scale, 0, -1.25, -1.25);
  view.viewport = {0, 0, float(picture.width), float(picture.width)};
  return view;
}

StereoPair pair_of(const Pair& pair) {
  return {pair.half_separation, pair.window};
}

// ---- projections ----

std::vector<Expected> projection_fields(lab_09::Side side, const Matrix4<Rational>& m,
                                        double bound) {
  std::vector<double> x, others;
  for (std::size_t i = 0; i < 4; ++i) {
    for (const Rational& each : m.at[i]) (i == 0 ? x : others).push_back(double(each));
  }
  return {matrix(name_of_eye(side) + ", row of x", 4, x, bound),
          matrix(name_of_eye(side) + ", rows of y, z, w", 4, others)};
}

// The changed entries are m02 + m00 (s/f) and m03 + m00 s, where m is the centre's projection. A
// quotient, a product and a sum round, so the first has an error of at most 3 u (|m00 s/f| +
// |m02|), where u = 2^-53 is the unit roundoff, and the second one likewise. That is below 8 u
// times the largest of these numbers.
double projection_bound(const ProjectionCase& input) {
  const auto& [what, given, pair] = input;
  const double s = pair.half_separation, scale = std::abs(given.at(0, 0));
  if (s == 0) return 0;
  return 8 * u *
         std::max({scale * s / pair.window, std::abs(given.at(0, 2)), scale * s,
                   std::abs(given.at(0, 3))});
}

bool right_projection(const ProjectionCase& input, const Answer& answer) {
  const auto& [what, given, pair] = input;
  std::vector<Expected> fields;
  for (const lab_09::Side side : kEyes) {
    std::vector<double> x, others;
    for (int j = 0; j < 4; ++j) x.push_back(given.at(0, j));
    for (int i = 1; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) others.push_back(given.at(i, j));
    }
    const double s = side == lab_09::Side::kLeft ? pair.half_separation : -pair.half_separation;
    const Decimal by_shift = Decimal(x[0]) * Decimal(s);
    if (std::isfinite(pair.window)) x[2] = double(Decimal(x[2]) + by_shift / Decimal(pair.window));
    x[3] = double(Decimal(x[3]) + by_shift);
    fields.push_back(matrix(name_of_eye(side) + ", row of x", 4, x, projection_bound(input)));
    fields.push_back(matrix(name_of_eye(side) + ", rows of y, z, w", 4, others));
  }
  return has_fields(answer, fields);
}

Case expect_projection(const ProjectionCase& input) {
  const auto& [what, given, pair] = input;
  const double s = pair.half_separation, scale = std::abs(given.at(0, 0));
  const double bound = projection_bound(input);
  Case c{what,
         fmt::format("s = {}, f = {}; the projection's row of x is ({}, {}, {}, {})", s,
                     pair.window, given.at(0, 0), given.at(0, 1), given.at(0, 2), given.at(0, 3)),
         {}};
  c.slipped = {{"z-sign", {}},
               {"row-column-order", {}},
               {"multiplication-order", {}},
               {"translation-sign", {}}};
  const auto projection = exact::exactly<Rational>(given);
  for (const lab_09::Side side : kEyes) {
    const Rational shift(side == lab_09::Side::kLeft ? s : -s);
    auto skew = Matrix4<Rational>::identity(), turned = skew, transposed = skew;
    skew.at[0][3] = turned.at[0][3] = transposed.at[3][0] = shift;
    skew.at[0][2] = transposed.at[2][0] = shift * inverse_of<Rational>(pair.window);
    turned.at[0][2] = -skew.at[0][2];
    auto backwards = skew;
    backwards.at[0][3] = Rational(0) - shift;
    const auto add = [&](std::vector<Expected>& to, const Matrix4<Rational>& m) {
      for (Expected& each : projection_fields(side, m, bound)) to.push_back(std::move(each));
    };
    add(c.expected, projection * skew);
    add(c.slipped[0].expected, projection * turned);
    add(c.slipped[1].expected, projection * transposed);
    add(c.slipped[2].expected, skew * projection);
    add(c.slipped[3].expected, projection * backwards);
  }
  // If the matrices are multiplied in the wrong order, entries become rounded sums with other rows
  // of the projection, so every entry gets a bound for its own size.
  for (Expected& each : c.slipped[2].expected) {
    for (const double value : each.values)
      each.bound = std::max(each.bound, 8 * u * std::abs(value));
  }
  for (Expected& each : c.slipped[1].expected) {
    if (each.bound == 0 && s != 0) each.bound = 8 * u * std::max(1.0, s) * (1 + scale);
  }
  return c;
}

// The bound for positions in the picture. With skewed eyes (the student's) and with cropping
// (ours), the matrix entries have errors of 3 u. In clip space, x is the sum of a x, a s z/f and a
// s, where a is the scale, s half the separation and f the distance of the window, and it is
// divided by w; `terms` is the sum of their sizes divided by w. A sum and two products make it a
// position in pixels. Altogether that is below 16 u (terms + 1) times the number of columns, for
// each of the two.
Case expect_crop(const CropCase& input) {
  const Picture picture{input.scale, input.width};
  const auto cut = align_and_crop(centre_view(picture), pair_of(input.pair)).value();
  Case c{input.what,
         fmt::format("s = {}, f = {}, scale {}: {} columns are drawn, {} cut",
                     input.pair.half_separation, input.pair.window, input.scale,
                     input.width + cut.shift, cut.shift),
         {}};
  for (const lab_09::Side side : kEyes) {
    const View& view = side == lab_09::Side::kLeft ? cut.left : cut.right;
    const int first = side == lab_09::Side::kLeft ? cut.left_first : cut.right_first;
    std::vector<double> columns;
    double largest = 0;
    for (const auto& point : input.points) {
      const Point<World, double> world{point.x, point.y, point.z};
      const Point<Clip, double> p = view.clip_from_eye * (view.eye_from_world * world);
      columns.push_back((p.x / p.w + 1) * double(view.viewport.width()) / 2 - first);
      const double s = input.pair.half_separation;
      const double terms =
          input.scale * (std::abs(point.x) + s * p.w / input.pair.window + s) / p.w;
      largest = std::max(largest, terms + 1);
    }
    const double bound = 32 * u * largest * (input.width + cut.shift);
    c.expected.push_back(numbers("x, " + name_of_eye(side), columns, bound, "px"));
  }
  return c;
}

// ---- parallax ----

// A difference, two quotients and four products round: 7 u of the parallax, below the allowed 16 u.
// Where both distances are equal, the difference of the two equal numbers is exactly 0.
std::vector<Expected> parallax_fields(const ParallaxCase& input) {
  const auto& [what, pair, picture, z] = input;
  const Decimal half_widths = Decimal(2) * Decimal(pair.half_separation) * Decimal(picture.scale) *
                              (inverse_of<Decimal>(pair.window) - inverse_of<Decimal>(z));
  const double px = double(half_widths * Decimal(picture.width) / Decimal(2));
  const double percent = double(half_widths * Decimal(50));
  return {numbers("px", {px}, 16 * u * std::abs(px), "px"),
          numbers("percent", {percent}, 16 * u * std::abs(percent), "per cent")};
}

Case expect_parallax(const ParallaxCase& input) {
  const auto& [what, pair, picture, z] = input;
  const std::vector<Expected> fields = parallax_fields(input);
  const double px = fields[0].values[0];
  return {what,
          fmt::format("s = {}, f = {}, distance {}, scale {}, {} px wide; straight ahead of the "
                      "centre, the left eye has it at x = {:.9g} px, the right one at {:.9g} px",
                      pair.half_separation, pair.window, z, picture.scale, picture.width,
                      (picture.width - px) / 2, (picture.width + px) / 2),
          fields};
}

bool right_parallax(const ParallaxCase& input, const Answer& answer) {
  return has_fields(answer, parallax_fields(input));
}

// ---- culling ----

// Whether no eye sees the triangle, if the near plane is wrongly taken to be z = -w as in OpenGL.
bool unseen_with_opengl_near(const std::array<StereoPoint, 3>& triangle) {
  const auto all = [&](auto outside) { return std::ranges::all_of(triangle, outside); };
  using P = const StereoPoint&;
  const bool left =
      all([](P p) { return p.left_x < -p.w; }) || all([](P p) { return p.left_x > p.w; });
  const bool right =
      all([](P p) { return p.right_x < -p.w; }) || all([](P p) { return p.right_x > p.w; });
  return all([](P p) { return p.z < -p.w; }) || all([](P p) { return p.z > p.w; }) ||
         all([](P p) { return p.y < -p.w; }) || all([](P p) { return p.y > p.w; }) ||
         (left && right);
}

bool is_culled(const std::array<StereoPoint, 3>& triangle) {
  View centre;
  centre.near = 1;
  centre.far = 65;
  std::array<Outcode, 3> codes{};
  for (std::size_t k = 0; k < 3; ++k) {
    const StereoPoint& p = triangle[k];
    codes[k] = stereo_outcode(StereoClipPoint{p.left_x, p.right_x, p.y, p.z, p.w}, centre);
  }
  return is_outside_both_views(codes);
}

bool right_verdict(const CullCase& input, const Answer& answer) {
  const Verdict right = is_culled(input.triangles[0]) ? Verdict::kCull : Verdict::kDraw;
  return has_numbers(answer, "verdicts", {double(int(right))});
}

Case expect_culled(const CullCase& input) {
  std::vector<double> verdicts, opengl;
  std::string text = "1 is drawn, 2 is culled";
  for (std::size_t i = 0; i < input.triangles.size(); ++i) {
    const auto verdict = [](bool unseen) { return int(unseen ? Verdict::kCull : Verdict::kDraw); };
    verdicts.push_back(verdict(is_culled(input.triangles[i])));
    opengl.push_back(verdict(unseen_with_opengl_near(input.triangles[i])));
    if (input.triangles.size() > 10) continue;
    text += fmt::format("\n{}: {}; left x, right x, y, z, w of its corners", i, input.names[i]);
    for (const StereoPoint& p : input.triangles[i])
      text += fmt::format(" ({:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g})", p.left_x, p.right_x, p.y,
                          p.z, p.w);
  }
  return {.where = input.what,
          .restated = text,
          .expected = {numbers("verdicts", verdicts)},
          .slipped = {{"opengl-depth", {numbers("verdicts", opengl)}}}};
}

// ---- comfort ----

// By decimal numbers: parallax is proportional to the separation.
struct Comfort {
  std::vector<double> limits, separations;  // for each frame
};

Comfort comfort_of(const ComfortCase& input) {
  const Decimal scale(input.picture.scale);
  const Decimal to_px = scale * Decimal(input.picture.width);
  Comfort made;
  Decimal last;
  for (const Frame& frame : input.frames) {
    const Decimal at_window = inverse_of<Decimal>(frame.window);
    const Decimal in_front = to_px * (inverse_of<Decimal>(frame.nearest) - at_window);
    const Decimal behind = to_px * (at_window - inverse_of<Decimal>(frame.farthest));
    bool limited = std::isfinite(frame.window);
    Decimal limit = limited ? Decimal(frame.window) / scale : Decimal(0);
    const auto at_most = [&](double budget, const Decimal& parallax) {
      if (parallax.sign() <= 0) return;
      const Decimal other = Decimal(budget) / parallax;
      if (!limited || other < limit) limit = other;
      limited = true;
    };
    at_most(input.budget.in_front_px, in_front);
    at_most(input.budget.behind_px, behind);
    const bool at_once = made.separations.empty() || !(last < limit);
    last = at_once ? limit : last + (limit - last) / (Decimal(1) + Decimal(input.release_frames));
    made.limits.push_back(double(limit));
    made.separations.push_back(double(last));
  }
  return made;
}

// The bound. A limit is a quotient with a parallax as its divisor, with an error of 10 u. A step of
// the filter rounds three times: at most 4 u. It multiplies earlier errors by frames / (1 +
// frames), so the errors of all steps add up to at most 4 (1 + frames) u. The bound also has room
// for a limit that is made smaller by some u, so that rounding cannot exceed the budget.
Expected separations_of(const ComfortCase& input, const Comfort& right) {
  const double largest = *std::max_element(right.separations.begin(), right.separations.end());
  return numbers("half separations", right.separations,
                 64 * (1 + input.release_frames) * u * largest, "world units");
}

Case expect_comfort(const ComfortCase& input) {
  const Comfort right = comfort_of(input);
  std::string text = fmt::format(
      "scale {}, {} px wide, budget {} px in front and {} px behind, release in {} frames",
      input.picture.scale, input.picture.width, input.budget.in_front_px, input.budget.behind_px,
      input.release_frames);
  for (std::size_t i = 0; i < std::min<std::size_t>(12, input.frames.size()); ++i) {
    const Frame& frame = input.frames[i];
    text += fmt::format("\nframe {}: {} to {}, window {}; the limit is {:.6g}", i, frame.nearest,
                        frame.farthest, frame.window, right.limits[i]);
  }
  return {input.what, text, {separations_of(input, right)}};
}

bool right_comfort(const ComfortCase& input, const Answer& answer) {
  return has_fields(answer, {separations_of(input, comfort_of(input))});
}

}  // namespace

Lab lab_09() {
  return {
      9,
      "09-stereo",
      "Stereo: two eyes, one window, one picture",
      {{"9.1", "The projections of both eyes", 25},
       {"9.2", "The parallax of a distance", 15},
       {"9.3", "Cull what neither eye sees", 20},
       {"9.4", "Two pictures in one colour buffer", 15},
       {"9.5", "Colours for coloured glasses", 10},
       {"9.6", "As much depth as the eyes can bear", 15}},
      {check("the projections of both eyes", "9.1", "clip", projections, expect_projection),
       check("align and crop gives the same pictures", "9.1", "screen", crops, expect_crop),
       generated_check("any projection", "9.1", "clip", generated_projections, expect_projection,
                       right_projection),
       hidden_check("other projections", "9.1", "clip", hidden_projections, expect_projection),
       hidden_check("align and crop, other pictures", "9.1", "screen", hidden_crops, expect_crop),
       check("the parallax of a distance", "9.2", "screen", distances, expect_parallax),
       generated_check("any distance", "9.2", "screen", generated_distances, expect_parallax,
                       right_parallax),
       hidden_check("other distances", "9.2", "screen", hidden_distances, expect_parallax),
       check("what neither eye sees is culled", "9.3", "clip", triangles, expect_culled),
       generated_check("any triangle", "9.3", "clip", generated_triangles, expect_culled,
                       right_verdict),
       hidden_check("other triangles", "9.3", "clip", hidden_triangles, expect_culled),
       check("two pictures in one buffer", "9.4", "anaglyph", anaglyphs, expect_anaglyph),
       generated_check("any two pictures", "9.4", "anaglyph", generated_anaglyphs, expect_anaglyph,
                       right_anaglyph),
       hidden_check("other pictures in one buffer", "9.4", "anaglyph", hidden_anaglyphs,
                    expect_anaglyph),
       check("colours for coloured glasses", "9.5", "anaglyph", colours, expect_colour),
       generated_check("any colours", "9.5", "anaglyph", generated_colours, expect_colour,
                       right_colour),
       hidden_check("other colours", "9.5", "anaglyph", hidden_colours, expect_colour),
       check("separations within the budget", "9.6", "eye", sequences, expect_comfort),
       generated_check("any sequence", "9.6", "eye", generated_sequences, expect_comfort,
                       right_comfort),
       hidden_check("other sequences", "9.6", "eye", hidden_sequences, expect_comfort)}};
}

}  // namespace glassbox::labs
