#include <array>
#include <cstdlib>

#include <glassbox/images/stereo/anaglyph.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/stereo_scene.h"
#include "study/naive/stereo.h"

namespace glassbox::study {
namespace c77 {

using Bytes = std::array<std::uint8_t, 3>;
using Mixes = Bytes (*)(const AnaglyphMatrix&, const Rgba8& left, const Rgba8& right);

AnaglyphMatrix dubois() {
  return anaglyph_matrix(AnaglyphMethod::kDubois, Glasses::kRedCyan).value();
}

// The right mix of two colours: a sum in double of products of two floats, which are exact. The sum
// is clamped, then encoded as sRGB (IEC 61966-2-1).
Bytes exact_mix(const Rgba8& left, const Rgba8& right) {
  const AnaglyphMatrix matrix = dubois();
  const Linear l = linear_of(left), r = linear_of(right);
  Bytes bytes;
  for (std::size_t row = 0; row < 3; ++row) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum +=
          double(matrix.at[row][k]) * double(l[k]) + double(matrix.at[row][k + 3]) * double(r[k]);
    }
    const double light = std::clamp(sum, 0.0, 1.0);
    const double code =
        light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    bytes[row] = std::uint8_t(std::floor(code * 255 + 0.5));
  }
  return bytes;
}

// Tests all pairs of colours from the corners, edge midpoints and centre of the colour cube.
Outcome measure_error(Mixes mixes, const AnaglyphMatrix& matrix) {
  std::int64_t worst = 0, wrong = 0, mixed = 0;
  std::string where;
  const std::uint8_t levels[] = {0, 128, 255};
  std::vector<Rgba8> colours;
  for (const std::uint8_t r : levels) {
    for (const std::uint8_t g : levels) {
      for (const std::uint8_t b : levels) colours.push_back({r, g, b, 255});
    }
  }
  for (const Rgba8& left : colours) {
    for (const Rgba8& right : colours) {
      const Bytes found = mixes(matrix, left, right), exact = exact_mix(left, right);
      ++mixed;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t off = std::abs(int(found[k]) - int(exact[k]));
        wrong += off > 1;
        if (off <= worst) continue;
        worst = off;
        where = fmt::format("; the worst error is {} in {} of left {},{},{}, right {},{},{}",
                            found[k], exact[k], left.r, left.g, left.b, right.r, right.g, right.b);
      }
    }
  }
  return {
      double(worst),
      1,
      {},
      fmt::format("{} of {} channels are wrong by more than one code{}", wrong, 3 * mixed, where)};
}

Bytes pipeline_mix(const AnaglyphMatrix& matrix, const Rgba8& left, const Rgba8& right) {
  const auto [r, g, b] = mix_eyes(matrix, linear_of(left), linear_of(right));
  return {encode_srgb(r), encode_srgb(g), encode_srgb(b)};
}

template <class Encode>
Bytes mix_in_bytes(const AnaglyphMatrix& matrix, const Rgba8& l, const Rgba8& r, Encode encode) {
  const std::array<double, 6> colours{l.r / 255.0, l.g / 255.0, l.b / 255.0,
                                      r.r / 255.0, r.g / 255.0, r.b / 255.0};
  Bytes bytes;
  for (std::size_t row = 0; row < 3; ++row) {
    double sum = 0;
    for (std::size_t k = 0; k < 6; ++k) sum += double(matrix.at[row][k]) * colours[k];
    bytes[row] = encode(sum);
  }
  return bytes;
}

Bytes wrapping_mix(const AnaglyphMatrix& matrix, const Rgba8& left, const Rgba8& right) {
  return mix_in_bytes(matrix, left, right, naive::wrapped_byte);
}
// Clamps the sums, but computes them with encoded bytes instead of linear light.
Bytes gamma_mix(const AnaglyphMatrix& matrix, const Rgba8& left, const Rgba8& right) {
  return mix_in_bytes(matrix, left, right,
                      [](double sum) { return encode_unorm8(float(std::clamp(sum, 0.0, 1.0))); });
}
// Computes in linear light, but does not clamp values below 0 or above 1 before the sRGB encoding
// (a power): a negative value is replaced by its absolute value.
Bytes unclamped_mix(const AnaglyphMatrix& matrix, const Rgba8& left, const Rgba8& right) {
  const Linear l = linear_of(left), r = linear_of(right);
  Bytes bytes;
  for (std::size_t row = 0; row < 3; ++row) {
    float sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += matrix.at[row][k] * l[k] + matrix.at[row][k + 3] * r[k];
    }
    bytes[row] = encode_srgb(std::abs(sum));
  }
  return bytes;
}

