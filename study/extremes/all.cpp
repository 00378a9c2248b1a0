#include "study/extremes/common/extreme_case.h"

namespace glassbox::study {

#define ENTRY(name) ExtremeCase name();
// has ENTRY(c01_up_along_gaze) and so on, one for each file in cases/ (CMakeLists.txt)
#include <extreme_cases.inc>
#undef ENTRY

const std::vector<ExtremeCase>& extreme_cases() {
  static const std::vector<ExtremeCase> all{
#define ENTRY(name) name(),
#include <extreme_cases.inc>
#undef ENTRY
  };
  return all;
}

const std::vector<OmittedCase>& omitted_cases() {
  static const std::vector<OmittedCase> all{
      {"C-116", "Pixels and vertices that are not numbers",
       "the loaders refuse such files and say where the number is (tests/mesh, tests/images), so "
       "no later stage gets it"},
  };
  return all;
}

}  // namespace glassbox::study
