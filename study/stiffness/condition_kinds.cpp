#include "study/stiffness/condition_kinds.h"

#include <array>
#include <cstddef>

namespace glassbox::study {

namespace {

struct Texts {
  const char *key, *name, *unit, *formula, *source, *advice;
};

// The texts are in the order of ConditionKind.
constexpr std::array<Texts, 7> kTexts{{
    {"far-over-near", "far over near", "of distance",
     "s/(1 - s), s = z (f - n)/(f n) dd; dd = error of vertices + 8 u d + half a step",
     "bound 8 in docs/references.md (distance from a depth); extreme depths (C-10, C-56)",
     "move the near plane away from the eye (--near), or store reversed depth (--depth d32r)"},
    {"range-of-w", "farthest over nearest seen", "of 1/w",
     "7 u and the error of the vertices; weights and attributes inherit it",
     "bound 5 in docs/references.md (attributes); extreme cases of w (C-33, C-66)",
     "split large triangles that reach from near the eye to far away, or move the near plane away "
     "from the eye (--near)"},
    {"divide", "transform and divide", "px",
     "(W/2)(dx + |x/w| dw)/(w - dw) + 2 u (|W/2 x| + |c|), dx = gamma_4 |M||p|",
     "bounds 1 to 3 in docs/references.md (transform, divide, viewport); object far from the "
     "origin (C-13)",
     "keep meshes near their own origins, and move drawn vertices away from the plane through the "
     "eye"},
    {"offset-over-size", "offset over size", "px",
     "(W/2)(|M_x| + |x/w| |M_w|) dp/(w - |M_w| dp), dp half a unit in the last place of p",
     "extreme cases far from the origin (C-13, C-14)",
     "rounding the file's coordinates to float moves corners by this much: write coordinates "
     "relative to a point near the mesh, and put the offset into the node"},
    {"sliver", "sliver, longest side over height", "of range",
     "d/(h - 2 d), h the height on the screen, d = sqrt 2 (1/512 px and the vertex's own)",
     "bound 5 in docs/references.md (attributes); extreme case of slivers (C-47)",
     "attributes inside this triangle may be those of its other end; if this matters, remesh it or "
     "draw more pixels (--size)"},
    {"texture-coordinates", "largest texture coordinate", "texels",
     "half a unit in the last place of u, times the side in texels",
     "extreme case of huge texture coordinates (C-67)",
     "subtract a whole number from the texture coordinates of each face"},
    {"up", "1/sine of the angle to up", "px",
     "3 (8 + 4/sine) 2^-53 F (1 + (d/F)^2), at the picture's corners",
     "extreme case of up along the gaze (C-01)",
     "give an --up that makes a larger angle with the gaze"},
}};

}  // namespace

ConditionNumber condition_number_of(ConditionKind kind) {
  const Texts& texts = kTexts[std::size_t(kind)];
  ConditionNumber number;
  number.key = texts.key;
  number.name = texts.name;
  number.unit = texts.unit;
  number.formula = texts.formula;
  number.source = texts.source;
  number.advice = texts.advice;
  return number;
}

}  // namespace glassbox::study
