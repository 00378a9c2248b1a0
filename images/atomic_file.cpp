#include <glassbox/images/atomic_file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>

namespace glassbox {
namespace {

tl::unexpected<Error> file_error(const std::string& path, std::string cause, std::string remedy) {
  return tl::unexpected<Error>(Error{path, {}, std::move(cause), std::move(remedy)});
}

tl::unexpected<Error> system_error(const std::string& path, const std::string& what, int code) {
  const char* remedy = "write to another directory";
  if (code == ENOENT || code == ENOTDIR) remedy = "make the directory first";
  if (code == EACCES || code == EPERM || code == EROFS) {
    remedy = "write to another place or change the permissions";
  }
  if (code == ENOSPC || code == EDQUOT || code == EFBIG)
    remedy = "free some space or write to another disk";
  return file_error(path, what + ": " + std::strerror(code), remedy);
}

// A file descriptor that closes itself; close() reports errors, which the destructor cannot do.
class Descriptor {
public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }
  // Returns 0, or the error number if the file could not be closed.
  int close() { return ::close(std::exchange(fd_, -1)) == 0 ? 0 : errno; }

private:
  int fd_;
};

// Removes the temporary file that it names, unless the file has been renamed to its final name.
class TemporaryFile {
public:
  explicit TemporaryFile(std::string path) : path_(std::move(path)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  const std::string& path() const { return path_; }
  void keep() { path_.clear(); }

private:
  std::string path_;
};

// Writes all bytes. Returns 0 or the error number.
int write_all(int fd, std::span<const std::byte> bytes) {
  constexpr std::size_t kMaxAtOnce = std::size_t(1) << 30;  // Linux writes less than 2 GiB a call
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), std::min(bytes.size(), kMaxAtOnce));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return ENOSPC;
    bytes = bytes.subspan(std::size_t(written));
  }
  return 0;
}

// Writes to a pipe, terminal or device without a temporary file. The file is opened for appending,
// because /dev/stdout may be a regular file that already has content.
Result<void> write_directly(const std::string& path, std::span<const std::byte> bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  if (file.get() < 0) return system_error(path, "cannot be opened for writing", errno);
  if (const int code = write_all(file.get(), bytes)) {
    return system_error(path, "cannot be written", code);
  }
  if (const int code = file.close()) return system_error(path, "cannot be written", code);
  return {};
}

// Returns the path of the file to which symbolic links lead, so that a link stays a link when that
// file is replaced.
std::string behind_links(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr),
                                                         &std::free);
  return real ? std::string(real.get()) : path;
}

// Returns the path of a temporary file. It is in the target's own directory, because a rename
// cannot cross file systems. Its name has a fixed length, so that it also fits where the target's
// name is long. The process number and a counter make it unique, and O_EXCL refuses a name that
// exists nevertheless.
std::string temporary_beside(const std::string& target) {
  static std::atomic<unsigned> counter{0};
  const std::size_t slash = target.rfind('/');
  const std::string directory = slash == std::string::npos ? "" : target.substr(0, slash + 1);
  return directory + ".glassbox-" + std::to_string(::getpid()) + "-" +
         std::to_string(counter.fetch_add(1)) + ".tmp";
}

bool names_device(const std::string& path) {
  return path.starts_with("/dev/") || path.starts_with("/proc/");
}

}  // namespace

Result<void> write_file(const std::string& path, std::span<const std::byte> bytes) {
  if (path.empty()) return file_error("", "the file has no name", "name the file to write");
  struct stat status = {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    return file_error(path, "is a directory", "name a file in it");
  }
  if (exists && (!S_ISREG(status.st_mode) || names_device(path)))
    return write_directly(path, bytes);
  // A rename would replace even a file that is protected against writing.
  if (exists && ::access(path.c_str(), W_OK) != 0) {
    return system_error(path, "cannot be written", errno);
  }

  const std::string target = exists ? behind_links(path) : path;
  const std::string temporary_path = temporary_beside(target);
  Descriptor file(::open(temporary_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file.get() < 0) return system_error(path, "cannot be written", errno);
  TemporaryFile temporary(temporary_path);
  if (exists && ::fchmod(file.get(), status.st_mode & 0777) != 0) {
    return system_error(path, "cannot be written", errno);
  }
  if (const int code = write_all(file.get(), bytes)) {
    return system_error(path, "cannot be written", code);
  }
  if (const int code = file.close()) return system_error(path, "cannot be written", code);
  if (::rename(temporary.path().c_str(), target.c_str()) != 0) {
    return system_error(path, "cannot be written", errno);
  }
  temporary.keep();
  return {};
}

}  // namespace glassbox
