// labs_for_students LABS TO: copies the labs as students get them (student_version.h). It is the
// first step in the build of the program for students.
#include <cstdio>

#include "labs/framework/student_version.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: labs_for_students LABS TO\n", stderr);
    return 2;
  }
  const auto copied = glassbox::labs::copy_for_students(argv[1], argv[2]);
  if (!copied) std::fprintf(stderr, "labs_for_students: %s\n", copied.error().message().c_str());
  return copied ? 0 : 2;
}
