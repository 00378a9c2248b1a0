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
#include "labs/grading/choose_file.h"

#include <glassbox/base/ascii_case.h>

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;

auto refused(const fs::path& path, const std::string& cause) {
  return fail(path.filename().string(), cause, "hand in student.cpp itself, as an ordinary file");
}

// The entries of a folder, by name, without those that operating systems add.
std::vector<fs::path> entries_of(const fs::path& folder, std::error_code& error) {
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (!is_ignored(entry->path().filename())) found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool is_source(const fs::path& file) {
  return lower_case(file.extension().string()) == ".cpp";
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

// What a folder has, by paths within it.
struct FolderContents {
  std::vector<fs::path> wanted;    // what has the wanted name and is no folder
  std::vector<fs::path> archives;  // ordinary files
  std::vector<fs::path> others;    // some of the other files, to be named in a message
};

// Reads a folder level by level and each level by name, so that what is found does not depend on
// the file system where the folder has more than kMaxEntries entries. Links are not followed.
FolderContents contents_of(const fs::path& folder, const std::string& name) {
  constexpr std::size_t kMostOthers = 100;
  FolderContents found;
  std::size_t entries = 0;
  std::vector<fs::path> level{fs::path()};
  while (!level.empty()) {
    std::vector<fs::path> next;
    for (const fs::path& each : level) {
      std::error_code error;
      for (const fs::path& place : entries_of(folder / each, error)) {
        if (++entries > kMaxEntries) return found;
        const fs::path path = each / place.filename();
        const fs::file_type type = type_of(place);
        if (type == fs::file_type::directory) {
          next.push_back(path);
        } else if (has_wanted_name(path, name)) {
          found.wanted.push_back(path);
        } else if (type == fs::file_type::regular && is_archive(path)) {
          found.archives.push_back(path);
        } else if (found.others.size() < kMostOthers) {
          found.others.push_back(path);
        }
      }
    }
    level = std::move(next);
  }
  return found;
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

Result<SubmittedFile> read_from_folder(const fs::path& folder, const std::string& name) {
  FolderContents contents = contents_of(folder, name);
  if (!contents.wanted.empty()) {
    const auto taken = std::min_element(
        contents.wanted.begin(), contents.wanted.end(),
        [&](const fs::path& a, const fs::path& b) { return is_taken_before(a, b, name); });
    const fs::path path = *taken;
    auto text = read_ordinary(folder / path);
    if (!text) return tl::unexpected(text.error());
    contents.wanted.erase(taken);
    return SubmittedFile{std::move(*text), note_of_choice(path, contents.wanted, name)};
  }
  std::sort(contents.archives.begin(), contents.archives.end(), is_archive_taken_before);
  std::optional<Error> refusal;  // of the first archive that was not read
  std::size_t left = kMaxUnpacked;
  for (std::size_t i = 0; i < std::min(contents.archives.size(), kMaxArchives); ++i) {
    const fs::path archive = contents.archives[i];
    auto read = read_from_archive(folder / archive, name, left);
    if (read) {
      contents.archives.erase(contents.archives.begin() + std::ptrdiff_t(i));
      if (!contents.archives.empty())
        read->note = note_of_choice(archive, contents.archives, name) + read->note;
      return read;
    }
    if (!refusal) refusal = read.error();
  }
  if (refusal) return tl::unexpected(*refusal);
  return missing_file_error(name, contents.others);
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
              "hand in " + name + ", in any folder of the submission");
}

Result<std::string> read_source(const fs::path& path) {
  return read_ordinary(path);
}

Result<SubmittedFile> read_submitted_file(const fs::path& submission, const std::string& name) {
  const fs::file_type type = type_of(submission);
  if (type == fs::file_type::symlink) return refused(submission, "is a link");
  if (type == fs::file_type::directory) return read_from_folder(submission, name);
  if (type == fs::file_type::regular && is_archive(submission))
    return read_from_archive(submission, name);
  if (name != "student.cpp") return missing_file_error(name, {submission.filename()});
  auto text = read_ordinary(submission);
  if (!text) return tl::unexpected(text.error());
  return SubmittedFile{std::move(*text), {}};
}

Result<SubmittedFile> read_submission(const fs::path& submission) {
  return read_submitted_file(submission, "student.cpp");
}

std::string submission_name(const fs::path& path) {
  std::error_code error;
  // so that "." and "ann/" have names too
  fs::path place = fs::absolute(path, error).lexically_normal();
  if (!place.has_filename()) place = place.parent_path();
  if (fs::is_directory(place, error)) return place.filename().string();
  if (!is_archive(place) && !is_source(place)) return place.filename().string();
  return is_archive(place) ? archive_stem(place) : place.stem().string();
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
      found.submissions.push_back({name, path, {}});
    } else {
      same->also.push_back(path.filename().string());
    }
  };
  // A folder comes first, because an archive beside it is often what it was unpacked from.
  const auto kind_of = [&](const fs::path& path) {
    return fs::is_directory(path, error) ? 0 : is_archive(path) ? 1 : is_source(path) ? 2 : 3;
  };
  for (int kind = 0; kind < 3; ++kind) {
    for (const fs::path& path : entries) {
      if (kind_of(path) == kind) add(submission_name(path), path);
    }
  }
  for (const fs::path& path : entries) {
    if (kind_of(path) == 3)
      found.skipped.push_back(path.filename().string() +
                              ": is neither a folder nor an archive nor a .cpp file");
  }
  std::sort(found.submissions.begin(), found.submissions.end(),
            [](const Submission& a, const Submission& b) { return a.name < b.name; });
  return found;
}

tl::unexpected<Error> no_submission_error(const fs::path& folder) {
  return fail(folder.string(), "holds no submission",
              "put each submission's student.cpp into a folder of its own in it");
}

Result<std::vector<std::string>> list_folders(const fs::path& folder) {
  std::error_code error;
  const std::vector<fs::path> folders = folders_in(folder, error);
  if (error) {
    return fail(folder.string(), error.message(),
                "name the folder that `lab grade` wrote, with one folder for each submission");
  }
  std::vector<std::string> names;
  for (const fs::path& each : folders) names.push_back(each.filename().string());
  return names;
}

}  // namespace glassbox::labs::grading
