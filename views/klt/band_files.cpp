#include "views/klt/band_files.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include <glassbox/images/atomic_file.h>
#include <glassbox/images/read.h>
#include <glassbox/images/stored_image.h>

#include "views/klt/cube_header.h"

namespace glassbox::views {

namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> in_file(const std::string& path, Error error) {
  error.file = path;
  return tl::unexpected(std::move(error));
}

bool is_header(const std::string& path) {
  return path.ends_with(".hdr") || path.ends_with(".HDR");
}

Result<void> check_memory(std::uint64_t samples, std::uint64_t already, std::uint64_t most_bytes) {
  constexpr std::uint64_t kBytes = sizeof(double);
  if (samples <= most_bytes / kBytes && already + samples <= most_bytes / kBytes) return {};
  return fail("", fmt::format("the bands would take {} MB", ((already + samples) * kBytes) >> 20),
              "allow for it with --max-mb");
}

// One of the files that a header may be of, in its own folder.
Result<std::string> cube_of(const std::string& header_path) {
  const std::string stem = header_path.substr(0, header_path.size() - 4);
  for (const char* extension : {"", ".img", ".raw", ".dat", ".bsq", ".bil", ".bip"}) {
    std::error_code error;
    if (fs::is_regular_file(stem + extension, error)) return stem + extension;
  }
  return fail("", "there is no file with its numbers beside it",
              "put " + fs::path(stem).filename().string() + ".img there");
}

Result<Bands> read_cube(const std::string& path, std::uint64_t already, std::uint64_t most_bytes) {
  constexpr std::uint64_t kMostHeader = 1 << 20;
  const auto text = read_file(path, kMostHeader);
  if (!text) return tl::unexpected(text.error());
  const auto header =
      parse_cube_header({reinterpret_cast<const char*>(text->data()), text->size()});
  if (!header) return in_file(path, header.error());
  const auto enough =
      check_memory(header->width * header->height * header->bands, already, most_bytes);
  if (!enough) return in_file(path, enough.error());
  const auto data = cube_of(path);
  if (!data) return in_file(path, data.error());
  const auto bytes = read_file(*data, header->bytes() + most_bytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto bands = decode_cube(*header, *bytes);
  if (!bands) return in_file(*data, bands.error());
  return bands;
}

Result<Bands> read_picture(const std::string& path, std::uint64_t already,
                           std::uint64_t most_bytes) {
  DecodeLimits limits = kCompareLimits;
  limits.max_pixels = std::min(limits.max_pixels, most_bytes / sizeof(double));
  const auto image = read_stored(path, limits);
  if (!image) return tl::unexpected(image.error());
  const int colors = image->channels <= 2 ? 1 : 3;
  const auto enough = check_memory(image->pixels() * std::size_t(colors), already, most_bytes);
  if (!enough) return in_file(path, enough.error());
  Bands bands{image->width, image->height, {}};
  const std::string name = fs::path(path).stem().string();
  constexpr const char* kColors[] = {" red", " green", " blue"};
  for (int c = 0; c < colors; ++c) {
    Band band{colors == 1 ? name : name + kColors[c], std::vector<double>(bands.pixels())};
    std::visit(
        [&](const auto& samples) {
          for (std::size_t i = 0; i < bands.pixels(); ++i)
            band.samples[i] = double(samples[i * std::size_t(image->channels) + std::size_t(c)]);
        },
        image->samples);
    bands.bands.push_back(std::move(band));
  }
  return bands;
}

}  // namespace

Result<Bands> read_bands(const std::vector<std::string>& paths, std::uint64_t most_bytes) {
  Bands all;
  for (const std::string& path : paths) {
    const std::uint64_t already = all.pixels() * std::uint64_t(all.count());
    auto some = is_header(path) ? read_cube(path, already, most_bytes)
                                : read_picture(path, already, most_bytes);
    if (!some) return some;
    if (all.bands.empty()) {
      all.width = some->width;
      all.height = some->height;
    } else if (some->width != all.width || some->height != all.height) {
      return in_file(path, {{},
                            {},
                            fmt::format("is {} x {}, and {} is {} x {}", some->width, some->height,
                                        paths.front(), all.width, all.height),
                            "give bands of one size"});
    }
    for (Band& band : some->bands) all.bands.push_back(std::move(band));
    if (std::uint64_t(all.count()) > kMostBands)
      return in_file(
          path,
          {{}, {}, fmt::format("there are more than {} bands", kMostBands), "choose some of them"});
  }
  return all;
}

Result<void> write_cube(const std::string& path, const Bands& bands) {
  const std::string header = cube_header_text(bands);
  if (const auto written = write_file(path + ".img", cube_bytes(bands)); !written) return written;
  return write_file(path + ".hdr", std::as_bytes(std::span(header)));
}

Image<Rgba8> grey_of(const Bands& bands, int band, double low, double high) {
  Image<Rgba8> image(bands.width, bands.height);
  const auto& samples = bands.bands[std::size_t(band)].samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double share = high > low ? std::clamp((samples[i] - low) / (high - low), 0.0, 1.0) : 0.5;
    const auto grey = std::uint8_t(255 * share + 0.5);
    image.pixels[i] = {grey, grey, grey, 255};
  }
  return image;
}

}  // namespace glassbox::views
