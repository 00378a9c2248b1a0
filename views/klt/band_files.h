// Reads bands (pictures with one number for each pixel) from files, and writes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

#include "views/klt/bands.h"
#include "views/klt/cube_header.h"

namespace glassbox::views {

// Files whose bands all have the same size, which their headers state; the pixels are not decoded
// yet.
struct BandFiles {
  int width = 0, height = 0, count = 0;
  struct File {
    std::string path;
    std::vector<std::byte> bytes;    // for a picture
    std::optional<CubeHeader> cube;  // for a raw cube, whose numbers are in the file `numbers`
    std::string numbers;
  };
  std::vector<File> files;
};

// Each file is either a picture or the header of a raw cube. A picture (PGM, PNG and the other
// formats of read.h) has a band for each channel except alpha, with the stored numbers: 8 or 16
// bits. A header X.hdr belongs to a raw cube whose numbers are in X, X.img, X.raw, X.dat, X.bsq,
// X.bil or X.bip beside it. Refused: files of several sizes, more than kMaxBands bands, fewer
// bytes than a header demands, and bands that would need more than `most_bytes` as doubles.
Result<BandFiles> open_bands(const std::vector<std::string>& paths, std::uint64_t most_bytes);
Result<Bands> decode_bands(const BandFiles& files);

// Opens the files and decodes the bands.
Result<Bands> read_bands(const std::vector<std::string>& paths, std::uint64_t most_bytes);

// An error if this many planes of doubles need more than `most_bytes`. `what` names the planes in
// the message: "the bands".
Result<void> check_planes(std::uint64_t width, std::uint64_t height, std::uint64_t planes,
                          std::uint64_t most_bytes, const std::string& what);

// Writes X.hdr and X.img for a path X.
Result<void> write_cube(const std::string& path, const Bands& bands);

// A band as a grey picture: `low` is black, `high` white.
Image<Rgba8> grey_of(const Bands& bands, int band, double low, double high);

}  // namespace glassbox::views
