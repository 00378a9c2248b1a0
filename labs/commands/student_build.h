// Whether this program is built for students (GLASSBOX_STUDENT): it then contains no hidden checks,
// and no commands that grade labs or hand them out.
#pragma once

namespace glassbox::labs {

#ifdef GLASSBOX_STUDENT
inline constexpr bool kStudentBuild = true;
#else
inline constexpr bool kStudentBuild = false;
#endif

}  // namespace glassbox::labs
