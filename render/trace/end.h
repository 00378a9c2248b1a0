// Where triangles end: in the picture, or at the stage that removed them.
#pragma once

#include <cstddef>
#include <cstdint>

namespace glassbox {

// The possible ends, in the order of the stages.
enum class End : std::uint8_t {
  kNoArea,          // assembly: no area as modelled
  kNotFinite,       // vertices: a corner overflows on the way to clip space
  kBehindEye,       // clip: every w is 0 or less
  kOutsidePlane,    // clip: all corners are outside one plane
  kClippedAway,     // clip: several planes together leave nothing
  kNoScreenArea,    // setup: no area after snapping
  kTurnedAway,      // cull
  kOutsidePicture,  // coverage: outside the picture, within the guard band
  kBetweenCentres,  // coverage: no pixel's centre is covered
  kHidden,          // depth test: no fragment passes
  kDiscarded,       // alpha below the material's cutoff
  kMasked,          // the colour mask lets nothing through
  kOverwritten,     // written, then written over
  kUnchanged,       // the visible fragments leave the bytes as they were
  kPartlyVisible,   // some fragments are visible
  kVisible,         // all fragments are visible
  kLines,           // the run draws edges, not insides
};
inline constexpr std::size_t kEnds = std::size_t(End::kLines) + 1;

// The name of the stage that decides, such as "clip".
constexpr const char* stage_of(End end) {
  constexpr const char* kStages[kEnds] = {
      "assembly", "vertices", "clip",     "clip",       "clip",       "setup",
      "cull",     "coverage", "coverage", "depth test", "alpha test", "write",
      "write",    "write",    "write",    "write",      "wireframe"};
  return kStages[std::size_t(end)];
}

// A stable name for programs.
constexpr const char* name_of(End end) {
  constexpr const char* kNames[kEnds] = {
      "no-area",        "not-finite",  "behind-eye",      "outside-plane",   "clipped-away",
      "no-screen-area", "turned-away", "outside-picture", "between-centres", "hidden",
      "discarded",      "masked",      "overwritten",     "unchanged",       "partly-visible",
      "visible",        "lines"};
  return kNames[std::size_t(end)];
}

// Whether something of it is seen (for lines: may be seen).
constexpr bool is_seen(End end) {
  return end >= End::kPartlyVisible;
}

}  // namespace glassbox
