// What analogue cables do to an anaglyph: they carry fine luma, but blur chroma or mix the two, and an anaglyph's eyes
// are told apart by chroma (S0-17).
#pragma once

#include <span>
#include <string_view>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/images/stereo/anaglyph.h>
#include <glassbox/images/stereo/named.h>

namespace glassbox {

// kComponent  luma and chroma apart; chroma up to 2.75 MHz (ITU-R BT.601).
// kSVideo     luma and chroma apart; chroma as I up to 1.3 MHz and Q up to 0.5 MHz (NTSC).
// kComposite  the same chroma on a subcarrier of 3.58 MHz in one signal with luma. The receiver takes what lies around
//             the subcarrier for chroma and the rest for luma: fine luma becomes colour, edges of colour become dots.
enum class Cable { kComponent, kSVideo, kComposite };

std::span<const Named<Cable>> all_cables();
std::string_view name_of(Cable cable);

// The picture as it arrives. Bytes are the gamma-encoded R'G'B' that a video signal carries, one pixel is one sample at
// 13.5 MHz, whatever the width (a line of NTSC has about 640 square pixels), and every line stands for itself. Beyond the
// edges a line goes on as at its edge. Luma is not blurred but where it shares the cable; noise and gain are left out.
// Alpha is kept. The same bytes on every machine.
//
// Filters are sinc functions under a Hamming window, 6 dB down at the frequencies named, 2 samples / frequency to
// either side. On composite, what the receiver takes for chroma is subtracted from its luma, and the subcarrier turns
// by half a period from line to line.
Result<Image<Rgba8>> send(const Image<Rgba8>& sent, Cable cable);

// Root mean squares over the pixels, in bytes (1/255 of full scale).
struct EyeErrors {
  double left = 0, right = 0;
};

// What arrives in each eye's channels against what was sent in them: everything the cable does.
Result<EyeErrors> channel_errors(const Image<Rgba8>& sent, const Image<Rgba8>& arrived,
                                 Glasses glasses);

// What arrives in each eye's channels against what arrives in them when the other eye's channels are black: what leaks
// from one eye into the other, and nothing else. 0 for a cable that keeps channels apart.
Result<EyeErrors> channel_leaks(const Image<Rgba8>& sent, Cable cable, Glasses glasses);

}  // namespace glassbox
