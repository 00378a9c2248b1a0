#include <glassbox/compare/report/page_pictures.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <glassbox/compare/pictures/prepared_pair.h>
#include <glassbox/compare/pixels/heat_map.h>

namespace glassbox {
namespace {

// Reads the picture again. Returns null if it cannot be read or is not the picture that was
// compared.
std::shared_ptr<const StoredImage> read_again(const PictureFacts& facts) {
  auto image = read_stored(facts.path);
  if (!image) return {};
  const bool was_read = facts.width > 0;
  if (was_read && !is_the_picture(*image, facts)) return {};
  return std::make_shared<const StoredImage>(*std::move(image));
}

// Returns the levels of the heat map as a picture; null where other pixels differ than at the
// time of the comparison.
std::shared_ptr<const StoredImage> heat_of(const Comparison& comparison, const PreparedPair& pair) {
  const auto selection = selection_of(pair, comparison);
  if (!selection) return {};
  auto levels = heat_map(picture_pair(pair, *selection, comparison));
  const auto differing = std::count_if(levels.pixels.begin(), levels.pixels.end(), is_heat);
  if (std::uint64_t(differing) != comparison.differences->differing) return {};
  return std::make_shared<const StoredImage>(StoredImage{
      levels.width, levels.height, 1, std::vector(levels.pixels.begin(), levels.pixels.end())});
}

std::vector<PagePicture> compared_pictures(const Comparison& comparison) {
  const auto pair = pixels_of(comparison);
  if (!pair) return {};
  const auto heat = heat_of(comparison, **pair);
  if (!heat) return {};
  // They belong to the pair, which lives as long as they do: they are not copied.
  const std::shared_ptr<const StoredImage> reference(*pair, &(*pair)->reference);
  const std::shared_ptr<const StoredImage> test(*pair, &(*pair)->test);
  std::optional<PixelBox> of_reference, of_test;
  if (comparison.canvas) {
    of_reference = comparison.canvas->reference;
    of_test = comparison.canvas->test;
  }
  return {{"reference", reference, of_reference}, {"test", test, of_test}, {"heat", heat, {}}};
}

}  // namespace

std::vector<PagePicture> page_pictures(const Comparison& comparison) {
  if (comparison.differences) return compared_pictures(comparison);
  const auto reference = read_again(comparison.reference);
  const auto test = read_again(comparison.test);
  if (!comparison.error && (!reference || !test)) return {};
  std::vector<PagePicture> pictures;
  if (reference) pictures.push_back({"reference", reference, {}});
  if (test) pictures.push_back({"test", test, {}});
  return pictures;
}

}  // namespace glassbox
