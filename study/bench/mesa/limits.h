// Lists what the OpenGL peer does not draw as Glassbox does.
#pragma once

#include <optional>
#include <string>

#include "study/scenes/scenes.h"

namespace glassbox::study {

// The reason why the peer cannot draw the same picture of the scene, as the end of a sentence;
// absent if it can.
std::optional<std::string> peer_cannot_draw(const BenchScene& bench);

}  // namespace glassbox::study
