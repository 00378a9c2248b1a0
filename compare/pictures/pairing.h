// Two directories of pictures, paired by name.
#pragma once

#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox {

// Two pictures of one name, of which at least one is there.
struct PicturePaths {
  std::string name;             // below both directories, with / between folders
  std::string reference, test;  // where they are or would be
  bool has_reference = false;
  bool has_test = false;
};

struct Pairing {
  std::vector<PicturePaths> pictures;  // by name
  // Sidecars of the reference directory that belong to no picture.
  std::vector<std::string> orphans;
};

// All pictures below the two directories, subfolders included (links to folders are not followed): files whose extension is
// png, jpg, jpeg, bmp, tga, ppm, pgm or pfm in either case. An error where there is none at all.
Result<Pairing> pair_directories(const std::string& reference, const std::string& test);

}  // namespace glassbox
