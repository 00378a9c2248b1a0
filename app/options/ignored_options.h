// Options that the picture asked for has no use for.
#pragma once

#include "app/options/picture_options.h"

namespace glassbox::app {

// A note on standard error for each of them: the same words are right for another picture, so they are no error.
void tell_of_ignored(const PictureOptions& picture);

}  // namespace glassbox::app
