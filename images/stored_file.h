// A picture file for comparisons: the picture that is read, and what else the file has.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glassbox/images/stored_image.h>

namespace glassbox {

struct StoredFile {
  StoredImage image;  // of an animation, the first frame
  // What else the file shows: the frames of an animated PNG, what stands behind the picture in a
  // PBM, PGM, PPM or PAM file, or the further channels of an OpenEXR file and the place of its data
  // window. Two files of equal first pictures and equal bytes here look the same throughout. Empty
  // for most files.
  std::vector<std::byte> rest;
  std::string rest_name;  // "2 further frames", "18 bytes behind it"
  std::string rest_remedy = "save every picture as a file of its own, and compare these";
  std::vector<std::string> notes;  // what is odd about the file, in sentences
  int orientation = 1;             // the one in the Exif data of a JPEG, 1 to 8; it is applied
};

// As decode_stored and read_stored, with the same errors.
Result<StoredFile> decode_stored_file(std::span<const std::byte> bytes,
                                      const DecodeLimits& limits = kCompareLimits);
Result<StoredFile> read_stored_file(const std::string& path,
                                    const DecodeLimits& limits = kCompareLimits);

}  // namespace glassbox
