// What the program does without arguments: draws the teapot, reports what the stages did, and says
// what to try next.
#pragma once

namespace glassbox::app {

// Draws teapot.png into the current directory and returns the exit code.
//
// It needs only the sources that each folder's CMakeLists.txt lists as FIRST, so that a first build
// shows its picture long before everything is compiled.
int draw_first_picture();

}  // namespace glassbox::app
