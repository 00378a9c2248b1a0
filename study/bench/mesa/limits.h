// What the OpenGL peer does not draw as Glassbox does.
#pragma once

#include <optional>
#include <string>

#include "study/scenes/scenes.h"

namespace glassbox::study {

// Why the scene's picture is not the peer's, as the end of a sentence; absent where it should be.
std::optional<std::string> peer_cannot_draw(const BenchScene& bench);

}  // namespace glassbox::study
