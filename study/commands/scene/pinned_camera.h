// The camera that was chosen for a scene as options, so that other levels of the scene are seen by
// the same camera.
#pragma once

#include <string>
#include <vector>

#include "cli/options/picture_options.h"

#include <glassbox/mesh/scene.h>

namespace glassbox::study {

// The picture's options with this camera, instead of the options that chose it.
PictureOptions pinned(PictureOptions picture, const Camera& camera);

// The same as words: the given words without those about the camera, and the pinned camera's.
std::vector<std::string> pinned_words(const PictureOptions& given, const PictureOptions& pinned);

}  // namespace glassbox::study
