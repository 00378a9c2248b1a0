// The files of golden images: PNG for samples of 8 and 16 bits, PFM for floats. The part `images`
// writes both, too, with libpng, TBB and fmt. These sources need nothing but zlib, and write less.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/compare/testing/picture_view.h>

namespace glassbox::golden {

using Bytes = std::vector<std::uint8_t>;

// Returns what makes it impossible to store the picture in a file of this extension (".png",
// ".pfm"), and what to do about it; empty where nothing does. content_of needs a picture of which
// this is empty.
std::string why_not_stored(const PictureView& picture, const std::string& extension);

// What a picture's file says, before anything is compressed.
struct Content {
  enum Format { kPng, kPfm } format;
  Bytes header;  // the data of PNG's chunk IHDR; the text before the floats of a PFM
  Bytes rows;    // what PNG's chunks IDAT compress; the floats of a PFM
};

// An alpha that is opaque everywhere is left out.
Content content_of(const PictureView& picture, const std::string& extension);

// The file.
Bytes encode(const Content& content);

// Whether the bytes are a file with this content. Files of other programs may store the same
// picture in ways that are not recognised here, such as another filter of PNG. The answer is then
// false.
bool is_stored_in(const Bytes& file, const Content& content);

}  // namespace glassbox::golden
