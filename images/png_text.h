// The text that a PNG carries beside its samples.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/write.h>

namespace glassbox {

inline constexpr std::size_t kMaxTextEntries = 64;
inline constexpr std::size_t kMaxTextBytes = 65536;  // of one text, as the file has it

// The entries of the tEXt chunks (Latin-1, made UTF-8) and of the uncompressed iTXt chunks, in the file's order: valid
// UTF-8 without zero bytes, and otherwise as hostile as the file. Left out are compressed ones (a kilobyte may become a
// megabyte), longer ones, ones that are not what the format says, and all after the first kMaxTextEntries. Empty for a
// file that is no PNG. An error where a chunk runs past the end or the check sum of a text is wrong. No other chunk is
// looked into, so the cost does not depend on the picture.
Result<std::vector<TextEntry>> read_png_text(std::span<const std::byte> bytes);

}  // namespace glassbox
