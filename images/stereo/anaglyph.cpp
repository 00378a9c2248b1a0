#include <glassbox/images/stereo/anaglyph.h>

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include <glassbox/images/out_of_memory.h>

namespace glassbox {
namespace {

constexpr NamedChoice<Glasses> kGlasses[] = {
    {Glasses::kRedCyan, "red-cyan",
     "the left lens is red, the right one lets green and blue through"},
    {Glasses::kGreenMagenta, "green-magenta",
     "the left lens is green, the right one lets red and blue through"},
    {Glasses::kAmberBlue, "amber-blue",
     "the left lens lets red and green through, the right one is blue"},
};

constexpr NamedChoice<AnaglyphMethod> kMethods[] = {
    {AnaglyphMethod::kMask, "mask",
     "each channel comes from the eye whose lens lets it through; keeps all colours"},
    {AnaglyphMethod::kTrue, "true", "each eye's luma in one channel; dark, without colours"},
    {AnaglyphMethod::kGrey, "grey", "each eye's luma in all its channels; no colours, no rivalry"},
    {AnaglyphMethod::kHalf, "half", "luma for the eye with one channel, colours for the other eye"},
    {AnaglyphMethod::kOptimised, "optimised",
     "red is mixed from green and blue; almost no rivalry, but no reds; only for red-cyan"},
    {AnaglyphMethod::kDubois, "dubois",
     "the closest colours by least squares, for LCD screens (Dubois 2009)"},
    {AnaglyphMethod::kDubois2001, "dubois2001",
     "the closest colours by least squares, for CRT screens (Dubois 2001); only for red-cyan"},
};

using Row = std::array<float, 6>;

constexpr Row kNothing{};
constexpr Row kLeftLuma{kLuma[0], kLuma[1], kLuma[2], 0, 0, 0};
constexpr Row kRightLuma{0, 0, 0, kLuma[0], kLuma[1], kLuma[2]};

// Dubois, "A projection method to generate anaglyph stereo images", ICASSP 2001; as in three.js,
// examples/jsm/effects/AnaglyphEffect.js (issue 21135), and in FFmpeg, libavfilter/vf_stereo3d.c
// (in units of 2^-16). A widely copied shader has -0.400822 in the second row by mistake.
constexpr AnaglyphMatrix kDuboisCrt{{{
    {0.456100f, 0.500484f, 0.176381f, -0.0434706f, -0.0879388f, -0.00155529f},
    {-0.0400822f, -0.0378246f, -0.0157589f, 0.378476f, 0.73364f, -0.0184503f},
    {-0.0152161f, -0.0205971f, -0.00546856f, -0.0721527f, -0.112961f, 1.2264f},
}}};

// Dubois, "Conversion of a stereo pair to anaglyph with the least-squares projection method", 2009;
// as in Dolphin, Data/Sys/Shaders/Anaglyph/dubois*.glsl, and in Camera3D, AnaglyphConstants.java.
// Where public copies differ, the value is used with which the rows sum to 1: for green-magenta
// Dolphin has +0.065 instead of -0.065 (FFmpeg agrees with Camera3D), for amber-blue FFmpeg has
// 65535 / 65536 instead of 1.062.
constexpr AnaglyphMatrix kDuboisRedCyan{{{
    {0.437f, 0.449f, 0.164f, -0.011f, -0.032f, -0.007f},
    {-0.062f, -0.062f, -0.024f, 0.377f, 0.761f, 0.009f},
    {-0.048f, -0.050f, -0.017f, -0.026f, -0.093f, 1.234f},
}}};
constexpr AnaglyphMatrix kDuboisGreenMagenta{{{
    {-0.062f, -0.158f, -0.039f, 0.529f, 0.705f, 0.024f},
    {0.284f, 0.668f, 0.143f, -0.016f, -0.015f, -0.065f},
    {-0.015f, -0.027f, 0.021f, 0.009f, 0.075f, 0.937f},
}}};
constexpr AnaglyphMatrix kDuboisAmberBlue{{{
    {1.062f, -0.205f, 0.299f, -0.016f, -0.123f, -0.017f},
    {-0.026f, 0.908f, 0.068f, 0.006f, 0.062f, -0.017f},
    {-0.038f, -0.173f, 0.022f, 0.094f, 0.185f, 0.911f},
}}};

const AnaglyphMatrix& dubois(Glasses glasses) {
  switch (glasses) {
    case Glasses::kGreenMagenta:
      return kDuboisGreenMagenta;
    case Glasses::kAmberBlue:
      return kDuboisAmberBlue;
    case Glasses::kRedCyan:
      break;
  }
  return kDuboisRedCyan;
}

std::array<bool, 3> as_array(const EyeChannels& eye) {
  return {eye.r, eye.g, eye.b};
}

int channel_count(const EyeChannels& eye) {
  return int(eye.r) + int(eye.g) + int(eye.b);
}

// The channel that the method kTrue leaves black. In the spectrum the channels are red, green,
// blue. The eye with two channels leaves out the one that is next to the other eye's channel; for
// green-magenta both are next to green, and blue is left out.
constexpr std::size_t unused_channel(Glasses glasses) {
  return glasses == Glasses::kGreenMagenta ? 2 : 1;
}

// The matrix of a method that depends only on which channel belongs to which eye.
AnaglyphMatrix by_channel(AnaglyphMethod method, Glasses glasses) {
  const EyeMasks masks = eye_masks(glasses);
  AnaglyphMatrix matrix;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const bool is_left = as_array(masks.left)[channel];
    const bool is_alone = channel_count(is_left ? masks.left : masks.right) == 1;
    Row& row = matrix.at[channel];
    if (method == AnaglyphMethod::kTrue && channel == unused_channel(glasses)) {
      row = kNothing;
    } else if (method == AnaglyphMethod::kMask || (method == AnaglyphMethod::kHalf && !is_alone)) {
      row[is_left ? channel : channel + 3] = 1;
    } else {
      row = is_left ? kLeftLuma : kRightLuma;
    }
  }
  return matrix;
}

Result<AnaglyphMatrix> only_red_cyan(AnaglyphMethod method, Glasses glasses,
                                     const AnaglyphMatrix& matrix) {
  if (glasses == Glasses::kRedCyan) return matrix;
  return fail("anaglyph",
              fmt::format("{} has a matrix only for red-cyan glasses, not for {}", name_of(method),
                          name_of(glasses)),
              "choose dubois, which has a matrix for each kind of glasses");
}

Image<Rgba8> mask_channels(const Image<Rgba8>& left, const Image<Rgba8>& right, Glasses glasses) {
  const EyeChannels from_left = eye_masks(glasses).left;
  Image<Rgba8> shown = right;
  for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
    const Rgba8& l = left.pixels[i];
    Rgba8& pixel = shown.pixels[i];
    if (from_left.r) pixel.r = l.r;
    if (from_left.g) pixel.g = l.g;
    if (from_left.b) pixel.b = l.b;
    pixel.a = std::max(pixel.a, l.a);
  }
  return shown;
}

