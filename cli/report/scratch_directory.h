// A directory for a command's temporary files.
#pragma once

#include <filesystem>
#include <string>

#include <glassbox/base/error.h>

namespace glassbox {

// A directory below the system's temporary directory. It is removed with the object; if the program
// was killed, the next program that makes one removes it. Each user of such a directory holds a
// lock in it, so that unused ones are recognised. Other users may pass through it, but not list it.
class ScratchDirectory {
public:
  ScratchDirectory();
  ~ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  // The directory's path. An error if it could not be made.
  Result<std::filesystem::path> path() const;
  // Makes a new directory in it that other users cannot enter.
  Result<std::filesystem::path> make_private_directory(const std::string& name) const;

private:
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace glassbox
