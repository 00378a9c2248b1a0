// A submission that is an archive: one text is read out of it, and nothing is unpacked.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// By the end of its name: .zip, .7z, .tar, and .tar.gz, .tgz, .tar.bz2, .tar.xz, .tar.zst.
bool is_archive(const std::filesystem::path& file);

// What an archive may have. A lab's folder has 20 files and less than a MiB.
inline constexpr std::size_t kLargestArchive = std::size_t(64) << 20;  // bytes of the file
inline constexpr std::size_t kMostUnpacked = std::size_t(256) << 20;   // bytes of all that is in it
inline constexpr std::size_t kMostEntries = 10000;

// The text of the file `name` at the top of the archive, or in the only folder there. Refused is an archive above the limits, one
// that is encrypted or damaged, one with an absolute path or a "..", and one whose file of that name is a link or above
// kLargestSource. Where there is none, the error names the files that are there.
Result<std::string> read_from_archive(const std::filesystem::path& archive,
                                      const std::string& name);

}  // namespace glassbox::labs::grading
