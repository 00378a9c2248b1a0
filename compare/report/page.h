// Comparisons as one HTML page that needs no network and no other file, or as a page with a folder
// of pictures beside it.
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
  // What the page has of a pair beyond max_bytes or with a file beside it, and the largest size of
  // all these samples.
  CropLimits small_crops{.whole_pixels = 2 * 96 * 96, .side = 96, .count = 2};
  std::uint64_t max_crop_bytes = std::uint64_t(1) << 25;
  // Whether whole pictures that are not small are files in a folder beside the page
  // (page_folder.h), which loads them when they are looked at. Then max_bytes has no effect.
  bool files_beside = false;
};

// Writes the page, completely or not at all. It lists all pairs, the worst first. For pairs that
// differ it has a thumbnail and the exact samples, until max_bytes are used up; then it has small
// pictures whole, and crops around the worst regions of the others, until max_crop_bytes are used
// up. The page says where pictures are not whole, and how to get the whole ones. For pictures that
// are the same it has only numbers, unless there is only one pair. Files are read again, one pair
// after the other, unless the comparison kept their pixels.
//
// Files beside the page are checked before anything is written, and written before the page. Then
// the files with higher numbers are removed, which an earlier page with more pairs had. Pictures of
// up to small_crops.whole_pixels are in the page, and not in a file, until max_crop_bytes are used
// up.
Result<void> write_page(const std::string& path, std::span<const Comparison> comparisons,
                        const PageOptions& options = {});

}  // namespace glassbox
