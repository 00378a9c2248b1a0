#include "views/glyphs/glyph_code.h"

namespace glassbox::views {

// The inner colour is one of six, the middle one of the five others, the outer one of the remaining
// four.
GlyphCode code_of(int identity) {
  const int inner = identity / 20, second = identity / 4 % 5, third = identity % 4;
  const auto next = [](int place, auto is_taken) {
    for (int color = 0;; ++color) {
      if (is_taken(color)) continue;
      if (place-- == 0) return color;
    }
  };
  const int middle = next(second, [&](int color) { return color == inner; });
  const int outer = next(third, [&](int color) { return color == inner || color == middle; });
  return {inner, middle, outer};
}

std::optional<int> identity_of(const GlyphCode& code) {
  const auto [inner, middle, outer] = code;
  for (const int color : code) {
    if (color < 0 || color >= kPrototypes) return std::nullopt;
  }
  if (inner == middle || inner == outer || middle == outer) return std::nullopt;
  const int second = middle - (inner < middle);
  const int third = outer - (inner < outer) - (middle < outer);
  return 20 * inner + 4 * second + third;
}

}  // namespace glassbox::views
