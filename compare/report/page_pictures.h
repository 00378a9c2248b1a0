// The pictures that a page shows of a comparison. Files are read again unless the comparison kept
// their pixels.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/compare/pixels/selection.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

struct PagePicture {
  const char* name;  // "reference", "test" or "heat", as the page's script calls it
  std::shared_ptr<const StoredImage> image;
  std::optional<PixelBox> place;  // where the picture lies if its pair is on a canvas
};

// Returns the reference, the test and the levels of the heat map, or those that there are. Nothing
// where the files have changed since they were compared, because the comparison's numbers would be
// those of other pictures.
std::vector<PagePicture> page_pictures(const Comparison& comparison);

}  // namespace glassbox
