// From what a user types to a lab.
#pragma once

#include <filesystem>
#include <string>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

// "5", "05", "05-clipping" or "clipping". `asked_by` is what named it, which an error begins with.
Result<const labs::Lab*> find_lab(const std::string& name, const std::string& asked_by = "LAB");

// A folder in which a lab is done, or the lab's own in the source tree.
struct LabFolder {
  const labs::Lab* lab = nullptr;
  std::filesystem::path student;  // student.cpp
  std::filesystem::path
      build_dir;  // in the folder, or in the user's cache where the folder is the lab's own, or has links there
  // In the user's cache in any case, for what has hidden checks in it or is loaded: the folder's own place, and one for kits.
  std::filesystem::path cache, kits;
  bool own = false;                    // the lab's own folder, with the solution
  std::filesystem::path outside = {};  // of a lab that is not the program's, where the lab lies
};

// What a command was given to find it by.
struct AskedLab {
  std::string folder;
  // --lab, which find_lab knows: the folder has a student.cpp of that lab in it, as it was handed in; nothing is written there.
  std::string lab = {};
  // --lab-dir: of the lab that lies there, which is compiled where `folder` is built. One of the two at most.
  std::string lab_dir = {};
};
Result<LabFolder> open_lab_folder(const AskedLab& asked);

// "1 to 9", for a message.
std::string lab_names();

}  // namespace glassbox::app
