#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/layers.h"
#include "study/naive/layers.h"

namespace glassbox::study {
namespace c85 {

using naive::Packed;
using naive::PixelLists;

constexpr int kWidth = 5, kHeight = 3;

// Lists of samples with count(pixel) samples in each pixel, in packed order.
PixelLists lists(const std::function<int(int pixel)>& count) {
  PixelLists pixels(kWidth * kHeight);
  for (int i = 0; i < kWidth * kHeight; ++i) {
    for (int k = 0; k < count(i); ++k)
      pixels[std::size_t(i)].push_back(float(k + 1) / 1024 + float(i) / 65536);
  }
  return pixels;
}

using Pack = std::function<Packed(const PixelLists&)>;

// Counts the pixels whose packed samples are not their own, or whose offsets are invalid.
Outcome measure_error(const Pack& pack) {
  const std::vector<PixelLists> all{
      lists([](int) { return 0; }),        // no samples at all
      lists([](int i) { return i % 3; }),  // the first pixel is empty, and so is every third one
      lists([](int i) { return i == 14 ? 1 : 0; }),   // only the last pixel has a sample
      lists([](int i) { return i == 7 ? 255 : 1; }),  // as many samples as a byte can count
      lists([](int i) { return i == 7 ? 256 : 1; }),  // one more than a byte can count
      lists([](int i) { return i == 0 ? 1000 : 2; }),
  };
  int wrong = 0;
  for (const PixelLists& pixels : all) {
    const Packed packed = pack(pixels);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const bool has_offsets = packed.first.size() == pixels.size() + 1;
      const std::size_t begin = has_offsets ? packed.first[i] : 1,
                        end = has_offsets ? packed.first[i + 1] : 0;
      const bool is_range = begin <= end && end <= packed.depth.size();
      wrong += !is_range || !std::ranges::equal(packed.depth.begin() + std::ptrdiff_t(begin),
                                                packed.depth.begin() + std::ptrdiff_t(end),
                                                pixels[i].begin(), pixels[i].end());
    }
  }
  return wrong_count_outcome(wrong, int(all.size()) * kWidth * kHeight,
                             "pixels have wrong samples");
}

Packed ours(const PixelLists& pixels) {
  views::LayerBuilder builder(layer_camera_of({.width = kWidth, .height = kHeight}), 0);
  for (int i = 0; i < kWidth * kHeight; ++i) {
    for (const float depth : pixels[std::size_t(i)])
      builder.add(i % kWidth, kHeight - 1 - i / kWidth, depth, {9, 9, 9});
  }
  const views::LayeredImage image = builder.pack();
  // check() must accept the image, because the drawing code relies on this check too.
  return views::check(image, "C-85") ? Packed{image.first, image.depth} : Packed{};
}

}  // namespace c85

ExtremeCase c85_layers_packed() {
  using namespace c85;
  return {
      .id = "C-85",
      .name = "No layers, and more than 255",
      .construction =
          "6 images of 5 x 3 pixels with 0 to 1000 samples each, empty pixels first, last and "
          "everywhere",
      .stage = "layers",
      .right_answer = "each pixel has the samples that it was given, from back to front (S1-06)",
      .unit = "pixels",
      .oracle = Oracle::kProperty,
      .ours = {"one offset for each pixel, and one more at the end",
               [] { return measure_error(ours); }},
      .naive = {"the number of samples of a pixel is stored in a byte",
                [] { return measure_error(naive::packed_by_byte_counts); }},
      .mutants = {{"empty pixels have no offset",
                   [] { return measure_error(naive::packed_without_empty_pixels); }},
                  {"offsets point to the last sample of each pixel",
                   [] { return measure_error(naive::packed_by_last_samples); }}},
      .not_drawn = "views/layers warps the samples; no engine of glassbox render takes part",
  };
}

}  // namespace glassbox::study
