// Whether this program is a students' (GLASSBOX_STUDENT): there is nothing hidden in it, and nothing grades or hands out.
#pragma once

namespace glassbox::app {

#ifdef GLASSBOX_STUDENT
inline constexpr bool kForStudents = true;
#else
inline constexpr bool kForStudents = false;
#endif

}  // namespace glassbox::app