// Reads the numbers row by row, although the file has them column by column (3 x 3 numbers for each
// eye).
AnaglyphMatrix transposed() {
  const AnaglyphMatrix matrix = dubois();
  AnaglyphMatrix turned = matrix;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t k = 0; k < 3; ++k) {
      turned.at[row][k] = matrix.at[k][row];
      turned.at[row][k + 3] = matrix.at[k][row + 3];
    }
  }
  return turned;
}
AnaglyphMatrix with_misprint() {
  AnaglyphMatrix matrix = dubois();
  matrix.at[1][0] *= 10;  // -0.400822 instead of -0.0400822, a typing error in a widespread shader
  return matrix;
}

// A pair of pictures of cards in six strong colours, drawn and mixed in one run: each pixel must be
// within a byte of the mix of the colours that are on each eye's own line of sight.
Outcome measure_drawn_error(const TestedEngine& engine) {
  constexpr StereoPair kPair{0.3, 8};
  static const std::array<Rgba8, 6> colors{Rgba8{255, 0, 0, 255}, {0, 255, 0, 255},
                                           {0, 0, 255, 255},      {0, 255, 255, 255},
                                           {255, 0, 255, 255},    {128, 255, 0, 255}};
  static const RayScene cards = [] {
    std::vector<EyeTriangle> triangles;
    for (int i = 0; i < 6; ++i) {
      const float z = -14 + 1.7f * float(i), x = float(i % 3 - 1) * 1.3f, y = float(i / 3) - 0.7f;
      triangles.push_back({Point<Eye>{x - 2, y - 1.2f, z}, {x + 2, y - 1.2f, z}, {x, y + 2, z}});
    }
    RayScene ray_scene = make_ray_scene(triangles, PerspectiveLens{0.7, 1, 30.0}, 64);
    Mesh& mesh = ray_scene.scene.meshes[0];
    for (std::size_t i = 0; i < colors.size(); ++i) {
      const auto [r, g, b] = linear_of(colors[i]);
      for (std::size_t k = 0; k < 3; ++k) mesh.corners[3 * i + k].color = std::uint32_t(i);
      mesh.colors.push_back({r, g, b, 1});
    }
    ray_scene.settings.transfer = Transfer::kSrgb;
    return ray_scene;
  }();
  static const RayCastReference left(eye_ray_scene(cards, kPair, Side::kLeft)),
      right(eye_ray_scene(cards, kPair, Side::kRight));
  StereoSettings settings;
  settings.render = cards.settings;
  settings.render.want_id = false;
  const StereoRendering drawn =
      engine.renderer(cards.scene, Transfer::kSrgb).render_pair(cards.view, kPair, settings);
  const auto shown =
      make_anaglyph(drawn.left.color, drawn.right.color, AnaglyphMethod::kDubois).value();
  const auto color = [&](const RayHits& hits) {
    return hits.nearest == 0 ? settings.render.background : colors[std::size_t(hits.nearest - 1)];
  };
  WorstError worst;
  bool clamped = false;
  for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
    const auto in_left = left.hits(i), in_right = right.hits(i);
    if (!in_left || !in_right) continue;
    const Bytes exact = exact_mix(color(*in_left), color(*in_right));
    const Bytes found{shown.pixels[i].r, shown.pixels[i].g, shown.pixels[i].b};
    for (std::size_t k = 0; k < 3; ++k) {
      worst.add(std::abs(int(found[k]) - int(exact[k])), 1);
      clamped = clamped || (exact[k] == 0 && in_left->nearest > 0);
    }
  }
  if (2 * std::size_t(worst.count()) < 3 * shown.pixels.size() || !clamped) {
    return must_be_zero(HUGE_VAL, "too few pixels could be compared");
  }
  return worst.outcome(fmt::format("{} channels", worst.count()));
}

}  // namespace c77

ExtremeCase c77_dubois_negatives() {
  using namespace c77;
  return {
      .id = "C-77",
      .name = "Dubois' negative numbers",
      .construction = "all pairs of 27 colours from black to white through Dubois' matrix (2009)",
      .stage = "anaglyph",
      .right_answer =
          "colours are mixed in linear light, clamped and encoded; a channel may differ by one "
          "code, because the float sum may round to the next code, and white stays 255",
      .unit = "bytes",
      .oracle = Oracle::kRational,
      .ours = {"computed in linear light, and clamped after the matrix",
               [] { return measure_error(pipeline_mix, dubois()); }},
      .naive = {"computed with bytes, which wrap around",
                [] { return measure_error(wrapping_mix, dubois()); }},
      .mutants = {{"negatives are not clamped",
                   [] { return measure_error(unclamped_mix, dubois()); }},
                  {"stored sRGB values are mixed without decoding",
                   [] { return measure_error(gamma_mix, dubois()); }},
                  {"the matrix is transposed",
                   [] { return measure_error(pipeline_mix, transposed()); }},
                  {"one entry is misprinted: -0.62 in place of -0.062",
                   [] { return measure_error(pipeline_mix, with_misprint()); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
