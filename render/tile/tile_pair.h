// Both eyes of a stereo pair through the tile engine: render_pair and render_masked_anaglyph in less time.
//
// Same bytes. Vertices are carried to the screen once, and the other eye's get an x of their own; what lighting needs is computed
// once. From the selection of triangles on, each eye goes its own way. StereoRendering::culled is 0: nothing is culled for
// both eyes beforehand.
//
// StereoCulling::kCentre, which may lose triangles, is left to the staged stages.
#pragma once

#include <glassbox/render/stereo/render_pair.h>
#include <glassbox/render/tile/tile_engine.h>

namespace glassbox {

// `prepared` as for TileEngine::render. Memory of `into` is used again.
void render_pair(TileEngine& engine, const Scene& scene, const PreparedScene& prepared,
                 const View& centre, const StereoPair& pair, const StereoSettings& settings,
                 StereoRendering& into);

void render_masked_anaglyph(TileEngine& engine, const Scene& scene, const PreparedScene& prepared,
                            const View& centre, const StereoPair& pair,
                            const StereoSettings& settings, const AnaglyphMasks& masks,
                            StereoRendering& into);

}  // namespace glassbox