Image<Rgba8> mix(const Image<Rgba8>& left, const Image<Rgba8>& right,
                 const AnaglyphMatrix& matrix) {
  Image<Rgba8> shown(left.width, left.height);
  for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
    const Rgba8& l = left.pixels[i];
    const Rgba8& r = right.pixels[i];
    const auto [red, green, blue] = mix_eyes(matrix, linear_of(l), linear_of(r));
    shown.pixels[i] = {encode_srgb(red), encode_srgb(green), encode_srgb(blue), std::max(l.a, r.a)};
  }
  return shown;
}

}  // namespace

std::span<const NamedChoice<Glasses>> all_glasses() {
  return kGlasses;
}

std::span<const NamedChoice<AnaglyphMethod>> all_anaglyph_methods() {
  return kMethods;
}

std::string_view name_of(Glasses glasses) {
  return kGlasses[std::size_t(glasses)].name;
}

std::string_view name_of(AnaglyphMethod method) {
  return kMethods[std::size_t(method)].name;
}

EyeMasks eye_masks(Glasses glasses) {
  switch (glasses) {
    case Glasses::kGreenMagenta:
      return {{false, true, false}, {true, false, true}};
    case Glasses::kAmberBlue:
      return {{true, true, false}, {false, false, true}};
    case Glasses::kRedCyan:
      break;
  }
  return {{true, false, false}, {false, true, true}};
}

Result<AnaglyphMatrix> anaglyph_matrix(AnaglyphMethod method, Glasses glasses) {
  switch (method) {
    case AnaglyphMethod::kMask:
    case AnaglyphMethod::kTrue:
    case AnaglyphMethod::kGrey:
    case AnaglyphMethod::kHalf:
      break;
    case AnaglyphMethod::kDubois:
      return dubois(glasses);
    case AnaglyphMethod::kDubois2001:
      return only_red_cyan(method, glasses, kDuboisCrt);
    case AnaglyphMethod::kOptimised: {
      AnaglyphMatrix wimmer = by_channel(AnaglyphMethod::kMask, Glasses::kRedCyan);
      wimmer.at[0] = {0, 0.7f, 0.3f, 0, 0, 0};
      return only_red_cyan(method, glasses, wimmer);
    }
  }
  return by_channel(method, glasses);
}

Linear mix_eyes(const AnaglyphMatrix& matrix, const Linear& left, const Linear& right) {
  Linear shown;
  for (std::size_t i = 0; i < 3; ++i) {
    const Row& m = matrix.at[i];
    const float sum = m[0] * left[0] + m[1] * left[1] + m[2] * left[2] + m[3] * right[0] +
                      m[4] * right[1] + m[5] * right[2];
    shown[i] = std::clamp(sum, 0.0f, 1.0f);
  }
  return shown;
}

Result<Image<Rgba8>> make_anaglyph(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                   AnaglyphMethod method, Glasses glasses) {
  const Result<void> same_size = check_eyes("anaglyph", left, right);
  if (!same_size) return tl::unexpected(same_size.error());
  const Result<AnaglyphMatrix> matrix = anaglyph_matrix(method, glasses);
  if (!matrix) return tl::unexpected(matrix.error());
  return unless_out_of_memory([&]() -> Result<Image<Rgba8>> {
    if (method == AnaglyphMethod::kMask) return mask_channels(left, right, glasses);
    return mix(left, right, *matrix);
  });
}

}  // namespace glassbox
