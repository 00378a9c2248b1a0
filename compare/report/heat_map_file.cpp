#include <glassbox/compare/report/heat_map_file.h>

#include <glassbox/compare/metrics/flip.h>
#include <glassbox/compare/pictures/prepared_pair.h>
#include <glassbox/compare/pixels/heat_map.h>
#include <glassbox/images/write.h>

namespace glassbox {

Result<Image<std::uint8_t>> heat_levels(const Comparison& comparison, HeatMapKind of) {
  if (!comparison.differences) {
    return fail(comparison.name, "the two pictures cannot be compared pixel by pixel",
                "give both the same channels and format");
  }
  const auto pixels = pixels_of(comparison);
  if (!pixels) return tl::unexpected(pixels.error());
  const auto selection = selection_of(**pixels, comparison);
  if (!selection) return tl::unexpected(selection.error());
  const PicturePair pair = picture_pair(**pixels, *selection, comparison);
  if (of == HeatMapKind::kSteps) return heat_map(pair);
  if (std::holds_alternative<std::vector<float>>(pair.reference.samples)) {
    return fail(comparison.name, "FLIP is not defined for pictures of floats",
                "leave --heat flip out");
  }
  return flip_heat_map(pair);
}

Result<void> write_heat_map(const std::string& path, const Comparison& comparison, HeatMapKind of) {
  const auto levels = heat_levels(comparison, of);
  if (!levels) return tl::unexpected(levels.error());
  return write_image(path, *levels, heat_colours());
}

}  // namespace glassbox
