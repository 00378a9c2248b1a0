// Measures disturbances of an anaglyph: colours that are bright in one eye and dark in the other
// (rivalry), and light that leaks into the wrong eye (ghosts).
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/images/stereo/anaglyph.h>
#include <glassbox/images/stereo/lenses.h>
#include <glassbox/images/stereo/linear.h>

namespace glassbox {

// How well a colour suits the glasses, in [0, 1]: take the largest channel of each eye; the smaller
// of these two divided by the largest channel of all (S0-14). For red-cyan min(R, max(G, B)) /
// max(R, G, B): 1 for white, grey, yellow, magenta and for black, 0 for red, green, blue and cyan.
// `colour` is not negative.
double content_measure(const Linear& colour, Glasses glasses = Glasses::kRedCyan);

// One method of making an anaglyph and the glasses to see it with.
struct AnaglyphViewing {
  AnaglyphMatrix matrix;
  Lenses lenses;
};
Result<AnaglyphViewing> anaglyph_viewing(AnaglyphMethod method,
                                         Glasses glasses = Glasses::kRedCyan);

// The luminance rivalry |Y_L / Y_Lw - Y_R / Y_Rw| of a colour that is the same in both eyes'
// pictures. Y_L and Y_R are its luminances through the left and the right lens, Y_Lw and Y_Rw those
// of white (S0-14, B.6): 0 means equally bright to both eyes, 1 means white to one eye and black to
// the other.
class Rivalry {
public:
  explicit Rivalry(const AnaglyphViewing& viewing);
  double operator()(const Linear& colour) const;

private:
  AnaglyphViewing viewing_;
  double left_white_ = 0, right_white_ = 0;
};

// Rivalry of the colours of one eye's picture, pixel by pixel, in [0, 1]. Parallax has no effect: a
// colour has rivalry because of the glasses, wherever the point is in the other eye's picture.
Image<float> rivalry_map(const Image<Rgba8>& picture, const AnaglyphViewing& viewing);

// How much brighter or darker each lens makes a pixel because of the other eye's picture, relative
// to the white of its own eye alone. This is visible as a ghost of the other picture.
struct Ghosts {
  double left = 0, right = 0;
};

// The largest ghosts: the other eye's picture is white where the own picture is black (B.6).
Ghosts white_leak(const AnaglyphViewing& viewing);

struct GhostMaps {
  Image<float> left, right;
};
// Computes the ghosts of every pixel. Refuses eyes of different sizes.
Result<GhostMaps> ghost_maps(const Image<Rgba8>& left, const Image<Rgba8>& right,
                             const AnaglyphViewing& viewing);

// The mean of a map whose values are in [-1, 1], with an error of 2^-33 at most (fixed_sum.h); 0
// for an empty one.
double mean_of(const Image<float>& map);

}  // namespace glassbox
