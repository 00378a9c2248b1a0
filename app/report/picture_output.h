// Where `render` puts its picture: a file, or "-", standard output, for a pipe.
#pragma once

#include <optional>
#include <span>
#include <string>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/images/write.h>

namespace glassbox::app {

enum class StreamFormat { kPng, kPpm };

// Before a long run: an error for a directory, an extension that is none of a picture, a terminal, and a format asked
// for where the extension says it. `usual` is the name that a file in a directory would have.
Result<void> check_picture_output(const std::string& output,
                                  const std::optional<StreamFormat>& format,
                                  const std::string& usual);

// PNG where no format is given. A file is written wholly or not at all.
Result<void> write_picture(const std::string& output, const std::optional<StreamFormat>& format,
                           const Image<Rgba8>& image, std::span<const TextEntry> text);

}  // namespace glassbox::app
