#include "labs/grading/archive.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

#include <archive.h>
#include <archive_entry.h>

#include <fmt/format.h>

#include "labs/grading/submission.h"

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(archive* reader) const { archive_read_free(reader); }
};
using OpenArchive = std::unique_ptr<archive, Close>;

auto archive_refused(const fs::path& file, const std::string& cause) {
  return fail(file.filename().string(), cause,
              "hand in student.cpp itself, or a plain .zip of the lab's folder");
}

// The contents of an archive, as far as they matter; folders are ignored.
struct Contents {
  std::vector<fs::path> files;
  std::vector<std::pair<fs::path, std::string>> wanted;  // the files of the wanted name
  std::string refusal;  // why the archive is refused; empty if it is not
};

bool is_hostile(const fs::path& path) {
  return path.empty() || path.is_absolute() ||
         std::find(path.begin(), path.end(), "..") != path.end();
}

// Reads the entry's bytes, subtracts their number from `left`, and appends them to `kept` if that
// is not null. Returns why it failed; empty if it did not.
std::string read_bytes(archive* reader, std::size_t& left, std::string* kept) {
  char block[65536];
  while (true) {
    const la_ssize_t got = archive_read_data(reader, block, sizeof block);
    if (got == 0) return {};
    if (got < 0) return "is damaged or encrypted";
    const auto size = static_cast<std::size_t>(got);
    if (size > left) return fmt::format("holds more than {} MiB of files", kMaxUnpacked >> 20);
    left -= size;
    if (kept == nullptr) continue;
    if (kept->size() + size > kLargestSource)
      return fmt::format("has a source file of more than {} bytes", kLargestSource);
    kept->append(block, size);
  }
}

Contents read_all(archive* reader, const std::string& name) {
  Contents contents;
  std::size_t left = kMaxUnpacked, entries = 0;
  archive_entry* entry = nullptr;
  while (true) {
    const int status = archive_read_next_header(reader, &entry);
    if (status == ARCHIVE_EOF) return contents;
    if (status != ARCHIVE_OK && status != ARCHIVE_WARN) {
      contents.refusal = "is damaged, or is not an archive";
      return contents;
    }
    if (++entries > kMaxEntries) {
      contents.refusal = fmt::format("has more than {} files and folders", kMaxEntries);
      return contents;
    }
    const char* stored = archive_entry_pathname_utf8(entry);
    if (stored == nullptr) stored = archive_entry_pathname(entry);
    const fs::path path = fs::path(stored != nullptr ? stored : "").lexically_normal();
    if (is_hostile(path)) {
      contents.refusal =
          fmt::format("has the path \"{}\", which is empty or leads out of the archive's folder",
                      path.string());
      return contents;
    }
    const bool is_wanted = path.filename() == name;
    const bool is_link =
        archive_entry_symlink(entry) != nullptr || archive_entry_hardlink(entry) != nullptr;
    if (is_wanted && is_link) {
      contents.refusal = name + " in it is a link";
      return contents;
    }
    if (archive_entry_filetype(entry) != AE_IFREG || is_link) continue;
    contents.files.push_back(path);
    std::string text;
    contents.refusal = read_bytes(reader, left, is_wanted ? &text : nullptr);
    if (!contents.refusal.empty()) return contents;
    if (is_wanted) contents.wanted.emplace_back(path, std::move(text));
  }
}

// Opens the file and checks the open descriptor, so that nobody can replace the file between the
// check and the reading. If the file is refused, returns -1 and sets `why`.
int open_ordinary(const fs::path& file, std::string& why) {
  const int opened = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  struct stat status = {};
  if (opened < 0 || ::fstat(opened, &status) != 0 || !S_ISREG(status.st_mode)) {
    why = "is not an ordinary file";
  } else if (status.st_size > static_cast<off_t>(kLargestArchive)) {
    why = fmt::format("has {} bytes; at most {} are allowed", status.st_size, kLargestArchive);
  }
  if (!why.empty() && opened >= 0) ::close(opened);
  return why.empty() ? opened : -1;
}

}  // namespace

bool is_archive(const fs::path& file) {
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* end :
       {".zip", ".7z", ".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tar.xz", ".tar.zst"}) {
    if (name.ends_with(end)) return true;
  }
  return false;
}

Result<std::string> read_from_archive(const fs::path& file, const std::string& name) {
  std::string why;
  const int opened = open_ordinary(file, why);
  if (opened < 0) return archive_refused(file, why);
  const OpenArchive reader(archive_read_new());
  archive_read_support_format_zip(reader.get());
  archive_read_support_format_tar(reader.get());
  archive_read_support_format_7zip(reader.get());
  archive_read_support_filter_gzip(reader.get());
  archive_read_support_filter_bzip2(reader.get());
  archive_read_support_filter_xz(reader.get());
  archive_read_support_filter_zstd(reader.get());
  Contents contents;
  if (archive_read_open_fd(reader.get(), opened, 65536) == ARCHIVE_OK) {
    contents = read_all(reader.get(), name);
  } else {
    contents.refusal = "is damaged, or is not an archive";
  }
  ::close(opened);
  if (!contents.refusal.empty()) return archive_refused(file, contents.refusal);
  // Files that a Mac adds are ignored.
  std::erase_if(contents.files, [](const fs::path& path) { return *path.begin() == "__MACOSX"; });
  std::set<fs::path> folders;
  bool top = false;
  for (const fs::path& path : contents.files) {
    folders.insert(*path.begin());
    top = top || path == name;
  }
  for (auto& [path, text] : contents.wanted) {
    const bool in_only_folder = !top && folders.size() == 1 && path == *folders.begin() / name;
    if (path == name || in_only_folder) return std::move(text);
  }
  return missing_file_error(name, contents.files);
}

}  // namespace glassbox::labs::grading
