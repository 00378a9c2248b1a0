// What the bare program does: the teapot, what its stages did, and what to try next.
#pragma once

namespace glassbox::app {

// Draws teapot.png where the user stands. The exit code.
//
// Of the program's sources it needs only those that each folder lists as FIRST, so that a first build shows its picture long
// before all of it is there.
int draw_first_picture();

}  // namespace glassbox::app
