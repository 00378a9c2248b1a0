// Bands from files.
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

// Files that hold bands of one size, as their headers say; nothing is decoded.
struct BandFiles {
  int width = 0, height = 0, count = 0;
  struct File {
    std::string path;
    std::vector<std::byte> bytes;    // of a picture
    std::optional<CubeHeader> cube;  // of a raw cube, whose numbers are in `numbers`
    std::string numbers;
  };
  std::vector<File> files;
};

// Each file is a picture (PGM, PNG and what read.h names; a band for each channel that is no alpha, as stored: 8 or 16 bits) or the header
// X.hdr of a raw cube, whose numbers are in X, X.img, X.raw, X.dat, X.bsq, X.bil or X.bip beside it. Refused: files of several sizes, more
// than kMostBands, fewer bytes than a header asks for, and bands that would take more than `most_bytes` as doubles.
Result<BandFiles> open_bands(const std::vector<std::string>& paths, std::uint64_t most_bytes);
Result<Bands> decode_bands(const BandFiles& files);

// Both.
Result<Bands> read_bands(const std::vector<std::string>& paths, std::uint64_t most_bytes);

// Refused: more than `most_bytes` for so many planes of doubles. `what` they are: "the bands".
Result<void> check_planes(std::uint64_t width, std::uint64_t height, std::uint64_t planes,
                          std::uint64_t most_bytes, const std::string& what);

// X.hdr and X.img of a path X.
Result<void> write_cube(const std::string& path, const Bands& bands);

// A band as greys: `low` black, `high` white.
Image<Rgba8> grey_of(const Bands& bands, int band, double low, double high);

}  // namespace glassbox::views
