#include "cli/report/scratch_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <system_error>

namespace glassbox {

namespace {

namespace fs = std::filesystem;

const std::string kPrefix = "glassbox-scratch-";
constexpr const char* kLock = "in-use";

// Opens the lock file at `path` and takes its lock, which is held until the descriptor is closed.
// Returns -1 if another process holds the lock, or if there is no file. With O_CREAT in `flags` the
// file is created.
int take_lock(const fs::path& path, int flags) {
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | flags, 0600);
  if (file < 0 || ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  ::close(file);
  return -1;
}

// Whether the directory is this user's and no process uses it any more. A directory without a lock
// file is just being made, unless it is an hour old.
bool is_abandoned(const fs::path& directory) {
  struct stat status = {};
  if (::lstat(directory.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) ||
      status.st_uid != ::geteuid())
    return false;
  std::error_code error;
  if (!fs::exists(directory / kLock, error)) return std::time(nullptr) - status.st_mtime > 3600;
  const int lock = take_lock(directory / kLock, 0);
  if (lock >= 0) ::close(lock);
  return lock >= 0;
}

void remove_abandoned(const fs::path& temporary) {
  std::error_code error;
  for (fs::directory_iterator entry(temporary, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (entry->path().filename().string().starts_with(kPrefix) && is_abandoned(entry->path()))
      fs::remove_all(entry->path(), ignored);
  }
}

}  // namespace

ScratchDirectory::ScratchDirectory() {
  std::error_code error;
  const fs::path temporary = fs::temp_directory_path(error);
  remove_abandoned(temporary);
  std::string name = (temporary / (kPrefix + "XXXXXX")).string();
  if (::mkdtemp(name.data()) == nullptr || ::chmod(name.c_str(), 0711) != 0) return;
  path_ = name;
  // The lock file gets its final name after the lock is taken, because another process removes a
  // directory whose lock is not held.
  const fs::path unnamed = path_ / "to-be-in-use";
  lock_ = take_lock(unnamed, O_CREAT);
  fs::rename(unnamed, path_ / kLock, error);
}

ScratchDirectory::~ScratchDirectory() {
  std::error_code error;
  if (!path_.empty()) fs::remove_all(path_, error);
  if (lock_ >= 0) ::close(lock_);
}

Result<fs::path> ScratchDirectory::path() const {
  if (path_.empty()) {
    return fail("the temporary directory", "no directory can be created in it",
                "set the environment variable TMPDIR to a directory that can be written to");
  }
  return path_;
}

Result<fs::path> ScratchDirectory::make_private_directory(const std::string& name) const {
  const auto place = path();
  if (!place) return place;
  const fs::path made = *place / name;
  if (::mkdir(made.c_str(), 0700) != 0)
    return fail(made.string(), "cannot be created", "free some space there");
  return made;
}

}  // namespace glassbox
