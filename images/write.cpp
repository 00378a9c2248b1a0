#include <glassbox/images/write.h>

#include <glassbox/base/ascii_case.h>
#include <glassbox/images/atomic_file.h>

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
  if (lower_case_extension(path) == ".ppm") return write_file(path, encode_ppm(image));
  auto bytes = encode_png(image, text);
  if (!bytes) {
    bytes.error().file = path;
    return tl::unexpected<Error>(bytes.error());
  }
  return write_file(path, *bytes);
}

}  // namespace glassbox
