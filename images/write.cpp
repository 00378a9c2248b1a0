#include <glassbox/images/write.h>

#include <glassbox/base/ascii_case.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/palette.h>

namespace glassbox {
namespace {

// The extension in lower case, so that ".PNG" and ".png" are equal; empty where the file name has
// none.
std::string lower_case_extension(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  const std::size_t slash = path.rfind('/');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  return lower_case(path.substr(dot));
}

bool is_ppm_path(const std::string& path) {
  return lower_case_extension(path) == ".ppm";
}

// As encode_png of a palette, with the same errors.
Result<std::vector<std::byte>> encode_coloured_ppm(const Image<std::uint8_t>& indices,
                                                   std::span<const Rgba8> palette) {
  if (const auto whole = check_palette(indices, palette); !whole) {
    return tl::unexpected<Error>(whole.error());
  }
  return encode_ppm(coloured(indices, palette));
}

Result<void> write_encoded(const std::string& path, Result<std::vector<std::byte>> bytes) {
  if (bytes) return write_file(path, *bytes);
  bytes.error().file = path;
  return tl::unexpected<Error>(bytes.error());
}

}  // namespace

Result<void> check_image_path(const std::string& path) {
  const std::string extension = lower_case_extension(path);
  if (extension == ".png" || extension == ".ppm") return {};
  return tl::unexpected<Error>(Error{path,
                                     {},
                                     extension.empty()
                                         ? "an image file needs an extension"
                                         : "unknown image format \"" + extension + "\"",
                                     "end the name in .png or .ppm"});
}

Result<void> write_image(const std::string& path, const Image<Rgba8>& image,
                         std::span<const TextEntry> text) {
  if (auto known = check_image_path(path); !known) return known;
  if (is_ppm_path(path)) return write_file(path, encode_ppm(image));
  return write_encoded(path, encode_png(image, text));
}

Result<void> write_image(const std::string& path, const Image<std::uint8_t>& indices,
                         std::span<const Rgba8> palette) {
  if (auto known = check_image_path(path); !known) return known;
  return write_encoded(path, is_ppm_path(path) ? encode_coloured_ppm(indices, palette)
                                               : encode_png(indices, palette));
}

}  // namespace glassbox
