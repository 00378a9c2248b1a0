// Where triangles end: in the picture, or at the stage that removed them.
#pragma once

#include <cstddef>
#include <cstdint>

namespace glassbox {

// The possible results, in the order of the stages.
enum class TriangleResult : std::uint8_t {
  kNoArea,          // assembly: no area as modelled
  kNotFinite,       // vertices: a corner overflows on the way to clip space
  kBehindEye,       // clip: every w is 0 or less
  kOutsidePlane,    // clip: all corners are outside one plane
  kClippedAway,     // clip: several planes together leave nothing
  kNoScreenArea,    // setup: no area after snapping
  kTurnedAway,      // cull: it faces the wrong way
  kOutsidePicture,  // coverage: outside the picture, within the guard band
  kBetweenCentres,  // coverage: no pixel's centre is covered
  kHidden,          // depth test: no fragment passes
  kDiscarded,       // alpha test: alpha below the material's cutoff
  kMasked,          // write: the colour mask lets nothing through
  kOverwritten,     // write: written, then written over
  kUnchanged,       // write: the bytes stay as they were
  kPartlyVisible,   // some fragments are visible
  kVisible,         // all fragments are visible
  kLines,           // the run draws edges, not insides
};
inline constexpr std::size_t kTriangleResults = std::size_t(TriangleResult::kLines) + 1;

// Returns the name of the stage that decides, such as "clip".
constexpr const char* stage_of(TriangleResult result) {
  constexpr const char* kStages[kTriangleResults] = {
      "assembly", "vertices", "clip",     "clip",       "clip",       "setup",
      "cull",     "coverage", "coverage", "depth test", "alpha test", "write",
      "write",    "write",    "write",    "write",      "wireframe"};
  return kStages[std::size_t(result)];
}

// Returns a name that stays the same, for programs that read it.
constexpr const char* name_of(TriangleResult result) {
  constexpr const char* kNames[kTriangleResults] = {
      "no-area",        "not-finite",  "behind-eye",      "outside-plane",   "clipped-away",
      "no-screen-area", "turned-away", "outside-picture", "between-centres", "hidden",
      "discarded",      "masked",      "overwritten",     "unchanged",       "partly-visible",
      "visible",        "lines"};
  return kNames[std::size_t(result)];
}

// Whether something of the triangle is seen (for lines: may be seen).
constexpr bool is_seen(TriangleResult result) {
  return result >= TriangleResult::kPartlyVisible;
}

}  // namespace glassbox
