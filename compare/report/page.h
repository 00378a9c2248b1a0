// Comparisons as one HTML page that needs no network and no other file.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <glassbox/base/error.h>
#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/compare/report/page_crops.h>

namespace glassbox {

struct PageOptions {
  std::string title = "glassbox diff";
  std::string program;  // "glassbox 0.1.0"
  std::string command;  // the command line that made the page
  CropLimits crops;
  // The largest size of the samples of all pictures in the page, before compression: a pair of 4096
  // x 4096 RGBA with its heat map fits.
  std::uint64_t max_bytes = std::uint64_t(9) << 24;
};

// Writes the page, completely or not at all. For pairs that differ it has the exact samples, the
// worst pair first, until max_bytes are used up; the page says which pairs are left out, and how to
// get a page of them. For pictures that are the same it has only the name, unless there is only one
// pair. The files are read again, one pair after the other.
Result<void> write_page(const std::string& path, std::span<const Comparison> comparisons,
                        const PageOptions& options = {});

}  // namespace glassbox
