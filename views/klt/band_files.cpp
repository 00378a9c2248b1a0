#include "views/klt/band_files.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include <glassbox/images/atomic_file.h>
#include <glassbox/images/read.h>
#include <glassbox/images/stored_image.h>

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

// The number of channels without alpha.
int colors_of(int channels) {
  return channels <= 2 ? 1 : 3;
}

// Finds the data file of a header: one of the possible names in the header's folder.
Result<std::string> cube_of(const std::string& header_path) {
  const std::string stem = header_path.substr(0, header_path.size() - 4);
  for (const char* extension : {"", ".img", ".raw", ".dat", ".bsq", ".bil", ".bip"}) {
    std::error_code error;
    if (fs::is_regular_file(stem + extension, error)) return stem + extension;
  }
  return fail("", "the file with its samples is not beside it",
              "put " + fs::path(stem).filename().string() + ".img beside the header");
}

// An opened file, and the size and number of bands from its header.
struct OpenedFile {
  BandFiles::File file;
  int width = 0, height = 0, bands = 0;
};

Result<OpenedFile> open_cube(const std::string& path) {
  constexpr std::uint64_t kMaxHeader = 1 << 20;
  const auto text = read_file(path, kMaxHeader);
  if (!text) return tl::unexpected(text.error());
  const auto header =
      parse_cube_header({reinterpret_cast<const char*>(text->data()), text->size()});
  if (!header) return in_file(path, header.error());
  const auto numbers = cube_of(path);
  if (!numbers) return in_file(path, numbers.error());
  std::error_code error;
  const std::uintmax_t size = fs::file_size(*numbers, error);
  if (!error) {
    const auto enough = check_cube_size(*header, size);
    if (!enough) return in_file(*numbers, enough.error());
  }
  return OpenedFile{
      {path, {}, *header, *numbers}, int(header->width), int(header->height), int(header->bands)};
}

// The limit for the size of the file: a picture file is smaller than its bands are as doubles,
// except for text that the file may have beside the pixels (kMaxText).
Result<OpenedFile> open_picture(const std::string& path, std::uint64_t most_bytes) {
  constexpr std::uint64_t kMaxText = 1 << 20;
  auto bytes = read_file(path, most_bytes + kMaxText);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto header = stored_header(*bytes);
  if (!header) return in_file(path, header.error());
  return OpenedFile{{path, std::move(*bytes), {}, {}},
                    header->width,
                    header->height,
                    colors_of(header->channels)};
}

Result<Bands> decode_picture(const BandFiles::File& file) {
  const auto image = decode_stored(file.bytes);
  if (!image) return in_file(file.path, image.error());
  const int colors = colors_of(image->channels);
  Bands bands{image->width, image->height, {}};
  const std::string name = fs::path(file.path).stem().string();
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

Result<Bands> decode_file(const BandFiles::File& file) {
  if (!file.cube) return decode_picture(file);
  const auto bytes = read_file(file.numbers, file.cube->bytes() + kMaxTrailingBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto bands = decode_cube(*file.cube, *bytes);
  if (!bands) return in_file(file.numbers, bands.error());
  return bands;
}

}  // namespace

Result<void> check_planes(std::uint64_t width, std::uint64_t height, std::uint64_t planes,
                          std::uint64_t most_bytes, const std::string& what) {
  // The sides and the number of planes are small: the product is below 2^47.
  const std::uint64_t bytes = width * height * planes * sizeof(double);
  if (bytes <= most_bytes) return {};
  constexpr double kMegabyte = 1 << 20;
  return fail("",
              fmt::format("{} would need {:.3g} MB of memory, more than is allowed", what,
                          double(bytes) / kMegabyte),
              fmt::format("allow more memory with --max-mb {}", (bytes >> 20) + 1));
}

Result<BandFiles> open_bands(const std::vector<std::string>& paths, std::uint64_t most_bytes) {
  BandFiles all;
  for (const std::string& path : paths) {
    auto one = is_header(path) ? open_cube(path) : open_picture(path, most_bytes);
    if (!one) return tl::unexpected(one.error());
    if (all.files.empty()) {
      all.width = one->width;
      all.height = one->height;
    } else if (one->width != all.width || one->height != all.height) {
      return in_file(path, {{},
                            {},
                            fmt::format("is {} x {} pixels, but {} is {} x {}", one->width,
                                        one->height, paths.front(), all.width, all.height),
                            "give pictures of one size"});
    }
    all.count += one->bands;
    if (all.count > int(kMaxBands)) {
      return in_file(path, {{},
                            {},
                            fmt::format("there are more than {} bands", kMaxBands),
                            "give fewer pictures, or a file with fewer bands"});
    }
    const auto fits = check_planes(std::uint64_t(all.width), std::uint64_t(all.height),
                                   std::uint64_t(all.count), most_bytes, "the bands");
    if (!fits) return in_file(path, fits.error());
    all.files.push_back(std::move(one->file));
  }
  return all;
}

Result<Bands> decode_bands(const BandFiles& files) {
  Bands all{files.width, files.height, {}};
  for (const BandFiles::File& file : files.files) {
    auto some = decode_file(file);
    if (!some) return some;
    for (Band& band : some->bands) all.bands.push_back(std::move(band));
  }
  return all;
}

Result<Bands> read_bands(const std::vector<std::string>& paths, std::uint64_t most_bytes) {
  return open_bands(paths, most_bytes).and_then(decode_bands);
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
