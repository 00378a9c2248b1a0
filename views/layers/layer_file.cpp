#include "views/layers/layer_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include <glassbox/pipeline/view.h>

namespace glassbox::views {

namespace {

constexpr std::string_view kMagic = "glassbox-layers 1\n";
constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The bytes of a number in the file's order, little-endian.
template <class T>
std::array<std::byte, sizeof(T)> in_order(T value) {
  auto bytes = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(bytes);
  return bytes;
}

class Writer {
public:
  template <class T>
  void put(T value) {
    const auto in_file = in_order(value);
    bytes.insert(bytes.end(), in_file.begin(), in_file.end());
  }
  void put(std::string_view word) {
    for (const char c : word) put(std::uint8_t(c));
  }
  void put(const Rgba8& c) {
    for (const std::uint8_t channel : {c.r, c.g, c.b, c.a}) put(channel);
  }

  std::vector<std::byte> bytes;
};

class Reader {
public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::size_t at() const { return at_; }
  std::size_t left() const { return bytes_.size() - at_; }
  void skip(std::size_t count) { at_ += count; }
  // If the next bytes are this word, removes them and returns true.
  bool take_word(std::string_view word) {
    if (left() < word.size() || std::memcmp(bytes_.data() + at_, word.data(), word.size()) != 0)
      return false;
    skip(word.size());
    return true;
  }
  // Reads a number and moves on to the next one. The caller has checked that its bytes are there.
  template <class T>
  T take() {
    std::array<std::byte, sizeof(T)> in_file;
    std::memcpy(in_file.data(), bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(in_file);
    return std::bit_cast<T>(in_file);
  }
  Rgba8 take_color() {
    Rgba8 c;
    for (std::uint8_t* channel : {&c.r, &c.g, &c.b, &c.a}) *channel = take<std::uint8_t>();
    return c;
  }

private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

using LensNumbers = std::array<double, 6>;

LensNumbers numbers_of(const PerspectiveLens& lens) {
  return {lens.fovy_radians, lens.near, lens.far.value_or(kInfinite)};
}
LensNumbers numbers_of(const OrthographicLens& lens) {
  return {lens.half_height, lens.near, lens.far};
}
LensNumbers numbers_of(const FrustumLens& lens) {
  return {lens.left, lens.right, lens.bottom, lens.top, lens.near, lens.far.value_or(kInfinite)};
}

std::optional<double> finite(double far) {
  return std::isinf(far) ? std::nullopt : std::optional(far);
}
std::optional<Lens> lens_of(std::uint32_t kind, const LensNumbers& n) {
  if (kind == 0) return PerspectiveLens{n[0], n[1], finite(n[2])};
  if (kind == 1) return OrthographicLens{n[0], n[1], n[2]};
  if (kind == 2) return FrustumLens{n[0], n[1], n[2], n[3], n[4], finite(n[5])};
  return std::nullopt;
}

// Optional parts of the file after the colours begin with one of these words, followed by four
// bytes for each sample.
constexpr std::string_view kNormals = "norm", kTriangles = "tris";

constexpr std::size_t kHeaderBytes = kMagic.size() + 2 * 4 + 4 + 6 * 8 + 16 * 8 + 4 + 4;

}  // namespace

std::vector<std::byte> encode_layers(const StoredLayers& layers) {
  Writer out;
  out.put(kMagic);
  const LayeredImage& image = layers.image;
  out.put(std::uint32_t(image.camera.width));
  out.put(std::uint32_t(image.camera.height));
  out.put(std::uint32_t(layers.camera.lens.index()));
  const auto numbers =
      std::visit([](const auto& lens) { return numbers_of(lens); }, layers.camera.lens);
  for (const double number : numbers) out.put(number);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      out.put(layers.camera.world_from_eye.at(row, column));
    }
  }
  out.put(layers.background);
  out.put(std::uint32_t(image.samples()));
  for (const std::uint32_t offset : image.first) out.put(offset);
  for (const float depth : image.depth) out.put(depth);
  for (const Rgba8& color : image.color) out.put(color);
  if (!image.normal.empty()) {
    out.put(kNormals);
    for (const SampleNormal& n : image.normal) {
      for (const std::int8_t number : {n.x, n.y, n.z, std::int8_t(0)}) out.put(number);
    }
  }
  if (!image.triangle.empty()) {
    out.put(kTriangles);
    for (const std::uint32_t number : image.triangle) out.put(number);
  }
  return std::move(out.bytes);
}

bool is_layers(std::span<const std::byte> bytes) {
  return bytes.size() >= kMagic.size() &&
         std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) == 0;
}

