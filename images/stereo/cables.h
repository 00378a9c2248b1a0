// The effect of analogue cables on an anaglyph: they transmit fine luma, but blur chroma or mix it
// with luma, and chroma is what separates the eyes in an anaglyph (S0-17).
#pragma once

#include <span>
#include <string_view>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/images/stereo/anaglyph.h>
#include <glassbox/images/stereo/named_choice.h>

namespace glassbox {

// - kComponent: luma and chroma are separate; chroma up to 2.75 MHz (ITU-R BT.601).
// - kSVideo: luma and chroma are separate; chroma as I up to 1.3 MHz and Q up to 0.5 MHz (NTSC).
// - kComposite: the same chroma on a subcarrier of 3.58 MHz in one signal with luma. The receiver
//   takes the frequencies around the subcarrier for chroma and the rest for luma: fine luma becomes
//   colour, edges of colour become dots.
enum class Cable { kComponent, kSVideo, kComposite };

std::span<const NamedChoice<Cable>> all_cables();
std::string_view name_of(Cable cable);

// The picture as it arrives. Bytes are the gamma-encoded R'G'B' that a video signal carries. One
// pixel is one sample at 13.5 MHz, for any width (a line of NTSC has about 640 square pixels), and
// every line is independent. Beyond its ends a line is continued with its end values. Luma is not
// blurred except where it shares the cable; noise and gain are not simulated. Alpha is kept. The
// result is the same bytes on every machine.
//
// The filters are sinc functions under a Hamming window, 6 dB down at the frequencies given at
// Cable; they reach two periods of this frequency to either side. On composite, the part that the
// receiver takes for chroma is subtracted from its luma, and the phase of the subcarrier changes by
// half a period from line to line.
Result<Image<Rgba8>> send_through_cable(const Image<Rgba8>& sent, Cable cable);

// Root mean squares over the pixels, in bytes (1/255 of full scale).
struct EyeErrors {
  double left = 0, right = 0;
};

// The difference between the sent and the arrived values in each eye's channels: the total effect
// of the cable.
Result<EyeErrors> channel_errors(const Image<Rgba8>& sent, const Image<Rgba8>& arrived,
                                 Glasses glasses);

// The difference between the arrived values in each eye's channels and the values that arrive in
// these channels when the other eye's channels are black: only the leak from one eye into the
// other. It is 0 for a cable that keeps channels separate.
Result<EyeErrors> channel_leaks(const Image<Rgba8>& sent, Cable cable, Glasses glasses);

}  // namespace glassbox
