// Anaglyphs: two pictures in one, separated by coloured glasses.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/images/stereo/check_eyes.h>
#include <glassbox/images/stereo/linear.h>
#include <glassbox/images/stereo/named_choice.h>

namespace glassbox {

// The colour of the left lens, then the colour of the right one.
enum class Glasses { kRedCyan, kGreenMagenta, kAmberBlue };

enum class AnaglyphMethod { kMask, kTrue, kGrey, kHalf, kOptimised, kDubois, kDubois2001 };

std::span<const NamedChoice<Glasses>> all_glasses();
std::span<const NamedChoice<AnaglyphMethod>> all_anaglyph_methods();
std::string_view name_of(Glasses glasses);
std::string_view name_of(AnaglyphMethod method);

// The channels that one lens lets through, which are the channels that this eye's picture is
// written to.
struct EyeChannels {
  bool r = false, g = false, b = false;
  friend bool operator==(const EyeChannels&, const EyeChannels&) = default;
};

// Every channel belongs to exactly one eye.
struct EyeMasks {
  EyeChannels left, right;
};
EyeMasks eye_masks(Glasses glasses);

// In linear light. The rows give the red, green and blue that are shown. The columns are the red,
// green and blue of the left eye's picture, then those of the right eye's picture.
struct AnaglyphMatrix {
  std::array<std::array<float, 6>, 3> at{};
};

// - kMask: each channel comes from the eye that it belongs to (S0-02); the literature's "colour
//   anaglyph".
// - kTrue: luma, in one channel of each eye. An eye with two channels uses the channel that is
//   furthest in the spectrum from the other eye's channel. So the two channels are red and blue for
//   red-cyan, green and red for green-magenta, red and blue for amber-blue. The third channel stays
//   black, so white is shown as magenta, yellow or magenta.
// - kGrey: luma in all channels of an eye.
// - kHalf: luma where an eye has one channel, its own colours where it has two.
// - kOptimised: red = 0.7 green + 0.3 blue, the rest as in kMask (Wimmer). Red-cyan only. Wimmer's
//   brightening of red by a gamma of 1.5 is left out: it would give greys a different lightness in
//   each eye.
// - kDubois: least squares in CIE XYZ for the light of LCD screens and for the filters (Dubois
//   2009).
// - kDubois2001: the same for CRT screens (Dubois, ICASSP 2001). Red-cyan only.
//
// Luma has the weights 0.299, 0.587, 0.114 (ITU-R BT.601), applied in linear light here as in the
// methods' sources. Published matrices are used as printed: their rows add up to 1 within 1.5e-3,
// so white keeps byte 255 (which begins at 0.9956 in linear light) and greys change by one byte at
// most. Methods that were published for one pair of glasses are refused for the others.
Result<AnaglyphMatrix> anaglyph_matrix(AnaglyphMethod method, Glasses glasses);

// The red, green and blue that `matrix` makes of two linear colours. Each sum is computed from left
// to right in float and then clamped to [0, 1] (C-77).
Linear mix_eyes(const AnaglyphMatrix& matrix, const Linear& left, const Linear& right);

// kMask copies bytes: for red-cyan (left.r, right.g, right.b), bit for bit. The other methods take
// the bytes as sRGB, mix in linear light and encode by the exact tables: the same bytes on every
// machine. Alpha is the larger of the two, because a pixel that either eye sees is not empty;
// colours are mixed as stored, not weighted by alpha. Refuses eyes of different sizes, and methods
// that have no matrix for the glasses.
Result<Image<Rgba8>> make_anaglyph(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                   AnaglyphMethod method, Glasses glasses = Glasses::kRedCyan);

}  // namespace glassbox
