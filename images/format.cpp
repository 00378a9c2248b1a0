#include <glassbox/images/format.h>

#include <algorithm>
#include <cctype>
#include <string>

namespace glassbox {
namespace {

using namespace std::string_view_literals;

struct Signature {
  PictureFormat format;
  std::string_view name;
  std::string_view start;
  // What follows at byte `then_at`; empty where the start alone is enough.
  std::string_view then = ""sv;
  std::size_t then_at = 0;
};

using enum PictureFormat;

constexpr Signature kSignatures[] = {
    {kPng, "PNG", "\x89PNG\r\n\x1a\n"},
    {kJpeg, "JPEG", "\xff\xd8"},
    {kBmp, "BMP", "BM"},
    {kPnm, "PBM", "P1"},
    {kPnm, "PGM", "P2"},
    {kPnm, "PPM", "P3"},
    {kPnm, "PBM", "P4"},
    {kPnm, "PGM", "P5"},
    {kPnm, "PPM", "P6"},
    {kPnm, "PAM", "P7"},
    {kPfm, "PFM", "Pf"},
    {kPfm, "PFM", "PF"},
    {kHdr, "Radiance HDR", "#?RADIANCE"},
    {kHdr, "Radiance HDR", "#?RGBE"},
    {kExr, "OpenEXR", "\x76\x2f\x31\x01"},
    {kNotRead, "GIF", "GIF87a"},
    {kNotRead, "GIF", "GIF89a"},
    {kNotRead, "TIFF", "II*\0"sv},
    {kNotRead, "TIFF", "MM\0*"sv},
    {kNotRead, "BigTIFF", "II+\0"sv},
    {kNotRead, "BigTIFF", "MM\0+"sv},
    {kNotRead, "WebP", "RIFF", "WEBP", 8},
    {kNotRead, "JPEG 2000", "\0\0\0\x0cjP  "sv},
    {kNotRead, "JPEG 2000", "\xff\x4f\xff\x51"},
    {kNotRead, "JPEG XL", "\0\0\0\x0cJXL "sv},
    {kNotRead, "JPEG XL", "\xff\x0a"},
    {kNotRead, "AVIF", "\0\0\0"sv, "ftypavi", 4},
    {kNotRead, "HEIF", "\0\0\0"sv, "ftyphe", 4},
    {kNotRead, "HEIF", "\0\0\0"sv, "ftypmi", 4},
    {kNotRead, "Photoshop", "8BPS"},
    {kNotRead, "DDS", "DDS \x7c"},
    {kNotRead, "KTX", "\xabKTX "},
    {kNotRead, "QOI", "qoif"},
};

constexpr std::string_view kExtensions[] = {
    // read
    ".png", ".apng", ".jpg", ".jpeg", ".bmp", ".tga", ".ppm", ".pgm", ".pbm", ".pnm", ".pam",
    ".pfm", ".hdr", ".exr",
    // known by name
    ".gif", ".tif", ".tiff", ".webp", ".jp2", ".j2k", ".jxl", ".avif", ".heic", ".heif", ".psd",
    ".dds", ".ktx", ".ktx2", ".qoi"};

bool has_at(std::string_view bytes, std::size_t at, std::string_view part) {
  return at <= bytes.size() && bytes.substr(at).starts_with(part);
}

}  // namespace

std::optional<NamedFormat> picture_format_of(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()),
                              std::min(bytes.size(), kFormatBytes));
  for (const Signature& one : kSignatures) {
    if (has_at(text, 0, one.start) && has_at(text, one.then_at, one.then)) {
      return NamedFormat{one.format, one.name};
    }
  }
  return std::nullopt;
}

tl::unexpected<Error> refuse_format(const NamedFormat& format) {
  return fail("", "is a " + std::string(format.name) + " picture, which is not read",
              "convert it to PNG, for example with ImageMagick");
}

tl::unexpected<Error> refuse_unknown() {
  return fail("",
              "not a PNG, JPEG, BMP, TGA, PBM, PGM, PPM, PAM, PFM, Radiance HDR or OpenEXR image",
              "convert it to PNG");
}

bool is_picture_extension(std::string_view extension) {
  std::string lower(extension);
  for (char& c : lower) c = char(std::tolower(static_cast<unsigned char>(c)));
  return std::ranges::find(kExtensions, lower) != std::end(kExtensions);
}

}  // namespace glassbox
