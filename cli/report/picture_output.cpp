#include "cli/report/picture_output.h"

#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <span>
#include <system_error>
#include <vector>

#include <glassbox/html/blob.h>
#include <glassbox/images/write.h>

namespace glassbox {

namespace {

namespace fs = std::filesystem;

Result<void> check_stream() {
  if (::isatty(STDOUT_FILENO) != 1) return {};
  return fail("-o -", "standard output is a terminal, which cannot show a picture",
              "redirect standard output: > picture.png, or | another program");
}

Result<void> write_stream(std::span<const std::byte> bytes) {
  const bool all = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
  if (all && std::fflush(stdout) == 0) return {};
  return fail("standard output", "cannot be written: " + std::string(std::strerror(errno)),
              "free some space, or write it elsewhere");
}

Result<void> check_file(const std::string& output, const std::string& usual) {
  std::error_code ignored;
  if (output.ends_with('/') || fs::is_directory(output, ignored)) {
    return tl::unexpected(Error{output, "", "is a directory",
                                "name a file in it: " + (fs::path(output) / usual).string()});
  }
  return check_image_path(output);
}

}  // namespace

Result<void> check_picture_output(const std::string& output,
                                  const std::optional<StreamFormat>& format,
                                  const std::string& usual) {
  if (output == "-") return check_stream();
  if (format) {
    return fail("--format", "the extension of the output file already gives the format",
                "leave this option out, or give -o -");
  }
  return check_file(output, usual);
}

Result<void> write_picture(const std::string& output, const std::optional<StreamFormat>& format,
                           const Image<Rgba8>& image, std::span<const TextEntry> text) {
  if (output != "-") return write_image(output, image, text);
  if (format == StreamFormat::kPpm) return write_stream(encode_ppm(image));
  return encode_png(image, text).and_then([](const std::vector<std::byte>& bytes) {
    return write_stream(bytes);
  });
}

Result<std::string> picture_uri(const Image<Rgba8>& image) {
  return encode_png(image).map([](const std::vector<std::byte>& png) {
    const auto* first = reinterpret_cast<const std::uint8_t*>(png.data());
    return "data:image/png;base64," + base64(std::span(first, png.size()));
  });
}

}  // namespace glassbox
