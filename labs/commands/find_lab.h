// Finds the lab that a user names.
#pragma once

#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"
#include "labs/grading/outside_lab.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

// Accepts "5", "05", "05-clipping" or "clipping". `asked_by` is the option or file that the name
// comes from; an error begins with it.
Result<const labs::Lab*> find_lab(const std::string& name, const std::string& asked_by = "LAB");

// A student's folder for a lab, or the lab's own folder in the source tree.
struct LabFolder {
  const labs::Lab* lab = nullptr;
  std::filesystem::path student;  // student.cpp
  // Where the program for a debugger is written; nothing that lies there is read or run. It is in
  // the folder; or in the user's cache if the folder is the lab's own or contains symbolic links.
  std::filesystem::path build_dir;
  // Always in the user's cache, because they hold hidden checks or programs that are run: `cache`
  // belongs to this folder, `kits` is for all labs.
  std::filesystem::path cache, kits;
  std::filesystem::path outside = {};  // the lab's folder, if it is not one of the program's labs
};

// The parts of a command line that select a lab.
struct LabSelection {
  std::string folder;
  // --lab, a name for find_lab: the lab that the student.cpp in `folder` belongs to, as it was
  // handed in. Nothing is written into `folder`.
  std::string lab = {};
  // --lab-dir: the folder of a lab that is not one of the program's. It is compiled where `folder`
  // is built. At most one of `lab` and `lab_dir` is given.
  std::string lab_dir = {};
};
Result<LabFolder> open_lab_folder(const LabSelection& selection);

// The range of the labs' numbers for a message: "1 to 9".
std::string lab_names();

// Adds --lab-dir, which names the folder of a lab that is not one of the program's. add_lab_name()
// below adds --lab, which says to which of the program's labs a folder belongs.
inline CLI::Option* add_lab_dir(CLI::App& command, std::string& folder) {
  return command
      .add_option("--lab-dir", folder, "a lab of your own: its folder NN-name (docs/labs.md)")
      ->type_name("DIR");
}

inline CLI::Option* add_lab_name(CLI::App& command, std::string& name) {
  return command.add_option("--lab", name, "the lab that a folder without lab.json belongs to");
}

// The sources with the lab in `folder` instead of the program's labs; unchanged if `folder` is
// empty.
inline Result<labs::Sources> with_lab_dir(Result<labs::Sources> sources,
                                          const std::string& folder) {
  if (!sources || folder.empty()) return sources;
  const auto found = labs::grading::find_outside_lab(folder);
  if (!found) return tl::unexpected(found.error());
  sources->outside = *found;
  return sources;
}

}  // namespace glassbox::labs
