#include <glassbox/images/stereo/cables.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glassbox/base/trig.h>
#include <glassbox/images/out_of_memory.h>
#include <glassbox/images/srgb.h>
#include <glassbox/images/stereo/check_eyes.h>

namespace glassbox {
namespace {

constexpr NamedChoice<Cable> kCables[] = {
    {Cable::kComponent, "component", "luma and chroma are separate, chroma is slightly blurred"},
    {Cable::kSVideo, "s-video", "luma and chroma are separate, chroma is blurred"},
    {Cable::kComposite, "composite", "luma and chroma share one signal and disturb each other"},
};

constexpr double kSampling = 13.5;                // MHz
constexpr double kSubcarrier = 315.0 / 88;        // MHz
constexpr double kComponentChroma = 2.75;         // MHz
constexpr double kBandOfI = 1.3, kBandOfQ = 0.5;  // MHz

using Line = std::vector<double>;

struct LineYiq {
  Line y, i, q;
};

// A low-pass filter that leaves a constant signal unchanged.
class LowPass {
public:
  explicit LowPass(double megahertz) {
    const double cutoff = megahertz / kSampling;  // periods a sample
    const int radius = int(std::lround(2 / cutoff));
    double sum = 0;
    for (int x = 0; x <= radius; ++x) {
      const double window = 0.54 + 0.46 * sin_cos(kPi * x / (radius + 1)).cos;
      const double sinc = x == 0 ? 2 * cutoff : sin_cos(2 * kPi * cutoff * x).sin / (kPi * x);
      weights_.push_back(window * sinc);
      sum += (x == 0 ? 1 : 2) * weights_.back();
    }
    for (double& weight : weights_) weight /= sum;
  }

  int radius() const { return int(weights_.size()) - 1; }  // samples

  // Beyond its ends, a line is continued with the value at that end.
  Line operator()(const Line& in) const {
    const auto last = std::ptrdiff_t(in.size()) - 1;
    Line out(in.size());
    for (std::ptrdiff_t x = 0; x <= last; ++x) {
      double sum = weights_[0] * in[std::size_t(x)];
      for (std::size_t r = 1; r < weights_.size(); ++r) {
        const auto away = std::ptrdiff_t(r);
        sum += weights_[r] * (in[std::size_t(std::max(x - away, std::ptrdiff_t(0)))] +
                              in[std::size_t(std::min(x + away, last))]);
      }
      out[std::size_t(x)] = sum;
    }
    return out;
  }

private:
  // The weights at the distances 0, 1, 2 ... samples, used on both sides.
  std::vector<double> weights_;
};

// From R'G'B' to YIQ by FCC NTSC (1953), to three digits. kRgb is the exact inverse of this matrix,
// not the rounded inverse that is found in books.
constexpr double kYiq[3][3] = {
    {0.299, 0.587, 0.114}, {0.596, -0.274, -0.322}, {0.211, -0.523, 0.312}};

constexpr std::array<std::array<double, 3>, 3> kRgb = [] {
  std::array<std::array<double, 3>, 3> inverse{};
  double determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
      inverse[j][i] = kYiq[a][c] * kYiq[b][d] - kYiq[a][d] * kYiq[b][c];
      if (i == 0) determinant += kYiq[0][j] * inverse[j][0];
    }
  }
  for (auto& row : inverse) {
    for (double& value : row) value /= determinant;
  }
  return inverse;
}();

// Converts a line to YIQ and adds `margin` samples on both sides, with the values of the line's
// ends.
LineYiq encode_line(const Rgba8* pixels, int width, int margin) {
  const auto samples = std::size_t(width + 2 * margin);
  LineYiq line{Line(samples), Line(samples), Line(samples)};
  for (int x = -margin; x < width + margin; ++x) {
    const Rgba8& pixel = pixels[std::clamp(x, 0, width - 1)];
    const double rgb[3] = {pixel.r / 255.0, pixel.g / 255.0, pixel.b / 255.0};
    const auto row = [&](int k) {
      return kYiq[k][0] * rgb[0] + kYiq[k][1] * rgb[1] + kYiq[k][2] * rgb[2];
    };
    const auto at = std::size_t(x + margin);
    line.y[at] = row(0);
    line.i[at] = row(1);
    line.q[at] = row(2);
  }
  return line;
}

void decode_line(const LineYiq& line, Rgba8* pixels, int width, int margin) {
  for (int x = 0; x < width; ++x) {
    const auto at = std::size_t(x + margin);
    const auto channel = [&](std::size_t k) {
      return encode_unorm8(
          float(kRgb[k][0] * line.y[at] + kRgb[k][1] * line.i[at] + kRgb[k][2] * line.q[at]));
    };
    pixels[x] = {channel(0), channel(1), channel(2), pixels[x].a};
  }
}

