#include "labs/labs.h"

namespace glassbox::labs {

const std::vector<Lab>& all_labs() {
  static const std::vector<Lab> all{lab_01(), lab_02(), lab_03(), lab_04(), lab_05(),
                                    lab_06(), lab_07(), lab_08(), lab_09()};
  return all;
}

}  // namespace glassbox::labs