Result<StoredLayers> decode_layers(std::span<const std::byte> bytes, const std::string& source) {
  const auto bad = [&](std::size_t at, const std::string& what) {
    return fail(source, fmt::format("byte {}: {}", at, what),
                "make the file with `glassbox views layers build`");
  };
  if (!is_layers(bytes)) return bad(0, "this is not a layered depth image of version 1");
  if (bytes.size() < kHeaderBytes) return bad(bytes.size(), "the file ends inside its header");
  Reader in(bytes);
  in.skip(kMagic.size());
  const auto width = in.take<std::uint32_t>(), height = in.take<std::uint32_t>();
  if (width < 1 || height < 1 || width > kMaxImageSide || height > kMaxImageSide)
    return bad(in.at(),
               fmt::format("the picture has {} x {} pixels; 1 to {} in each direction are possible",
                           width, height, kMaxImageSide));
  const auto kind = in.take<std::uint32_t>();
  LensNumbers numbers;
  for (double& number : numbers) number = in.take<double>();
  StoredLayers layers;
  const std::optional<Lens> lens = lens_of(kind, numbers);
  if (!lens)
    return bad(in.at(), fmt::format("the kind of the lens is {}, but must be 0, 1 or 2", kind));
  layers.camera.lens = *lens;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      layers.camera.world_from_eye.at(row, column) = in.take<double>();
    }
  }
  const auto view = make_view(layers.camera, int(width), int(height));
  if (!view) return bad(in.at(), "the camera: " + view.error().cause);
  layers.background = in.take_color();
  const std::size_t samples = in.take<std::uint32_t>();
  const std::size_t offsets = std::size_t(width) * height + 1;
  const std::size_t wanted = 4 * offsets + 8 * samples, section = 4 + 4 * samples;
  const bool has_length =
      in.left() == wanted || in.left() == wanted + section || in.left() == wanted + 2 * section;
  if (!has_length)
    return bad(in.at(), fmt::format("{} pixels and {} samples need {} more bytes, but {} follow",
                                    offsets - 1, samples, wanted, in.left()));
  LayeredImage& image = layers.image;
  image.camera = layer_camera(*view);
  image.first.resize(offsets);
  for (std::uint32_t& offset : image.first) offset = in.take<std::uint32_t>();
  image.depth.resize(samples);
  for (float& depth : image.depth) depth = in.take<float>();
  image.color.resize(samples);
  for (Rgba8& color : image.color) color = in.take_color();
  if (in.left() > 0 && in.take_word(kNormals)) {
    image.normal.resize(samples);
    for (SampleNormal& n : image.normal) {
      for (std::int8_t* number : {&n.x, &n.y, &n.z}) *number = in.take<std::int8_t>();
      if (in.take<std::int8_t>() != 0)
        return bad(in.at() - 1, "the fourth byte of a normal is not 0");
    }
  }
  if (in.left() > 0 && in.take_word(kTriangles)) {
    image.triangle.resize(samples);
    for (std::uint32_t& number : image.triangle) number = in.take<std::uint32_t>();
  }
  if (in.left() > 0)
    return bad(in.at(), "what follows is neither normals nor triangles, or is in the wrong order");
  if (const auto good = check(image, source); !good) return tl::unexpected(good.error());
  return layers;
}

}  // namespace glassbox::views
