// Reads one text file out of a submission that is an archive; nothing is unpacked.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// Whether the name has one of these endings: .zip, .7z, .tar, .tar.gz, .tgz, .tar.bz2, .tar.xz,
// .tar.zst.
bool is_archive(const std::filesystem::path& file);

// Limits of an archive that is submitted. A lab's folder has 20 files and less than a MiB.
inline constexpr std::size_t kLargestArchive = std::size_t(64) << 20;  // bytes of the file
inline constexpr std::size_t kMaxUnpacked = std::size_t(256) << 20;    // bytes of all its contents
inline constexpr std::size_t kMaxEntries = 10000;

// The text of the file `name` at the top of the archive, or in the only folder there. An archive is
// refused if it is above the limits, is encrypted or damaged, has an absolute path or a "..", or if
// its file of that name is a link or larger than kLargestSource. Where there is no such file, the
// error names the files that are there.
Result<std::string> read_from_archive(const std::filesystem::path& archive,
                                      const std::string& name);

}  // namespace glassbox::labs::grading