// Sends luma and chroma in one signal: frequencies around the subcarrier arrive as chroma, other
// frequencies as luma.
LineYiq through_one_wire(const LineYiq& sent, int y, const LowPass& band_i, const LowPass& band_q) {
  const std::size_t width = sent.y.size();
  std::vector<SinCos> carrier(width);
  for (std::size_t x = 0; x < width; ++x) {
    const double periods = kSubcarrier / kSampling * double(x) + 0.5 * (y % 2);
    carrier[x] = sin_cos(2 * kPi * (periods - std::floor(periods)));
  }
  Line signal(width), in_phase(width), in_quadrature(width);
  for (std::size_t x = 0; x < width; ++x) {
    signal[x] = sent.y[x] + sent.i[x] * carrier[x].cos + sent.q[x] * carrier[x].sin;
    in_phase[x] = 2 * signal[x] * carrier[x].cos;
    in_quadrature[x] = 2 * signal[x] * carrier[x].sin;
  }
  LineYiq arrived{signal, band_i(in_phase), band_q(in_quadrature)};
  for (std::size_t x = 0; x < width; ++x) {
    arrived.y[x] -= arrived.i[x] * carrier[x].cos + arrived.q[x] * carrier[x].sin;
  }
  return arrived;
}

Image<Rgba8> through(const Image<Rgba8>& sent, Cable cable) {
  const bool is_component = cable == Cable::kComponent;
  const LowPass band_i(is_component ? kComponentChroma : kBandOfI);
  const LowPass band_q(is_component ? kComponentChroma : kBandOfQ);
  Image<Rgba8> arrived = sent;
  if (sent.pixels.empty()) return arrived;
  const int margin = 2 * band_q.radius();  // the reach of two filters in sequence
  for (int y = 0; y < sent.height; ++y) {
    LineYiq line = encode_line(&sent.at(0, y), sent.width, margin);
    line.i = band_i(line.i);
    line.q = band_q(line.q);
    if (cable == Cable::kComposite) line = through_one_wire(line, y, band_i, band_q);
    decode_line(line, &arrived.at(0, y), sent.width, margin);
  }
  return arrived;
}

// Collects the differences between bytes. Sums of squares of whole numbers are exact.
class Differences {
public:
  void add(bool counts, std::uint8_t a, std::uint8_t b) {
    if (!counts) return;
    const int difference = int(a) - int(b);
    sum_ += std::uint64_t(difference * difference);
    ++count_;
  }
  double rms() const { return count_ > 0 ? std::sqrt(double(sum_) / double(count_)) : 0; }

private:
  std::uint64_t sum_ = 0, count_ = 0;
};

double rms_in(const EyeChannels& eye, const Image<Rgba8>& a, const Image<Rgba8>& b) {
  Differences differences;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    differences.add(eye.r, a.pixels[i].r, b.pixels[i].r);
    differences.add(eye.g, a.pixels[i].g, b.pixels[i].g);
    differences.add(eye.b, a.pixels[i].b, b.pixels[i].b);
  }
  return differences.rms();
}

Image<Rgba8> only(const EyeChannels& eye, const Image<Rgba8>& picture) {
  Image<Rgba8> alone = picture;
  for (Rgba8& pixel : alone.pixels) {
    if (!eye.r) pixel.r = 0;
    if (!eye.g) pixel.g = 0;
    if (!eye.b) pixel.b = 0;
  }
  return alone;
}

}  // namespace

std::span<const NamedChoice<Cable>> all_cables() {
  return kCables;
}

std::string_view name_of(Cable cable) {
  return kCables[std::size_t(cable)].name;
}

Result<Image<Rgba8>> send_through_cable(const Image<Rgba8>& sent, Cable cable) {
  return unless_out_of_memory([&]() -> Result<Image<Rgba8>> { return through(sent, cable); });
}

Result<EyeErrors> channel_errors(const Image<Rgba8>& sent, const Image<Rgba8>& arrived,
                                 Glasses glasses) {
  if (sent.width != arrived.width || sent.height != arrived.height) {
    return fail("cable", "the picture that arrived has another size than the one that was sent",
                "compare with what send_through_cable() returned");
  }
  const EyeMasks masks = eye_masks(glasses);
  return EyeErrors{rms_in(masks.left, sent, arrived), rms_in(masks.right, sent, arrived)};
}

Result<EyeErrors> channel_leaks(const Image<Rgba8>& sent, Cable cable, Glasses glasses) {
  return unless_out_of_memory([&]() -> Result<EyeErrors> {
    const EyeMasks masks = eye_masks(glasses);
    const Image<Rgba8> arrived = through(sent, cable);
    const auto leak = [&](const EyeChannels& eye) {
      return rms_in(eye, arrived, through(only(eye, sent), cable));
    };
    return EyeErrors{leak(masks.left), leak(masks.right)};
  });
}

}  // namespace glassbox
