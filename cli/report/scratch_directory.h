// A directory for a command's temporary files.
#pragma once

#include <filesystem>
#include <string>

#include <glassbox/base/error.h>

namespace glassbox {

// A directory below the system's temporary directory, removed with the object. If the program was
// killed, the next program that makes such a directory removes it. Each program holds a lock in its
// directory, so that unused directories are recognised. Other users may pass through the directory,
// but not list it.
class ScratchDirectory {
public:
  ScratchDirectory();
  ~ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  // The directory's path. An error if it could not be made.
  Result<std::filesystem::path> path() const;
  // Makes a new directory inside this one that other users cannot enter.
  Result<std::filesystem::path> make_private_directory(const std::string& name) const;

private:
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace glassbox
