// Two pictures made comparable: without alpha where only one has it and it is opaque, and on one
// canvas where their sizes differ.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/compare/pixels/canvas.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

struct PreparedPair {
  StoredImage reference, test;
  OpaqueAlpha opaque_alpha = OpaqueAlpha::kNone;
  std::optional<Canvas> canvas;  // none where the sizes are the same
  // Sentences about different sizes, channels or formats, from explain_format_mismatch.
  std::vector<std::string> mismatch;
  // The kinds of all pixels, if the comparison set some aside; otherwise empty.
  std::vector<PixelKind> kinds;
  // Whether the pictures have the same size, channels and format.
  bool is_comparable() const;
};

// Makes the pictures comparable, if it can: not if they differ in more than an opaque alpha and
// their sizes.
PreparedPair prepare_pair(StoredImage reference, StoredImage test, const CompareOptions& options);

// Whether the picture has the size, channels and format of the one that was compared.
bool is_the_picture(const StoredImage& image, const PictureFacts& facts);

// The two pictures of a comparison, prepared as it did: those that it kept; otherwise they are read
// again. An error if a file cannot be read, or has another size, other channels or another format
// by now.
Result<std::shared_ptr<const PreparedPair>> pixels_of(const Comparison& comparison);

// The pixels of the prepared pair that a comparison used.
Result<Selection> selection_of(const PreparedPair& pair, const Comparison& comparison);

// The pair as the comparison looks at it. It refers to `pair` and to `selection`.
PicturePair picture_pair(const PreparedPair& pair, const Selection& selection,
                         const Comparison& comparison);

}  // namespace glassbox
