#include <glassbox/compare/pixels/explanation.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include <glassbox/base/counted.h>
#include <glassbox/compare/pixels/alpha.h>
#include <glassbox/images/srgb.h>

namespace glassbox {
namespace {

// A hypothesis says: "Channel c of the test's pixel (x, y) fits channel source[c] of the
// reference's pixel (x_sign x + x_offset, y_sign y + y_offset)."
template <class Sample>
struct Hypothesis {
  std::string words;
  int x_sign = 1, x_offset = 0;
  int y_sign = 1, y_offset = 0;
  std::array<int, 4> source = {0, 1, 2, 3};
  // absent: a sample fits if it is the same
  std::function<bool(int channel, Sample from, Sample to)> fits = {};

  // The pixel of the reference from which pixel (x, y) of the test is made; it may lie outside.
  PixelPosition source_of(int x, int y) const {
    return {x_sign * x + x_offset, y_sign * y + y_offset};
  }
};

template <class Sample>
using Hypotheses = std::vector<Hypothesis<Sample>>;

bool has_colour(const StoredImage& image) {
  return image.channels >= 3;
}
bool is_alpha(int channel, int channels) {
  return has_alpha(channels) && channel == channels - 1;
}

// The samples of row y; pixel x starts at channels * x.
template <class Sample>
const Sample* row_of(const StoredImage& image, int y) {
  const auto& samples = std::get<std::vector<Sample>>(image.samples);
  return samples.data() + std::size_t(y) * std::size_t(image.width) * std::size_t(image.channels);
}

template <class Sample>
const Sample* pixel_at(const StoredImage& image, PixelPosition at) {
  return row_of<Sample>(image, at.y) + std::ptrdiff_t(at.x) * image.channels;
}

// Compares samples in the same way as find_differences.
template <class Sample>
bool same_sample(const PicturePair& pair, Sample a, Sample b) {
  if constexpr (std::is_integral_v<Sample>) {
    return a == b;
  } else {
    return ulp_distance(a, b, pair.nan_equals_nan) == 0;
  }
}

template <class Sample>
bool same_pixel(const PicturePair& pair, const Sample* from, const Sample* to) {
  for (int channel = 0; channel < pair.reference.channels; ++channel) {
    if (!same_sample(pair, from[channel], to[channel])) return false;
  }
  return true;
}

template <class Sample>
bool predicts(const PicturePair& pair, const Hypothesis<Sample>& hypothesis, const Sample* from,
              const Sample* to) {
  for (int channel = 0; channel < pair.reference.channels; ++channel) {
    const Sample sample = from[hypothesis.source[std::size_t(channel)]];
    const bool fits = hypothesis.fits ? hypothesis.fits(channel, sample, to[channel])
                                      : same_sample(pair, sample, to[channel]);
    if (!fits) return false;
  }
  return true;
}

// Counts of compared pixels of the test.
struct Score {
  std::uint64_t misses = 0;  // pixels that the hypothesis predicts wrongly
  // differing pixels that the hypothesis moves from or to a place outside the picture, so that they
  // neither confirm nor contradict it
  std::uint64_t open = 0;
};

bool is_within(int place, int size) {
  return place >= 0 && place < size;
}

template <class Sample>
void score_row(const PicturePair& pair, const Hypothesis<Sample>& hypothesis, int y, Score& score) {
  const int x_sign = hypothesis.x_sign, x_offset = hypothesis.x_offset;
  const int y_sign = hypothesis.y_sign, y_offset = hypothesis.y_offset;
  const int width = pair.reference.width, height = pair.reference.height;
  const int channels = pair.reference.channels;
  const int from_y = y_sign * y + y_offset, to_y = y_sign * (y - y_offset);
  const Sample* reference = row_of<Sample>(pair.reference, y);
  const Sample* test = row_of<Sample>(pair.test, y);
  const Sample* from_row =
      is_within(from_y, height) ? row_of<Sample>(pair.reference, from_y) : nullptr;
  for (int x = 0; x < width; ++x, reference += channels, test += channels) {
    if (!pair.selection.compares(x, y)) continue;
    const int from_x = x_sign * x + x_offset, to_x = x_sign * (x - x_offset);
    const Sample* from = from_row && is_within(from_x, width)
                             ? from_row + std::ptrdiff_t(from_x) * channels
                             : nullptr;
    if (from) score.misses += predicts(pair, hypothesis, from, test) ? 0u : 1u;
    if (!from || !is_within(to_x, width) || !is_within(to_y, height)) {
      score.open += same_pixel(pair, reference, test) ? 0u : 1u;
    }
  }
}

// Adds up the score over all rows, beginning with the first row that differs, where a wrong
// hypothesis soon fails. Stops when there are more than `limit` misses.
template <class Sample>
Score score_of(const PicturePair& pair, const Hypothesis<Sample>& hypothesis, int first_row,
               std::uint64_t limit) {
  const int height = pair.reference.height;
  Score score;
  for (int i = 0; i < height && score.misses <= limit; ++i) {
    score_row(pair, hypothesis, (first_row + i) % height, score);
  }
  return score;
}

// The first differing pixels in row order, `count` at most.
template <class Sample>
std::vector<PixelPosition> first_differing(const PicturePair& pair, int first_row,
                                           std::uint64_t count) {
  const int channels = pair.reference.channels;
  std::vector<PixelPosition> pixels;
  for (int y = first_row; y < pair.reference.height; ++y) {
    const Sample* reference = row_of<Sample>(pair.reference, y);
    const Sample* test = row_of<Sample>(pair.test, y);
    for (int x = 0; x < pair.reference.width; ++x, reference += channels, test += channels) {
      if (same_pixel(pair, reference, test) || !pair.selection.compares(x, y)) continue;
      if (pixels.size() == count) return pixels;
      pixels.push_back({x, y});
    }
  }
  return pixels;
}

// Whether the hypothesis predicts more than `limit` of these pixels wrongly.
template <class Sample>
bool is_refuted_by(const std::vector<PixelPosition>& pixels, const PicturePair& pair,
                   const Hypothesis<Sample>& hypothesis, std::uint64_t limit) {
  std::uint64_t misses = 0;
  for (const PixelPosition& pixel : pixels) {
    const PixelPosition from = hypothesis.source_of(pixel.x, pixel.y);
    if (!is_within(from.x, pair.reference.width) || !is_within(from.y, pair.reference.height)) {
      continue;
    }
    const bool right = predicts(pair, hypothesis, pixel_at<Sample>(pair.reference, from),
                                pixel_at<Sample>(pair.test, pixel));
    misses += right ? 0u : 1u;
    if (misses > limit) return true;
  }
  return false;
}

// Whether the pixel has changed as the hypothesis says, to a value that is not an end of the range:
// at the ends, clamping makes any large constant fit.
template <class Sample>
bool is_evidence(const PicturePair& pair, const Hypothesis<Sample>& hypothesis, const Sample* from,
                 const Sample* to) {
  for (int channel = 0; channel < pair.reference.channels; ++channel) {
    const Sample sample = to[channel];
    if (sample == from[channel]) continue;
    if (sample == 0 || sample == std::numeric_limits<Sample>::max()) return false;
  }
  return !same_pixel(pair, from, to) && predicts(pair, hypothesis, from, to);
}

// Whether the hypothesis is confirmed by pixels of two colours. If only one colour has changed, an
// object may just have another colour, or have disappeared from a black background.
template <class Sample>
bool is_seen_in_two_colours(const PicturePair& pair, const Hypothesis<Sample>& hypothesis,
                            const Differences& differences) {
  if (differences.differing == differences.compared) return true;
  const int channels = pair.reference.channels;
  const Sample* seen = nullptr;
  for (int y = differences.first.y; y < pair.reference.height; ++y) {
    const Sample* from = row_of<Sample>(pair.reference, y);
    const Sample* to = row_of<Sample>(pair.test, y);
    for (int x = 0; x < pair.reference.width; ++x, from += channels, to += channels) {
      if (!pair.selection.compares(x, y) || !is_evidence(pair, hypothesis, from, to)) continue;
      if (seen && !std::equal(from, from + channels, seen)) return true;
      seen = from;
    }
  }
  return false;
}

constexpr int kFarthestMove = 2;  // px

template <class Sample>
void add_moves(Hypotheses<Sample>& all) {
  for (int dy = -kFarthestMove; dy <= kFarthestMove; ++dy) {
    for (int dx = -kFarthestMove; dx <= kFarthestMove; ++dx) {
      if (dx == 0 && dy == 0) continue;
      all.push_back({fmt::format("the test is the reference moved by ({:+}, {:+}) pixels", dx, dy),
                     1, -dx, 1, -dy});
    }
  }
}

template <class Sample>
void add_mirrorings(Hypotheses<Sample>& all, int width, int height) {
  all.push_back({"the test is the reference upside down", 1, 0, -1, height - 1});
  all.push_back({"the test is the reference mirrored left to right", -1, width - 1, 1, 0});
  all.push_back({"the test is the reference turned by 180 degrees", -1, width - 1, -1, height - 1});
}

template <class Sample>
void add_swapped_channels(Hypotheses<Sample>& all) {
  Hypothesis<Sample> swapped{"red and blue are swapped"};
  swapped.source = {2, 1, 0, 3};
  all.push_back(swapped);
}

template <class Sample>
Sample clamped_sum(Sample sample, int offset) {
  return Sample(std::clamp(int(sample) + offset, 0, int(std::numeric_limits<Sample>::max())));
}

// Adds the hypothesis that a constant was added to every sample. The constant is taken from the
// first pixel that differs.
template <class Sample>
void add_constant(Hypotheses<Sample>& all, const PicturePair& pair, PixelPosition first) {
  const int channels = pair.reference.channels;
  const Sample* from = pixel_at<Sample>(pair.reference, first);
  const Sample* to = pixel_at<Sample>(pair.test, first);
  std::array<int, 4> offset{};
  std::string words;
  for (int channel = 0; channel < channels; ++channel) {
    offset[std::size_t(channel)] = int(to[channel]) - int(from[channel]);
    words += fmt::format("{}{:+}", channel == 0 ? "" : ", ", offset[std::size_t(channel)]);
  }
  Hypothesis<Sample> constant{fmt::format("({}) was added to every pixel of the reference", words)};
  constant.fits = [offset](int channel, Sample from, Sample to) {
    return to == clamped_sum(from, offset[std::size_t(channel)]);
  };
  all.push_back(constant);
}

// Returns the hypothesis that `fits` holds for the colours and that alpha is unchanged.
template <class Sample, class Fits>
Hypothesis<Sample> colour_hypothesis(std::string words, int channels, Fits fits) {
  Hypothesis<Sample> hypothesis{std::move(words)};
  hypothesis.fits = [channels, fits](int channel, Sample from, Sample to) {
    return is_alpha(channel, channels) ? from == to : fits(from, to);
  };
  return hypothesis;
}

// The sRGB encodings that numbers may have which are stored as `linear` without it: each byte
// represents all numbers that are rounded to it.
struct Encodings {
  std::uint8_t first = 0, last = 0;
};

std::array<Encodings, 256> encodings_of_bytes() {
  std::array<Encodings, 256> encodings;
  for (std::size_t linear = 0; linear < encodings.size(); ++linear) {
    encodings[linear] = {encode_srgb((float(linear) - 0.5f) / 255),
                         encode_srgb((float(linear) + 0.5f) / 255)};
  }
  return encodings;
}

bool is_encoding(std::uint8_t linear, std::uint8_t encoded) {
  static const std::array<Encodings, 256> encodings = encodings_of_bytes();
  return encodings[linear].first <= encoded && encoded <= encodings[linear].last;
}

void add_encodings(Hypotheses<std::uint8_t>& all, int channels) {
  all.push_back(colour_hypothesis<std::uint8_t>(
      "the test's colours are sRGB-encoded once more than the reference's", channels,
      [](std::uint8_t from, std::uint8_t to) { return is_encoding(from, to); }));
  all.push_back(colour_hypothesis<std::uint8_t>(
      "the test's colours are sRGB-encoded once less than the reference's", channels,
      [](std::uint8_t from, std::uint8_t to) { return is_encoding(to, from); }));
}

template <class Sample>
Hypotheses<Sample> hypotheses(const PicturePair& pair, PixelPosition first) {
  Hypotheses<Sample> all;
  const int channels = pair.reference.channels;
  if constexpr (std::is_integral_v<Sample>) {
    add_constant(all, pair, first);
    all.push_back(colour_hypothesis<Sample>(
        "the test's colours are the reference's colours, inverted", channels,
        [](Sample from, Sample to) { return to == std::numeric_limits<Sample>::max() - from; }));
  }
  if constexpr (std::is_same_v<Sample, std::uint8_t>) add_encodings(all, channels);
  if (has_colour(pair.reference)) add_swapped_channels(all);
  add_mirrorings(all, pair.reference.width, pair.reference.height);
  add_moves(all);
  return all;
}

std::string exceptions_text(std::uint64_t misses) {
  if (misses == 0) return {};
  return " (except for " + counted(misses, "pixel") + ")";
}

// The hypothesis with the fewest misses, among those that explain nine of ten differing pixels and
// leave at most half of the differing pixels undecided (`open`).
template <class Sample>
std::optional<std::string> best_explanation(const PicturePair& pair,
                                            const Differences& differences) {
  constexpr std::uint64_t kOneIn = 10;
  // Twice as many pixels as refute a hypothesis; the number bounds the memory (to 8 MiB).
  constexpr std::uint64_t kMaxTried = std::uint64_t(1) << 20;
  std::uint64_t limit = differences.differing / kOneIn;
  const auto tried =
      first_differing<Sample>(pair, differences.first.y, std::min(2 * limit + kOneIn, kMaxTried));
  std::optional<std::string> best;
  for (const auto& hypothesis : hypotheses<Sample>(pair, differences.first)) {
    // Most hypotheses fail here, without a look at the pixels that are the same.
    if (is_refuted_by(tried, pair, hypothesis, limit)) continue;
    const auto [misses, open] = score_of(pair, hypothesis, differences.first.y, limit);
    if (misses > limit || (best && misses == limit) || open > differences.differing / 2) continue;
    if (hypothesis.fits && !is_seen_in_two_colours(pair, hypothesis, differences)) continue;
    best = hypothesis.words + exceptions_text(misses);
    limit = misses;
  }
  return best;
}

// Returns a sentence such as "only alpha differs" or "only green differs".
template <class Sample>
std::optional<std::string> only_channel(const PicturePair& pair, int first_row) {
  constexpr std::array kNames{"red", "green", "blue", "alpha"};
  const int channels = pair.reference.channels;
  if (channels == 1) return {};
  int channel = -1;  // that differs
  for (int y = first_row; y < pair.reference.height; ++y) {
    const Sample* from = row_of<Sample>(pair.reference, y);
    const Sample* to = row_of<Sample>(pair.test, y);
    for (int x = 0; x < pair.reference.width; ++x, from += channels, to += channels) {
      if (!pair.selection.compares(x, y)) continue;
      for (int c = 0; c < channels; ++c) {
        if (same_sample(pair, from[c], to[c])) continue;
        if (channel >= 0 && channel != c) return {};
        channel = c;
      }
    }
  }
  if (is_alpha(channel, channels)) return "only alpha differs";
  return channels == 2 ? "only grey differs"
                       : fmt::format("only {} differs", kNames[std::size_t(channel)]);
}

// The pixels that are compared, without those whose differences are set aside.
Selection without_set_aside(const PicturePair& pair) {
  Selection counted = pair.selection;
  if (pair.set_aside.empty()) return counted;
  for (DifferenceRows rows(pair); rows.next();) {
    const auto kinds = rows.kinds();
    for (std::size_t x = 0; x < kinds.size(); ++x) {
      const bool aside =
          kinds[x] == PixelKind::kMovedEdge || kinds[x] == PixelKind::kBelowThreshold;
      if (aside) counted.exclude(int(x), rows.y());
    }
  }
  return counted;
}

std::string size_of(const StoredImage& image) {
  return fmt::format("{} x {}", image.width, image.height);
}

}  // namespace

std::vector<std::string> explain_differences(const PicturePair& pair,
                                             const Differences& differences) {
  if (differences.differing == 0) return {};
  const Selection counted = without_set_aside(pair);
  const PicturePair counting{pair.reference, pair.test, counted, pair.nan_equals_nan};
  return std::visit(
      [&](const auto& samples) {
        using Sample = typename std::decay_t<decltype(samples)>::value_type;
        std::vector<std::string> hints;
        if (auto best = best_explanation<Sample>(counting, differences)) hints.push_back(*best);
        if (auto only = only_channel<Sample>(counting, differences.first.y)) {
          hints.push_back(*only);
        }
        return hints;
      },
      pair.reference.samples);
}

std::vector<std::string> explain_format_mismatch(const StoredImage& reference,
                                                 const StoredImage& test) {
  std::vector<std::string> sentences;
  if (reference.width != test.width || reference.height != test.height) {
    sentences.push_back(
        fmt::format("the reference has {} pixels, the test {}", size_of(reference), size_of(test)));
    if (reference.width == test.height && reference.height == test.width) {
      sentences.push_back("width and height are swapped");
    }
  }
  if (reference.channels != test.channels) {
    sentences.push_back(fmt::format("the reference is {}, the test {}", channel_names(reference),
                                    channel_names(test)));
    const StoredImage& more = reference.channels > test.channels ? reference : test;
    if (std::abs(reference.channels - test.channels) == 1 && is_opaque(more)) {
      sentences.push_back("the alpha channel is opaque everywhere");
    }
  }
  if (reference.samples.index() != test.samples.index()) {
    sentences.push_back(fmt::format("the reference has {} per sample, the test {}",
                                    format_name(reference), format_name(test)));
  }
  return sentences;
}

}  // namespace glassbox
