// A directory for what a command makes on the way.
#pragma once

#include <filesystem>
#include <string>

#include <glassbox/base/error.h>

namespace glassbox::app {

// Below the system's temporary directory; removed with the object, and where the program was killed, by the next that makes one:
// whoever uses such a directory holds a lock in it. Others may pass through it, but not list it.
class Scratch {
public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  // Where there could be none, an error.
  Result<std::filesystem::path> path() const;
  // A new directory in it that nobody else may enter.
  Result<std::filesystem::path> own(const std::string& name) const;

private:
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace glassbox::app
