#include "labs/framework/lab.h"

namespace glassbox::labs {

#define ENTRY(number) Lab lab_##number();
#include <labs.inc>  // ENTRY(01) and so on, for each folder (CMakeLists.txt)
#undef ENTRY

const std::vector<Lab>& all_labs() {
  static const std::vector<Lab> all{
#define ENTRY(number) lab_##number(),
#include <labs.inc>
#undef ENTRY
  };
  return all;
}

}  // namespace glassbox::labs
