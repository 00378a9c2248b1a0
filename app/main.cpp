// The glassbox program. Each executable consists of this file and of the command groups (subjects)
// that app/CMakeLists.txt names for it.
#include "app/subjects.h"

int main(int argc, char** argv) {
  using namespace glassbox::app;
  constexpr Subject kSubjects[] = {
      {"bench", kBenchHelp, GLASSBOX_HAS_STUDY ? add_bench_command : nullptr},
      {"study", kStudyHelp, GLASSBOX_HAS_STUDY ? add_study_command : nullptr},
      {"views", kViewsHelp, GLASSBOX_HAS_VIEWS ? add_views_command : nullptr},
      {"lab", kLabHelp, GLASSBOX_HAS_LABS ? add_lab_command : nullptr},
  };
  return run_program(kSubjects, argc, argv);
}
