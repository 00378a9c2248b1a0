#include "study/stiffness/kinds.h"

#include <array>
#include <cstddef>

namespace glassbox::study {

namespace {

struct Texts {
  const char *key, *name, *unit, *formula, *source, *advice;
};

// The texts are in the order of StiffKind.
constexpr std::array<Texts, 7> kTexts{{
    {"far-over-near", "far over near", "of distance",
     "s/(1 - s), s = z (f - n)/(f n) dd; dd of vertices, 8 u d, half a step of the format",
     "SPEC C, generic bound 8; C-10, C-56",
     "move the near plane away from the eye (--near), or store reversed depth (--depth d32r)"},
    {"range-of-w", "farthest over nearest seen", "of 1/w",
     "7 u and the vertices' own; weights and attributes inherit it",
     "SPEC C, generic bound 5; C-33, C-66",
     "split large triangles that reach from beside the eye to the distance, or move the near plane "
     "away from the eye (--near)"},
    {"divide", "transform and divide", "px",
     "(W/2)(dx + |x/w| dw)/(w - dw) + 2 u (|W/2 x| + |c|), dx = gamma_4 |M||p|",
     "SPEC C, generic bounds 1 to 3; C-13",
     "keep meshes near their own origins, and what is drawn away from the plane of the eye"},
    {"offset-over-size", "offset over size", "px",
     "(W/2)(|M_x| + |x/w| |M_w|) dp/(w - |M_w| dp), dp half a unit in the last place of p",
     "SPEC C-13, C-14",
     "the file's coordinates are rounded that far: write them relative to a point near the mesh, "
     "and put the offset into the node"},
    {"sliver", "sliver, longest side over height", "of range",
     "d/(h - 2 d), h the height on the screen, d = sqrt 2 (1/512 px and the vertex's own)",
     "SPEC C, generic bound 5; C-47",
     "colours within that triangle may be those of its other end; where it matters, remesh it, or "
     "draw more pixels (--size)"},
    {"texture-coordinates", "largest texture coordinate", "texels",
     "half a unit in the last place of u, times the side in texels", "SPEC C-67",
     "subtract whole repeats from the texture coordinates of each face"},
    {"up", "1/sine of the angle to up", "px",
     "3 (8 + 4/sine) 2^-53 F (1 + (d/F)^2), at the picture's corners", "SPEC C-01",
     "give an --up that is further from the gaze"},
}};

}  // namespace

StiffNumber number_of(StiffKind kind) {
  const Texts& texts = kTexts[std::size_t(kind)];
  StiffNumber number;
  number.key = texts.key;
  number.name = texts.name;
  number.unit = texts.unit;
  number.formula = texts.formula;
  number.source = texts.source;
  number.advice = texts.advice;
  return number;
}

}  // namespace glassbox::study
