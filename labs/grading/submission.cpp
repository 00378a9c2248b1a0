#include "labs/grading/submission.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;

auto refused(const fs::path& path, const std::string& cause) {
  return fail(path.filename().string(), cause, "hand in student.cpp itself, as an ordinary file");
}

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::symlink_status(path, error).type() != fs::file_type::not_found && !error;
}

std::vector<fs::path> folders_in(const fs::path& folder, std::error_code& error) {
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code unreadable;
    if (name.starts_with('.') || name == "__MACOSX") continue;
    if (entry->symlink_status(unreadable).type() == fs::file_type::directory)
      found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// The file is opened once and asked about afterwards, so that it cannot be another in between.
Result<std::string> read_ordinary(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (file < 0) {
    return refused(path, errno == ELOOP
                             ? "is a link"
                             : fmt::format("cannot be opened: {}", std::strerror(errno)));
  }
  struct stat status {};
  std::string text, cause;
  if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
    cause = "is no ordinary file";
  } else if (status.st_size > static_cast<off_t>(kLargestSource)) {
    cause = fmt::format("has {} bytes; {} are the most", status.st_size, kLargestSource);
  } else {
    text.resize(static_cast<std::size_t>(status.st_size));
    const ssize_t got = ::pread(file, text.data(), text.size(), 0);
    if (got != static_cast<ssize_t>(text.size())) cause = "cannot be read";
  }
  ::close(file);
  if (!cause.empty()) return refused(path, cause);
  return text;
}

}  // namespace

Result<std::string> read_submitted(const fs::path& folder, const std::string& name) {
  if (is_there(folder / name)) return read_ordinary(folder / name);
  std::error_code error;
  const std::vector<fs::path> inner = folders_in(folder, error);
  if (inner.size() == 1 && is_there(inner[0] / name)) return read_ordinary(inner[0] / name);
  return fail(name, "is missing", "hand in " + name + ", at the top of what is handed in");
}

Result<std::string> read_submission(const fs::path& folder) {
  return read_submitted(folder, "student.cpp");
}

Result<std::vector<std::string>> list_submissions(const fs::path& submissions) {
  std::error_code error;
  const std::vector<fs::path> folders = folders_in(submissions, error);
  if (error) {
    return fail(submissions.string(), error.message(),
                "name the folder that holds one folder a submission");
  }
  if (folders.empty()) {
    return fail(submissions.string(), "holds no folder",
                "put each submission's student.cpp into a folder of its own in it");
  }
  std::vector<std::string> names;
  for (const fs::path& each : folders) names.push_back(each.filename().string());
  return names;
}

}  // namespace glassbox::labs::grading
