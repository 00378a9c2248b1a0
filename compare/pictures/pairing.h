// Two directories of pictures, paired by name.
#pragma once

#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox {

// Two pictures of the same name, of which at least one exists.
struct PicturePaths {
  std::string name;             // path below the two directories, with / between folders
  std::string reference, test;  // their paths, also of a picture that does not exist
  bool has_reference = false;
  bool has_test = false;
};

struct Pairing {
  std::vector<PicturePaths> pictures;  // sorted by name
  // Sidecars of the reference directory that belong to no picture.
  std::vector<std::string> orphans;
};

// False if there is certainly no file or directory of this name; true also if it cannot be found
// out, for example because a directory above it may not be searched.
bool may_exist(const std::string& path);

// Finds all pictures below the two directories, subfolders included (links to folders are not
// followed): files with the extension of a picture, in upper or lower case, and files whose first
// bytes are those of a picture, whatever their name. Formats that are known, but not read, are
// among them, so that they count as not compared. A reference directory that does not exist has no
// pictures. An error where there is no picture at all.
Result<Pairing> pair_directories(const std::string& reference, const std::string& test);

}  // namespace glassbox
