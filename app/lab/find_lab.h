// From what a user types to a lab.
#pragma once

#include <filesystem>
#include <string>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

// "5", "05", "05-clipping" or "clipping".
Result<const labs::Lab*> find_lab(const std::string& name);

// A folder in which a lab is done, or the lab's own in the source tree.
struct LabFolder {
  const labs::Lab* lab = nullptr;
  std::filesystem::path student;  // student.cpp
  std::filesystem::path
      build_dir;     // in the folder, or in the user's cache where the folder is the lab's own
  bool own = false;  // the lab's own folder, with the solution
};
Result<LabFolder> open_lab_folder(const std::string& folder);

// "1 to 9", for a message.
std::string lab_names();

}  // namespace glassbox::app
