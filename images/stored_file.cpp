#include <glassbox/images/stored_file.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>

#include <glassbox/base/counted.h>
#include <glassbox/images/byte_order.h>
#include <glassbox/images/exr_read.h>
#include <glassbox/images/format.h>
#include <glassbox/images/orientation.h>
#include <glassbox/images/out_of_memory.h>
#include <glassbox/images/png_chunks.h>
#include <glassbox/images/pnm.h>

namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;

void append(std::vector<std::byte>& bytes, Bytes more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

// The number of frames of an animated PNG, from its acTL chunk, and 1 for a picture that does not
// move (PNG, third edition, 11.3.6).
std::uint32_t frames_of(const PngChunk& control) {
  constexpr std::size_t kTypeBytes = 4, kControlBytes = 8;
  return control.data.size() == kControlBytes ? big_endian_at(control.type_and_data, kTypeBytes)
                                              : 1;
}

// Adds the frames of an animated PNG, with all chunks that they are drawn from.
void add_frames(Bytes bytes, StoredFile& file) {
  static constexpr std::array<std::string_view, 5> kOfFrames{"acTL", "fcTL", "fdAT", "PLTE",
                                                             "tRNS"};
  std::uint32_t frames = 1;
  std::vector<std::byte> chunks;
  for (Bytes rest = png_chunks(bytes); !rest.empty();) {
    const auto chunk = take_png_chunk(rest);
    if (!chunk || chunk->type == "IEND") break;
    if (chunk->type == "acTL") frames = frames_of(*chunk);
    if (std::ranges::find(kOfFrames, chunk->type) != kOfFrames.end()) {
      append(chunks, chunk->type_and_data);
    }
  }
  if (frames <= 1) return;
  file.rest = std::move(chunks);
  file.rest_name = counted(frames - 1, "further frame");
}

// Adds the bytes behind the last sample. White space at the end of a plain file is none.
void add_bytes_behind(Bytes behind, const PnmEnd& end, StoredFile& file) {
  const bool is_blank = std::ranges::all_of(
      behind, [](std::byte byte) { return std::isspace(std::to_integer<int>(byte)) != 0; });
  if (is_blank && !end.has_line_feed_too_many) return;
  append(file.rest, behind);
  file.rest_name = counted(behind.size(), "byte") + " behind it";
  if (end.has_line_feed_too_many) file.notes.push_back(line_feed_text());
}

Result<StoredFile> decode_file(Bytes bytes, const DecodeLimits& limits) {
  StoredFile file;
  const auto format = picture_format_of(bytes);
  if (format && format->format == PictureFormat::kExr) return decode_exr_file(bytes, limits);
  const bool is_pnm_file = format && format->format == PictureFormat::kPnm;
  PnmEnd end;
  auto image = is_pnm_file ? decode_pnm_stored(bytes, limits, &end) : decode_stored(bytes, limits);
  if (!image) return tl::unexpected<Error>(image.error());
  file.image = std::move(*image);
  if (is_pnm_file) add_bytes_behind(bytes.subspan(end.at), end, file);
  if (format && format->format == PictureFormat::kPng) add_frames(bytes, file);
  if (format && format->format == PictureFormat::kJpeg) file.orientation = exif_orientation(bytes);
  return file;
}

}  // namespace

Result<StoredFile> decode_stored_file(Bytes bytes, const DecodeLimits& limits) {
  return unless_out_of_memory([&] { return decode_file(bytes, limits); });
}

}  // namespace glassbox
