// Where `render` writes its picture: to a file, or for "-" to standard output, which must be a pipe
// or a file.
#pragma once

#include <optional>
#include <span>
#include <string>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/images/write.h>

namespace glassbox {

enum class StreamFormat { kPng, kPpm };

// Checks the output before a long run. Errors are: a directory, an extension that no picture format
// has, a terminal, and a format option when the extension gives the format already. `usual` is the
// name that a file in a directory would get.
Result<void> check_picture_output(const std::string& output,
                                  const std::optional<StreamFormat>& format,
                                  const std::string& usual);

// Writes the picture, as PNG if no format is given. A file is written completely or not at all.
Result<void> write_picture(const std::string& output, const std::optional<StreamFormat>& format,
                           const Image<Rgba8>& image, std::span<const TextEntry> text);

// Pictures inside an HTML page.

// The picture as data:image/png;base64,..., whose bytes a browser shows unchanged.
Result<std::string> picture_uri(const Image<Rgba8>& image);

}  // namespace glassbox
