// A scene of thin trees, near and far.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

// 150 firs on textured ground, from 4 to 90 units away from the eye: the kind of scene for which
// stereo works best (vertical edges and thin objects, in front of and behind a stereo window 12
// units away; S0-16). Trunks and crowns are two meshes, each placed 150 times.
Scene make_forest();

}  // namespace glassbox
