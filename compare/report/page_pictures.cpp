#include <glassbox/compare/report/page_pictures.h>

#include <algorithm>
#include <utility>

#include <glassbox/compare/pictures/prepared_pair.h>
#include <glassbox/compare/pixels/heat_map.h>

namespace glassbox {
namespace {

// Reads the picture again. Returns nothing if it cannot be read or is not the picture that was
// compared.
std::optional<StoredImage> read_again(const PictureFacts& facts) {
  auto image = read_stored(facts.path);
  if (!image) return {};
  const bool changed = image->width != facts.width || image->height != facts.height ||
                       channel_names(*image) != facts.channels ||
                       format_name(*image) != facts.format;
  const bool was_read = facts.width > 0;
  if (was_read && changed) return {};
  return std::move(*image);
}

// Returns the levels of the heat map as a picture; nothing where other pixels differ than at the
// time of the comparison.
std::optional<StoredImage> heat_of(const Comparison& comparison, const PreparedPair& pair) {
  const auto selection = selection_of(pair, comparison);
  if (!selection) return {};
  auto levels = heat_map({pair.reference, pair.test, *selection, comparison.nan_equals_nan,
                          comparison.set_aside, pair.kinds});
  const auto differing = std::count_if(levels.pixels.begin(), levels.pixels.end(), is_heat);
  if (std::uint64_t(differing) != comparison.differences->differing) return {};
  return StoredImage{levels.width, levels.height, 1,
                     std::vector(levels.pixels.begin(), levels.pixels.end())};
}

std::vector<PagePicture> compared_pictures(const Comparison& comparison) {
  const auto pair = pixels_of(comparison);
  auto heat = pair ? heat_of(comparison, **pair) : std::nullopt;
  if (!heat) return {};
  std::optional<PixelBox> of_reference, of_test;
  if (comparison.canvas) {
    of_reference = comparison.canvas->reference;
    of_test = comparison.canvas->test;
  }
  std::vector<PagePicture> pictures;
  pictures.push_back({"reference", (*pair)->reference, of_reference});
  pictures.push_back({"test", (*pair)->test, of_test});
  pictures.push_back({"heat", std::move(*heat), {}});
  return pictures;
}

}  // namespace

std::vector<PagePicture> page_pictures(const Comparison& comparison) {
  if (comparison.differences) return compared_pictures(comparison);
  auto reference = read_again(comparison.reference);
  auto test = read_again(comparison.test);
  if (!comparison.error && (!reference || !test)) return {};
  std::vector<PagePicture> pictures;
  if (reference) pictures.push_back({"reference", std::move(*reference), {}});
  if (test) pictures.push_back({"test", std::move(*test), {}});
  return pictures;
}

}  // namespace glassbox
