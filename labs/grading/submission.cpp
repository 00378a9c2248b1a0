#include "labs/grading/submission.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>

#include <fmt/format.h>

#include "labs/grading/archive.h"

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

// The entries of a folder, by name, without those that operating systems add.
std::vector<fs::path> entries_of(const fs::path& folder, std::error_code& error) {
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with('.') && name != "__MACOSX") found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

fs::file_type type_of(const fs::path& path) {
  std::error_code error;
  return fs::symlink_status(path, error).type();
}

std::vector<fs::path> folders_in(const fs::path& folder, std::error_code& error) {
  std::vector<fs::path> found = entries_of(folder, error);
  std::erase_if(found,
                [](const fs::path& path) { return type_of(path) != fs::file_type::directory; });
  return found;
}

// Some of the files below a folder, to be named in a message.
std::vector<fs::path> files_below(const fs::path& folder) {
  constexpr std::size_t kMost = 100;
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end;
       !error && at != end && files.size() < kMost; at.increment(error)) {
    std::error_code ignored;
    if (at->is_regular_file(ignored)) files.push_back(at->path().lexically_relative(folder));
  }
  return files;
}

// Opens the file once and checks the open file, so that nobody can replace it between the check and
// the reading.
Result<std::string> read_ordinary(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (file < 0) {
    return refused(path, errno == ELOOP
                             ? "is a link"
                             : fmt::format("cannot be opened: {}", std::strerror(errno)));
  }
  struct stat status = {};
  std::string text, cause;
  if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
    cause = "is not an ordinary file";
  } else if (status.st_size > static_cast<off_t>(kLargestSource)) {
    cause = fmt::format("has {} bytes; at most {} are allowed", status.st_size, kLargestSource);
  } else {
    text.resize(static_cast<std::size_t>(status.st_size));
    const ssize_t got = ::pread(file, text.data(), text.size(), 0);
    if (got != static_cast<ssize_t>(text.size())) cause = "cannot be read";
  }
  ::close(file);
  if (!cause.empty()) return refused(path, cause);
  return text;
}

// The archive in a folder that has exactly one.
std::optional<fs::path> only_archive(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found = entries_of(folder, error);
  std::erase_if(found, [](const fs::path& path) { return !is_archive(path); });
  if (found.size() != 1) return std::nullopt;
  return found[0];
}

}  // namespace

tl::unexpected<Error> missing_file_error(const std::string& name, std::vector<fs::path> found) {
  constexpr std::size_t kNamed = 8;
  std::sort(found.begin(), found.end());
  std::string names;
  for (std::size_t i = 0; i < std::min(found.size(), kNamed); ++i)
    names += (i == 0 ? "" : ", ") + found[i].generic_string();
  if (found.size() > kNamed) names += ", ...";
  return fail(name, fmt::format("is missing; there is {}", found.empty() ? "no file" : names),
              "hand in " + name + ", at the top level of the submission");
}

Result<std::string> read_source(const fs::path& path) {
  return read_ordinary(path);
}

Result<std::string> read_submitted_file(const fs::path& submission, const std::string& name) {
  const fs::file_type type = type_of(submission);
  if (type == fs::file_type::symlink) return refused(submission, "is a link");
  if (type == fs::file_type::regular && is_archive(submission))
    return read_from_archive(submission, name);
  if (type != fs::file_type::directory) {
    if (name == "student.cpp") return read_ordinary(submission);
    return missing_file_error(name, {submission.filename()});
  }
  if (is_there(submission / name)) return read_ordinary(submission / name);
  std::error_code error;
  const std::vector<fs::path> inner = folders_in(submission, error);
  if (inner.size() == 1 && is_there(inner[0] / name)) return read_ordinary(inner[0] / name);
  if (const auto archive = only_archive(submission)) return read_from_archive(*archive, name);
  return missing_file_error(name, files_below(submission));
}

Result<std::string> read_submission(const fs::path& submission) {
  return read_submitted_file(submission, "student.cpp");
}

std::string submission_name(const fs::path& path) {
  std::error_code error;
  // so that "." and "ann/" have names too
  fs::path place = fs::absolute(path, error).lexically_normal();
  if (!place.has_filename()) place = place.parent_path();
  if (fs::is_directory(place, error)) return place.filename().string();
  if (!is_archive(place) && place.extension() != ".cpp") return place.filename().string();
  std::string stem = place.stem().string();
  if (is_archive(place) && stem.ends_with(".tar")) stem.erase(stem.size() - 4);
  return stem;
}

Result<ClassFolder> list_submissions(const fs::path& folder) {
  std::error_code error;
  const std::vector<fs::path> entries = entries_of(folder, error);
  if (error) {
    return fail(folder.string(), error.message(),
                "name the folder that has one folder for each submission");
  }
  ClassFolder found;
  const auto add = [&](const std::string& name, const fs::path& path) {
    if (name == kTableOfClass || name == kPageOfClass) {
      found.skipped.push_back(fmt::format("{}: this name is needed for a file of the results",
                                          path.filename().string()));
      return;
    }
    const auto same = std::find_if(found.submissions.begin(), found.submissions.end(),
                                   [&](const Submission& each) { return each.name == name; });
    if (same == found.submissions.end()) {
      found.submissions.push_back({name, path});
    } else {
      found.skipped.push_back(fmt::format("{}: another submission, {}, has the same name",
                                          path.filename().string(),
                                          same->path.filename().string()));
    }
  };
  // Folders are listed first, so that an archive beside the folder that it was unpacked to is not
  // taken as a second submission.
  for (const fs::path& path : entries) {
    if (fs::is_directory(path, error)) add(path.filename().string(), path);
  }
  for (const fs::path& path : entries) {
    const std::string name = path.filename().string();
    if (fs::is_directory(path, error)) continue;
    if (is_archive(path)) {
      add(submission_name(path), path);
    } else if (path.extension() == ".cpp") {
      add(submission_name(path), path);
    } else {
      found.skipped.push_back(name + ": is neither a folder nor an archive nor a .cpp file");
    }
  }
  std::sort(found.submissions.begin(), found.submissions.end(),
            [](const Submission& a, const Submission& b) { return a.name < b.name; });
  if (found.submissions.empty()) {
    return fail(folder.string(), "holds no submission",
                "put each submission's student.cpp into a folder of its own in it");
  }
  return found;
}

Result<std::vector<std::string>> list_folders(const fs::path& folder) {
  std::error_code error;
  const std::vector<fs::path> folders = folders_in(folder, error);
  if (error || folders.empty()) {
    return fail(folder.string(), error ? error.message() : "holds no folder",
                "name the folder that `lab grade` wrote, with one folder for each submission");
  }
  std::vector<std::string> names;
  for (const fs::path& each : folders) names.push_back(each.filename().string());
  return names;
}

}  // namespace glassbox::labs::grading
