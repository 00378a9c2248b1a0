// Bands from files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

#include "views/klt/bands.h"

namespace glassbox::views {

// Each file is a picture (PGM, PNG and what read.h names; a band for each channel that is no alpha, as stored: 8 or 16 bits) or the header
// X.hdr of a raw cube, whose numbers are in X, X.img, X.raw, X.dat, X.bsq, X.bil or X.bip beside it. Refused: files of several sizes, more
// than kMostBands, and numbers that would take more than `most_bytes` as doubles, before they are decoded.
Result<Bands> read_bands(const std::vector<std::string>& paths, std::uint64_t most_bytes);

// X.hdr and X.img of a path X.
Result<void> write_cube(const std::string& path, const Bands& bands);

// A band as greys: `low` black, `high` white.
Image<Rgba8> grey_of(const Bands& bands, int band, double low, double high);

}  // namespace glassbox::views
