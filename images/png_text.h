// The text that a PNG file stores beside its samples.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/write.h>

namespace glassbox {

inline constexpr std::size_t kMaxTextEntries = 64;
// The size of one text, as stored in the file.
inline constexpr std::size_t kMaxTextBytes = 65536;

// Returns the entries of the tEXt chunks (Latin-1, converted to UTF-8) and of the uncompressed iTXt
// chunks, in the file's order. They are valid UTF-8 without zero bytes, but otherwise their content
// may be hostile. These entries are left out: compressed entries (a kilobyte may become a
// megabyte), entries longer than kMaxTextBytes, entries that do not follow the format, and all
// after the first kMaxTextEntries. The result is empty for a file that is not a PNG. It is an error
// if a chunk runs past the end or the checksum of a text is wrong. Other chunks are not read, so
// the cost does not depend on the picture.
Result<std::vector<TextEntry>> read_png_text(std::span<const std::byte> bytes);

}  // namespace glassbox
