// Finds the lab that a user names.
#pragma once

#include <filesystem>
#include <string>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

// Accepts "5", "05", "05-clipping" or "clipping". `asked_by` is the option or file that the name
// comes from; an error begins with it.
Result<const labs::Lab*> find_lab(const std::string& name, const std::string& asked_by = "LAB");

// A student's folder for a lab, or the lab's own folder in the source tree.
struct LabFolder {
  const labs::Lab* lab = nullptr;
  std::filesystem::path student;  // student.cpp
  // in the folder; or in the user's cache if the folder is the lab's own or contains symbolic links
  std::filesystem::path build_dir;
  // Always in the user's cache, because they hold hidden checks or programs that are loaded:
  // `cache` belongs to this folder, `kits` is for all labs.
  std::filesystem::path cache, kits;
  bool own = false;                    // the lab's own folder, with the solution
  std::filesystem::path outside = {};  // the lab's folder, if it is not one of the program's labs
};

// What the user gave a command to find the lab by.
struct AskedLab {
  std::string folder;
  // --lab, a name for find_lab: the lab whose student.cpp is in `folder`, as it was handed in.
  // Nothing is written there.
  std::string lab = {};
  // --lab-dir: the folder of a lab that is not one of the program's. It is compiled where `folder`
  // is built. At most one of `lab` and `lab_dir` is given.
  std::string lab_dir = {};
};
Result<LabFolder> open_lab_folder(const AskedLab& asked);

// The range of the labs' numbers for a message: "1 to 9".
std::string lab_names();

}  // namespace glassbox::labs
