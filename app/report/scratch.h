// A directory for what a command makes on the way.
#pragma once

#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include <glassbox/base/error.h>

namespace glassbox::app {

// Below the system's temporary directory; removed with the object. Others may pass through it, but not list it.
class Scratch {
public:
  Scratch() {
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "glassbox-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr && ::chmod(name.c_str(), 0711) == 0) path_ = name;
  }
  ~Scratch() {
    std::error_code error;
    if (!path_.empty()) std::filesystem::remove_all(path_, error);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  // Where there could be none, an error.
  Result<std::filesystem::path> path() const {
    if (path_.empty()) {
      return fail("the temporary directory", "nothing can be made there",
                  "name one that can be written to in the environment variable TMPDIR");
    }
    return path_;
  }
  // A new directory in it that nobody else may enter.
  Result<std::filesystem::path> own(const std::string& name) const {
    const auto place = path();
    if (!place) return place;
    const std::filesystem::path made = *place / name;
    if (::mkdir(made.c_str(), 0700) != 0)
      return fail(made.string(), "cannot be made", "free some space there");
    return made;
  }

private:
  std::filesystem::path path_;
};

}  // namespace glassbox::app
