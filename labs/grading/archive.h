// Reads one text file out of a submission that is an archive; nothing is unpacked.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "labs/grading/submission.h"

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// Whether the name has one of these endings: .zip, .7z, .rar, .tar, .tar.gz, .tgz, .tar.bz2,
// .tar.xz, .tar.zst.
bool is_archive(const std::filesystem::path& file);

// Limits of an archive that is submitted. A lab's folder has 20 files and less than a MiB.
inline constexpr std::size_t kLargestArchive = std::size_t(64) << 20;  // bytes of the file
inline constexpr std::size_t kMaxUnpacked = std::size_t(256) << 20;    // bytes of all its contents
inline constexpr std::size_t kMaxEntries = 10000;

// The file `name`, wherever it is in the archive; if there are several, the one that choose_file.h
// names. Among entries with the same path the last one counts, as when the archive is unpacked. An
// archive is refused if it is above the limits, is encrypted or damaged, has an absolute path or a
// "..", or if the chosen file is a link or larger than kLargestSource. Where there is no such file,
// the error names the files that are there.
Result<SubmittedFile> read_from_archive(const std::filesystem::path& archive,
                                        const std::string& name);

// The same for one of several archives, whose contents may have `left` bytes together in place of
// kMaxUnpacked. What was read is subtracted.
Result<SubmittedFile> read_from_archive(const std::filesystem::path& archive,
                                        const std::string& name, std::size_t& left);

}  // namespace glassbox::labs::grading
