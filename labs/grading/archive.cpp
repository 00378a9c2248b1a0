#include "labs/grading/archive.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <archive.h>
#include <archive_entry.h>

#include <fmt/format.h>

#include "labs/grading/choose_file.h"

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

// A file of the wanted name: its text, or the reason why it is refused.
struct Candidate {
  fs::path path;
  std::string text, refusal = {};
};

// The contents of an archive, as far as they matter; folders are ignored.
struct Contents {
  std::vector<fs::path> files;
  std::set<fs::path> wanted;       // the files of the wanted name
  std::optional<Candidate> taken;  // the one of them that is graded
  std::string refusal;             // why the archive is refused; empty if it is not
};

bool is_hostile(const fs::path& path) {
  return path.empty() || path.is_absolute() ||
         std::find(path.begin(), path.end(), "..") != path.end();
}

// Reads the entry's bytes, subtracts their number from `left`, and stores them in `kept` if that is
// not null. Returns why the archive is refused; empty if it is not.
std::string read_bytes(archive* reader, std::size_t& left, Candidate* kept) {
  char block[65536];
  while (true) {
    const la_ssize_t got = archive_read_data(reader, block, sizeof block);
    if (got == 0) return {};
    if (got < 0) return "is damaged or encrypted";
    const auto size = static_cast<std::size_t>(got);
    if (size > left) {
      left = 0;
      return fmt::format("holds more than {} MiB of files", kMaxUnpacked >> 20);
    }
    left -= size;
    if (kept == nullptr) continue;
    if (kept->text.size() + size > kLargestSource) {
      kept->refusal = fmt::format("has a source file of more than {} bytes: {}", kLargestSource,
                                  kept->path.string());
      kept = nullptr;
      continue;
    }
    kept->text.append(block, size);
  }
}

Contents read_all(archive* reader, const std::string& name, std::size_t& left) {
  Contents contents;
  std::size_t entries = 0;
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
    const bool is_link =
        archive_entry_symlink(entry) != nullptr || archive_entry_hardlink(entry) != nullptr;
    const bool is_folder = archive_entry_filetype(entry) == AE_IFDIR && !is_link;
    if (is_folder || is_ignored(path)) {
      contents.refusal = read_bytes(reader, left, nullptr);
      if (!contents.refusal.empty()) return contents;
      continue;
    }
    std::optional<Candidate> candidate;
    if (has_wanted_name(path, name)) {
      contents.wanted.insert(path);
      // An entry with the path of an earlier one replaces it, as when the archive is unpacked.
      const bool is_taken = !contents.taken || path == contents.taken->path ||
                            is_taken_before(path, contents.taken->path, name);
      if (is_taken) candidate = Candidate{path, {}};
    }
    if (is_link || archive_entry_filetype(entry) != AE_IFREG) {
      if (candidate)
        candidate->refusal =
            path.string() + " in it is " + (is_link ? "a link" : "not an ordinary file");
    } else {
      contents.files.push_back(path);
      contents.refusal = read_bytes(reader, left, candidate ? &*candidate : nullptr);
      if (!contents.refusal.empty()) return contents;
    }
    if (candidate) contents.taken = std::move(candidate);
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
  return archive_stem(file) != file.filename().string();
}

Result<SubmittedFile> read_from_archive(const fs::path& file, const std::string& name) {
  std::size_t left = kMaxUnpacked;
  return read_from_archive(file, name, left);
}

Result<SubmittedFile> read_from_archive(const fs::path& file, const std::string& name,
                                        std::size_t& left) {
  std::string why;
  const int opened = open_ordinary(file, why);
  if (opened < 0) return archive_refused(file, why);
  const OpenArchive reader(archive_read_new());
  archive_read_support_format_zip(reader.get());
  archive_read_support_format_tar(reader.get());
  archive_read_support_format_7zip(reader.get());
  archive_read_support_format_rar(reader.get());
  archive_read_support_format_rar5(reader.get());
  archive_read_support_filter_gzip(reader.get());
  archive_read_support_filter_bzip2(reader.get());
  archive_read_support_filter_xz(reader.get());
  archive_read_support_filter_zstd(reader.get());
  Contents contents;
  if (archive_read_open_fd(reader.get(), opened, 65536) == ARCHIVE_OK) {
    contents = read_all(reader.get(), name, left);
  } else {
    contents.refusal = "is damaged, or is not an archive";
  }
  ::close(opened);
  if (!contents.refusal.empty()) return archive_refused(file, contents.refusal);
  if (!contents.taken) return missing_file_error(name, contents.files);
  Candidate& taken = *contents.taken;
  if (!taken.refusal.empty()) return archive_refused(file, taken.refusal);
  contents.wanted.erase(taken.path);
  return SubmittedFile{
      std::move(taken.text),
      note_of_choice(taken.path, {contents.wanted.begin(), contents.wanted.end()}, name)};
}

}  // namespace glassbox::labs::grading
