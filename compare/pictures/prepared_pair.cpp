#include <glassbox/compare/pictures/prepared_pair.h>

#include <utility>

#include <glassbox/compare/pixels/alpha.h>
#include <glassbox/compare/pixels/explanation.h>

namespace glassbox {
namespace {

// Which picture has an alpha channel that says nothing, and that the other one does not have.
OpaqueAlpha opaque_alpha_of(const StoredImage& reference, const StoredImage& test) {
  if (reference.channels == test.channels + 1 && is_opaque(reference)) {
    return OpaqueAlpha::kReference;
  }
  if (test.channels == reference.channels + 1 && is_opaque(test)) return OpaqueAlpha::kTest;
  return OpaqueAlpha::kNone;
}

void drop_opaque_alpha(PreparedPair& pair) {
  if (pair.opaque_alpha == OpaqueAlpha::kReference) pair.reference = without_alpha(pair.reference);
  if (pair.opaque_alpha == OpaqueAlpha::kTest) pair.test = without_alpha(pair.test);
}

void lay_on_canvas(PreparedPair& pair) {
  if (!pair.canvas) return;
  pair.reference = on_canvas(std::move(pair.reference), *pair.canvas, pair.canvas->reference);
  pair.test = on_canvas(std::move(pair.test), *pair.canvas, pair.canvas->test);
}

bool has_same_samples(const StoredImage& a, const StoredImage& b) {
  return a.channels == b.channels && a.samples.index() == b.samples.index();
}

}  // namespace

bool PreparedPair::is_comparable() const {
  return reference.width == test.width && reference.height == test.height &&
         has_same_samples(reference, test);
}

PreparedPair prepare_pair(StoredImage reference, StoredImage test, const CompareOptions& options) {
  PreparedPair pair{std::move(reference), std::move(test), OpaqueAlpha::kNone, {}, {}, {}};
  if (options.alpha == AlphaRule::kLenient) {
    pair.opaque_alpha = opaque_alpha_of(pair.reference, pair.test);
    drop_opaque_alpha(pair);
  }
  pair.mismatch = explain_format_mismatch(pair.reference, pair.test);
  if (!pair.is_comparable() && has_same_samples(pair.reference, pair.test)) {
    pair.canvas = place_on_canvas(pair.reference, pair.test, options.alignment);
    lay_on_canvas(pair);
  }
  return pair;
}

bool is_the_picture(const StoredImage& image, const PictureFacts& facts) {
  return image.width == facts.width && image.height == facts.height &&
         channel_names(image) == facts.channels && format_name(image) == facts.format;
}

Result<std::shared_ptr<const PreparedPair>> pixels_of(const Comparison& comparison) {
  if (comparison.pixels) return comparison.pixels;
  auto reference = read_stored(comparison.reference.path);
  if (!reference) return tl::unexpected(reference.error());
  auto test = read_stored(comparison.test.path);
  if (!test) return tl::unexpected(test.error());
  PreparedPair pair{
      *std::move(reference), *std::move(test), comparison.opaque_alpha, comparison.canvas, {}, {}};
  if (!is_the_picture(pair.reference, comparison.reference) ||
      !is_the_picture(pair.test, comparison.test)) {
    return fail(comparison.name, "a file has changed since it was compared", "compare again");
  }
  drop_opaque_alpha(pair);
  lay_on_canvas(pair);
  return std::make_shared<const PreparedPair>(std::move(pair));
}

Result<Selection> selection_of(const PreparedPair& pair, const Comparison& comparison) {
  if (!pair.canvas) return selection_of(pair.reference, comparison.ignore, comparison.mask);
  const StoredImage frame{
      pair.canvas->reference.width, pair.canvas->reference.height, pair.reference.channels, {}};
  const auto own = selection_of(frame, comparison.ignore, comparison.mask);
  if (!own) return tl::unexpected(own.error());
  Selection selection = on_canvas(*own, *pair.canvas);
  if (selection.compared_pixels() == 0) {
    return fail("", "every pixel that both pictures have is left out, so nothing is compared",
                "make --ignore or --mask smaller");
  }
  return selection;
}

PicturePair picture_pair(const PreparedPair& pair, const Selection& selection,
                         const Comparison& comparison) {
  return {pair.reference,       pair.test, selection, comparison.nan_equals_nan,
          comparison.set_aside, pair.kinds};
}

}  // namespace glassbox
