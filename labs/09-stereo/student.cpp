// Lab 9: your part. student.h says what each function must do, handout.md why.
#include "student.h"

#include <algorithm>
#include <cmath>

namespace lab_09 {

// ---- task 9.1: the projection of one eye ----

Transform<Clip, Eye> eye_projection(const Transform<Clip, Eye>& clip_from_eye, const Pair& pair,
                                    Side side) {
  // BEGIN SOLUTION
  const double s = side == Side::kLeft ? pair.half_separation : -pair.half_separation;
  Transform<Eye, Eye> skew;
  skew.at(0, 2) = s / pair.window;
  skew.at(0, 3) = s;
  return clip_from_eye * skew;
  // STUB: return Transform<Clip, Eye>(glm::dmat4(NAN));  // the skew, then the centre's projection
  // END SOLUTION
}

// ---- task 9.2: the parallax of a distance ----

Parallax parallax_at(const Pair& pair, const Picture& picture, double distance) {
  // BEGIN SOLUTION
  const double f = pair.window, z = distance;
  // Computes 1/f - 1/z from the difference z - f. Near the window, where z is almost f, this
  // difference is exact, and 1/f - 1/z would be the difference of two rounded numbers.
  double closeness = (z - f) / f / z;
  if (std::isinf(z)) {
    closeness = 1 / f;
  } else if (std::isinf(f)) {
    closeness = -1 / z;
  }
  const double half_widths = 2 * pair.half_separation * picture.scale * closeness;
  return {half_widths * picture.width / 2, half_widths * 50};
  // STUB: return {NAN, NAN};  // x in the right picture minus x in the left one
  // END SOLUTION
}

// ---- task 9.3: one verdict for both eyes ----

Verdict cull(const std::array<StereoPoint, 3>& triangle) {
  // BEGIN SOLUTION
  const auto all = [&](auto outside) {
    return std::all_of(triangle.begin(), triangle.end(), outside);
  };
  using P = const StereoPoint&;
  const bool shared = all([](P p) { return p.z < 0; }) || all([](P p) { return p.z > p.w; }) ||
                      all([](P p) { return p.y < -p.w; }) || all([](P p) { return p.y > p.w; });
  const bool left =
      all([](P p) { return p.left_x < -p.w; }) || all([](P p) { return p.left_x > p.w; });
  const bool right =
      all([](P p) { return p.right_x < -p.w; }) || all([](P p) { return p.right_x > p.w; });
  return shared || (left && right) ? Verdict::kCull : Verdict::kDraw;
  // STUB: return Verdict::kUnknown;
  // END SOLUTION
}

// ---- task 9.4: two pictures in one ----

Image<Rgba8> draw_anaglyph(const Anaglyph& anaglyph) {
  // BEGIN SOLUTION
  Image<Rgba8> shown(anaglyph.width, anaglyph.height, anaglyph.background);
  const auto draw = [&](const std::vector<Fragment>& fragments, const Channels& mask) {
    Image<float> depth(anaglyph.width, anaglyph.height, 2);
    for (const Fragment& each : fragments) {
      if (!(each.depth < depth.at(each.x, each.y))) continue;
      depth.at(each.x, each.y) = each.depth;
      Rgba8& pixel = shown.at(each.x, each.y);
      if (mask.r) pixel.r = each.colour.r;
      if (mask.g) pixel.g = each.colour.g;
      if (mask.b) pixel.b = each.colour.b;
    }
  };
  draw(anaglyph.left, anaglyph.left_mask);
  draw(anaglyph.right, anaglyph.right_mask);
  return shown;
  // STUB: return {};  // anaglyph.width x anaglyph.height pixels
  // END SOLUTION
}

// ---- task 9.5: colours for coloured glasses ----

Colour anaglyph_colour(const Matrix& matrix, const Recolour& recolour, const Colour& left,
                       const Colour& right) {
  // BEGIN SOLUTION
  const auto& [k, b] = recolour;
  std::array<double, 6> eyes{};
  for (std::size_t eye = 0; eye < 2; ++eye) {
    const Colour& c = eye == 0 ? left : right;
    const double luma = 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2];
    for (std::size_t i = 0; i < 3; ++i)
      eyes[3 * eye + i] = b + (1 - b) * ((1 - k) * c[i] + k * luma);
  }
  Colour shown{};
  for (std::size_t i = 0; i < 3; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < 6; ++j) sum += matrix[i][j] * eyes[j];
    shown[i] = std::clamp(sum, 0.0, 1.0);
  }
  return shown;
  // STUB: return {NAN, NAN, NAN};  // recolour, multiply by the matrix, clamp
  // END SOLUTION
}

// ---- task 9.6: as much depth as the eyes can bear ----

std::vector<double> comfortable_separations(const Picture& picture, const Budget& budget,
                                            const std::vector<Frame>& frames,
                                            double release_frames) {
  // BEGIN SOLUTION
  std::vector<double> separations;
  for (const Frame& frame : frames) {
    // Parallax is proportional to the separation.
    const Pair unit{1, frame.window};
    const double in_front = -parallax_at(unit, picture, frame.nearest).px;
    const double behind = parallax_at(unit, picture, frame.farthest).px;
    double limit = frame.window / picture.scale;
    if (in_front > 0) limit = std::min(limit, budget.in_front_px / in_front);
    if (behind > 0) limit = std::min(limit, budget.behind_px / behind);
    const double last = separations.empty() ? limit : separations.back();
    separations.push_back(limit <= last ? limit : last + (limit - last) / (1 + release_frames));
  }
  return separations;
  // STUB: return {};  // a separation for each frame
  // END SOLUTION
}

}  // namespace lab_09
